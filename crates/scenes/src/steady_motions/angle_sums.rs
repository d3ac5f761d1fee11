//! Sums of angles as the unknowns of a search by interval arithmetic.
//!
//! Relative angles occur in sums, such as the directions of the links of an arm. In a box of angles each sum is evaluated in several equations
//! as if it varied independently, and ranges are overestimated; with sums as unknowns each has one range. Factors between angles and sums are
//! integers in both directions, so that whole turns correspond to whole turns.

use super::Unknown;
use algebra::boxes::Zero;
use field::{Interval, Scalar};
use nalgebra::DMatrix;
use std::f64::consts::PI;
use symbolic::{Node, Sym};

/// A linear combination of unknowns: index and integer factor of each term.
type Sum = Vec<(usize, i32)>;

/// A linear change of unknowns: each angle as a combination of the sums, and each sum as a combination of the angles.
#[derive(Debug)]
pub(super) struct AngleSums {
    unknowns: Vec<Sum>,
    sums: Vec<Sum>,
}

/// Largest accepted factor; larger ones do not arise from chains of links.
const LARGEST: f64 = 64.0;

impl AngleSums {
    /// The identity.
    pub fn none(count: usize) -> Self {
        let own: Vec<Sum> = (0..count).map(|k| vec![(k, 1)]).collect();
        AngleSums { unknowns: own.clone(), sums: own }
    }

    /// The sums that simplify the arguments of sines and cosines in `rows`; `None` if the angles themselves are as simple.
    pub fn of(rows: &[Sym], letters: &[Sym], unknowns: &[Unknown]) -> Option<Self> {
        let places: Vec<usize> = (0..letters.len()).filter(|&k| unknowns[k].is_circle).collect();
        let mut sums: Vec<(Vec<i32>, usize)> = Vec::new();
        for row in rows {
            for sum in Sym::ascending(&[*row]).into_iter().filter_map(|each| sum(each, letters, &places)) {
                match sums.iter_mut().find(|(known, _)| *known == sum) {
                    Some((_, count)) => *count += 1,
                    None => sums.push((sum, 1)),
                }
            }
        }
        let size = |of: &[Vec<i32>]| of.iter().flatten().filter(|factor| **factor != 0).count();
        let plain: Vec<Vec<i32>> = sums.iter().map(|(sum, _)| sum.clone()).collect();
        // sums in most rows first, the shortest among these
        sums.sort_by_key(|(sum, count)| (usize::MAX - count, sum.iter().filter(|factor| **factor != 0).count()));
        let n = places.len();
        let single = (0..n).map(|k| (0..n).map(|j| i32::from(j == k)).collect::<Vec<i32>>());
        let mut chosen: Vec<Vec<i32>> = Vec::new();
        for sum in sums.into_iter().map(|(sum, _)| sum).chain(single) {
            chosen.push(sum);
            if rank(&chosen) < chosen.len() {
                chosen.pop();
            }
        }
        let inverse = inverse(&chosen)?;
        // sum_j f_j theta_j = sum_k (sum_j f_j inverse_jk) psi_k, with the sums psi
        let by_chosen = |sum: &Vec<i32>| (0..n).map(|k| (0..n).map(|j| sum[j] * inverse[j][k]).sum()).collect();
        let simpler: Vec<Vec<i32>> = plain.iter().map(by_chosen).collect();
        if size(&simpler) >= size(&plain) {
            return None;
        }
        let by_places = |rows: &[Vec<i32>]| {
            let mut own: Vec<Sum> = (0..letters.len()).map(|k| vec![(k, 1)]).collect();
            for (row, &place) in rows.iter().zip(&places) {
                own[place] = places.iter().copied().zip(row.iter().copied()).filter(|term| term.1 != 0).collect();
            }
            own
        };
        Some(AngleSums { unknowns: by_places(&inverse), sums: by_places(&chosen) })
    }

    /// Substitutions for the letters of the unknowns: each becomes a combination of the search variables, which have the same letters.
    pub fn replacements(&self, letters: &[Sym]) -> Vec<(Sym, Sym)> {
        let sum = |own: &Sum| {
            own.iter().fold(Sym::ZERO, |sum, &(place, factor)| sum + Sym::int(factor.into()) * letters[place])
        };
        letters.iter().copied().zip(self.unknowns.iter().map(sum)).collect()
    }

    /// The ranges of the unknowns in a box of the search; angles are reduced by whole turns to their range. Further components of the box are
    /// unchanged.
    pub fn unknowns(&self, at: &[Interval], unknowns: &[Unknown]) -> Vec<Interval> {
        let mut all = at.to_vec();
        for (place, (own, unknown)) in self.unknowns.iter().zip(unknowns).enumerate() {
            if own[..] == [(place, 1)] {
                continue;
            }
            let sum = total(own, at);
            let turn = unknown.range.interval();
            let turns = ((turn.middle() - sum.middle()) / (2.0 * PI)).round() * 2.0 * PI;
            let turned = sum + Interval::new(turns.next_down(), turns.next_up());
            all[place] = if turned.width() >= turn.width() { turn } else { turned };
        }
        all
    }

    /// A zero in terms of the unknowns, with a box in which it is unique: the sums of all points of this box lie in the box of uniqueness of the
    /// search.
    pub fn zero(&self, found: &Zero, unknowns: &[Unknown]) -> Zero {
        let enclosure = self.unknowns(&found.enclosure, unknowns);
        let room = |k: usize| {
            let (own, alone) = (found.enclosure[k], found.alone[k]);
            (own.low() - alone.low()).min(alone.high() - own.high()).max(0.0)
        };
        let radius = |place: usize| {
            let with = self.sums.iter().enumerate().filter(|(_, sum)| sum.iter().any(|term| term.0 == place));
            let shares = with.map(|(k, sum)| {
                let size: i32 = sum.iter().map(|term| term.1.abs()).sum();
                // half, since ranges of sums are wider than their enclosures
                0.5 * room(k) / f64::from(size)
            });
            shares.fold(f64::INFINITY, f64::min)
        };
        let wider = |(place, own): (usize, &Interval)| match self.unknowns.get(place) {
            Some(_) => *own + Interval::new(-radius(place), radius(place)),
            None => found.alone[place],
        };
        let alone: Vec<Interval> = enclosure.iter().enumerate().map(wider).collect();
        let is_within = |(sum, alone_there): (&Sum, &Interval)| {
            let range = total(sum, &alone);
            let turns = ((alone_there.middle() - range.middle()) / (2.0 * PI)).round() * 2.0 * PI;
            (range + Interval::new(turns.next_down(), turns.next_up())).is_part_of(*alone_there)
        };
        match self.sums.iter().zip(&found.alone).all(is_within) {
            true => Zero { enclosure, alone },
            false => Zero { alone: enclosure.clone(), enclosure },
        }
    }
}

fn total(sum: &Sum, at: &[Interval]) -> Interval {
    sum.iter().fold(Interval::point(0.0), |all, &(place, factor)| all + Interval::point(f64::from(factor)) * at[place])
}

/// The integer factors of the angles in the argument of a sine or cosine; `None` for other nodes, factors or letters.
fn sum(each: Sym, letters: &[Sym], places: &[usize]) -> Option<Vec<i32>> {
    let (Node::Cos(argument) | Node::Sin(argument)) = each.node() else { return None };
    let mut factors = vec![0; places.len()];
    for (term, factor) in argument.linear_terms() {
        if term.as_constant().is_some() {
            continue;
        }
        let own = places.iter().position(|&place| letters[place] == term)?;
        let factor = factor.to_f64();
        if factor.fract() != 0.0 || factor.abs() > LARGEST {
            return None;
        }
        factors[own] = factor as i32;
    }
    factors.iter().any(|factor| *factor != 0).then_some(factors)
}

fn rank(rows: &[Vec<i32>]) -> usize {
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| f64::from(rows[i][j])).rank(1e-9)
}

/// The inverse of an integer matrix if it is an integer matrix, too.
fn inverse(rows: &[Vec<i32>]) -> Option<Vec<Vec<i32>>> {
    let n = rows.len();
    let found = DMatrix::from_fn(n, n, |i, j| f64::from(rows[i][j])).try_inverse()?;
    let whole = |value: f64| (value.round().abs() <= LARGEST).then(|| value.round() as i32);
    let inverse: Vec<Vec<i32>> =
        (0..n).map(|i| (0..n).map(|j| whole(found[(i, j)])).collect()).collect::<Option<_>>()?;
    let is_one = |i: usize, j: usize| {
        (0..n).map(|k| i64::from(rows[i][k]) * i64::from(inverse[k][j])).sum::<i64>() == i64::from(i == j)
    };
    (0..n * n).all(|place| is_one(place / n, place % n)).then_some(inverse)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::steady_motions::Range;
    use field::Analytic;
    use symbolic::symbols;

    fn circles<const N: usize>(names: [&str; N]) -> Vec<Unknown> {
        let unknown = |(place, name): (usize, &&str)| Unknown {
            name: (*name).to_owned(),
            place,
            is_circle: true,
            range: Range::TURN,
        };
        names.iter().enumerate().map(unknown).collect()
    }

    #[test]
    fn links_turned_against_one_another_are_sought_by_their_directions() {
        let names = ["a", "b", "c"];
        let [a, b, c] = symbols(names);
        let [one, two] = [a + b, a + b + c].map(Sym::circle_as_written);
        let rows = [a.circle().cos + one.cos, one.sin - two.sin];
        let sums = AngleSums::of(&rows, &[a, b, c], &circles(names)).expect("sums are simpler");
        let [alone, first, second] = [0, 1, 2].map(|k| sums.replacements(&[a, b, c])[k].1);
        let directions = [alone, alone + first, alone + first + second];
        assert!(directions.iter().all(|one| one.linear_terms().len() == 1), "{directions:?}");
        // no sums: the angles themselves are simplest
        assert!(AngleSums::of(&[a.circle().cos + b.circle().sin], &[a, b], &circles(["a", "b"])).is_none());
    }

    #[test]
    fn what_is_found_by_sums_is_told_by_the_angles_within_their_turn() {
        let [a, b] = symbols(["a", "b"]);
        // the most frequent sum takes the place of the first angle
        let rows = [(a + b).circle_as_written().cos, (a + b).circle_as_written().sin + a.circle().sin];
        let sums = AngleSums::of(&rows, &[a, b], &circles(["a", "b"])).expect("sums");
        let own = |place: usize| sums.replacements(&[a, b])[place].1;
        let at = [Interval::new(3.0, 3.1), Interval::new(-0.2, 0.0), Interval::new(7.0, 8.0)];
        let found = sums.unknowns(&at, &circles(["a", "b"]));
        assert_eq!(found[2], at[2]);
        for place in [0, 1] {
            let middle = own(place).evaluate(&|name| Some(if name == "a" { 3.05 } else { -0.1 })).expect("numbers");
            let turns = (found[place].middle() - middle) / (2.0 * PI);
            assert!((turns - turns.round()).abs() < 1e-9 && found[place].middle().abs() < 4.0, "{found:?}");
        }
    }
}
