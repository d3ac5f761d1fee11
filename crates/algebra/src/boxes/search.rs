//! The branch-and-prune search, largest boxes first.

use super::existence::shown;
use super::halves::halves;
use super::newton::Local;
use super::signs::{Signs, Worth};
use super::{Equations, subsystem};
use field::Interval;
use std::collections::VecDeque;

/// A zero, unique in a box.
#[derive(Clone, Debug, PartialEq)]
pub struct Zero {
    /// The enclosure of the zero, as narrow as rounding allows.
    pub enclosure: Vec<Interval>,
    /// A box around it without other zeros.
    pub alone: Vec<Interval>,
}

/// The limits of a search.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The largest number of boxes examined.
    pub boxes: usize,
    /// The size, as a fraction of the domain along each unknown, below which a box is not bisected.
    pub smallest: f64,
}

/// The result of a search: every zero in the domain is in `zeros` or in one of the undecided boxes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// The proved zeros; some may lie just outside the domain.
    pub zeros: Vec<Zero>,
    /// Boxes that may contain further zeros.
    pub undecided: Vec<Vec<Interval>>,
    /// The number of boxes examined.
    pub examined: usize,
}

/// A box narrowed to less than this fraction is narrowed again before it is bisected.
pub(super) const WORTH: f64 = 0.75;

/// The number of boxes between two calls of `goes_on`.
const BETWEEN: usize = 16;

/// All zeros in the box `domain` of the first unknowns. The search stops early when `goes_on` returns false.
pub fn zeros(
    equations: &mut dyn Equations,
    domain: &[Interval],
    limits: Limits,
    mut goes_on: impl FnMut() -> bool,
) -> Found {
    let (n, all) = (equations.divided(), equations.divided() + equations.determined());
    // where equations are undefined, narrowing might never end
    let least: Vec<f64> = domain.iter().map(|side| limits.smallest * side.width()).collect();
    let (mut found, mut worth) = (Found::default(), Worth::default());
    let mut first = domain.to_vec();
    first.resize(all, Interval::EVERYTHING);
    let mut open = VecDeque::from([first]);
    while let Some(next) = open.pop_front() {
        if found.examined >= limits.boxes || found.examined.is_multiple_of(BETWEEN) && !goes_on() {
            found.undecided.push(next);
            found.undecided.extend(open);
            break;
        }
        found.examined += 1;
        match examined(equations, next, &mut found.zeros, (&mut worth, &least)) {
            None => {}
            Some(Left::OfSigns(both)) => open.extend(both),
            Some(Left::One(left)) => match halves(&left[..n], domain, None, limits.smallest) {
                Some(halves) => open.extend(halves.map(|half| [&half, &left[n..]].concat())),
                None => found.undecided.push(left),
            },
        }
    }
    // a zero proved later may be the only one in a box that was undecided
    let Found { zeros, undecided, .. } = &mut found;
    let is_part = |at: &[Interval], zero: &Zero| {
        at.len() == zero.alone.len() && at.iter().zip(&zero.alone).all(|(at, alone)| at.is_part_of(*alone))
    };
    undecided.retain(|at| !zeros.iter().any(|zero| is_part(at, zero)));
    undecided.iter_mut().for_each(|at| at.truncate(n));
    found
}

/// The undecided part of a box.
enum Left {
    One(Vec<Interval>),
    /// Two parts, by the sign of a determined unknown.
    OfSigns([Vec<Interval>; 2]),
}

/// The undecided part of a box; `None` where all of it is decided. Adds proved zeros.
fn examined(
    equations: &mut dyn Equations,
    mut at: Vec<Interval>,
    zeros: &mut Vec<Zero>,
    (signs, least): (&mut Worth, &[f64]),
) -> Option<Left> {
    let n = equations.divided();
    let mut values = vec![Interval::EVERYTHING; at.len()];
    loop {
        let before = at[..n].to_vec();
        if !equations.narrow(&mut at) {
            return None;
        }
        match signs.by_signs(equations, &mut at) {
            Signs::None => return None,
            Signs::Both(both) => return Some(Left::OfSigns(both)),
            Signs::One => {}
        }
        let is_narrower = |at: &[Interval]| {
            let narrower = |((left, before), least): ((&Interval, &Interval), &f64)| {
                before.width() > *least && left.width() < WORTH * before.width()
            };
            at.iter().zip(&before).zip(least).any(narrower)
        };
        if !equations.bound(&mut at) {
            at = subsystem::narrowed(equations, &at, n)?;
            if is_narrower(&at) {
                continue;
            }
            return Some(Left::One(at));
        }
        let is_part = |zero: &Zero| at.iter().zip(&zero.alone).all(|(at, alone)| at.is_part_of(*alone));
        if zeros.iter().any(is_part) {
            return None;
        }
        equations.values(&at, &mut values);
        if values.iter().any(|value| !value.contains(0.0)) {
            return None;
        }
        let Some(local) = Local::of(equations, &at) else { return Some(Left::One(at)) };
        at = local.narrowed(&at)?;
        if let Some(zero) = shown(equations, &at) {
            let is_covered = at.iter().zip(&zero.alone).all(|(left, alone)| left.is_part_of(*alone));
            if zeros.iter().all(|known| !is_same(known, &zero)) {
                zeros.push(zero);
            }
            if is_covered {
                return None;
            }
        }
        if !is_narrower(&at) {
            return Some(Left::One(at));
        }
    }
}

/// Whether two zeros are equal: their enclosures overlap, and one lies in the box where the other is unique.
fn is_same(known: &Zero, other: &Zero) -> bool {
    let meets = known.enclosure.iter().zip(&other.enclosure).all(|(a, b)| a.and(*b).is_some());
    let within = |a: &[Interval], b: &[Interval]| a.iter().zip(b).all(|(a, b)| a.is_part_of(*b));
    meets && (within(&other.enclosure, &known.alone) || within(&known.enclosure, &other.alone))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A test system given by interval functions.
    struct Given<const N: usize> {
        values: fn([Interval; N]) -> [Interval; N],
        slopes: fn([Interval; N]) -> [[Interval; N]; N],
    }

    fn all<const N: usize>(at: &[Interval]) -> [Interval; N] {
        std::array::from_fn(|k| at[k])
    }

    impl<const N: usize> Equations for Given<N> {
        fn divided(&self) -> usize {
            N
        }

        fn values(&mut self, at: &[Interval], values: &mut [Interval]) {
            values.copy_from_slice(&(self.values)(all(at)));
        }

        fn slopes(&mut self, at: &[Interval], slopes: &mut [Interval]) {
            slopes.copy_from_slice((self.slopes)(all(at)).as_flattened());
        }
    }

    const LIMITS: Limits = Limits { boxes: 20_000, smallest: 1e-6 };

    fn number(value: f64) -> Interval {
        Interval::point(value)
    }

    fn square(side: f64) -> Vec<Interval> {
        vec![Interval::new(-side, side); 2]
    }

    #[test]
    fn a_circle_and_a_parabola_meet_where_they_do() {
        // x^2 + y^2 = 4, y = x^2 - 1
        let mut given = Given::<2> {
            values: |[x, y]| [x * x + y * y - number(4.0), x * x - number(1.0) - y],
            slopes: |[x, y]| [[number(2.0) * x, number(2.0) * y], [number(2.0) * x, number(-1.0)]],
        };
        let found = zeros(&mut given, &square(3.0), LIMITS, || true);
        assert_eq!((found.zeros.len(), found.undecided.len()), (2, 0), "{found:?}");
        let y = 0.5 * (13f64.sqrt() - 1.0);
        for zero in &found.zeros {
            assert!(zero.enclosure[1].contains(y) || (zero.enclosure[1].middle() - y).abs() < 1e-14);
            assert!(zero.enclosure.iter().all(|part| part.width() < 1e-13));
        }
    }

    #[test]
    fn zeros_on_the_sides_of_halves_are_found_once() {
        // zeros -1, 0 and 1; the midpoint of the box is a zero
        let mut given =
            Given::<1> { values: |[x]| [x * x * x - x], slopes: |[x]| [[number(3.0) * x * x - number(1.0)]] };
        let found = zeros(&mut given, &[Interval::new(-2.0, 2.0)], LIMITS, || true);
        assert_eq!((found.zeros.len(), found.undecided.len()), (3, 0), "{found:?}");
    }

    #[test]
    fn a_zero_at_the_side_of_two_halves_is_decided_where_values_have_rounding() {
        // the midpoint of the box is a zero
        let mut given = Given::<1> {
            values: |[x]| [Interval::new(-3e-16, 1e-16) + x * (number(1.0) - x * x * number(0.015625))],
            slopes: |[x]| [[number(1.0) - number(0.046875) * x * x]],
        };
        let found = zeros(&mut given, &[Interval::new(-10.0, 10.0)], LIMITS, || true);
        assert_eq!((found.zeros.len(), found.undecided.len()), (3, 0), "{found:?}");
    }

    #[test]
    fn a_double_zero_is_left_undecided_in_small_boxes() {
        let mut given = Given::<1> { values: |[x]| [x * x], slopes: |[x]| [[number(2.0) * x]] };
        let found = zeros(&mut given, &[Interval::new(-1.0, 2.0)], LIMITS, || true);
        assert!(found.zeros.is_empty() && !found.undecided.is_empty());
        assert!(found.undecided.iter().all(|at| at[0].size() < 1e-2), "{found:?}");
    }

    #[test]
    fn a_side_that_is_narrowed_without_end_ends() {
        struct Narrowing(usize);
        impl Equations for Narrowing {
            fn divided(&self) -> usize {
                1
            }
            fn narrow(&mut self, at: &mut [Interval]) -> bool {
                self.0 += 1;
                at[0] = Interval::new(0.5 * at[0].low(), 0.5 * at[0].high());
                true
            }
            fn values(&mut self, _: &[Interval], values: &mut [Interval]) {
                values[0] = Interval::EVERYTHING;
            }
            fn slopes(&mut self, _: &[Interval], slopes: &mut [Interval]) {
                slopes[0] = Interval::new(0.5, 1.0);
            }
        }
        let mut narrowing = Narrowing(0);
        let found = zeros(&mut narrowing, &[Interval::new(-1.0, 2.0)], LIMITS, || true);
        assert!(found.zeros.is_empty() && found.undecided.len() == 1, "{found:?}");
        // down to a millionth of the range, and not below
        assert!(narrowing.0 < 60, "{}", narrowing.0);
    }

    #[test]
    fn a_search_without_time_tells_what_it_left() {
        let mut given = Given::<1> { values: |[x]| [x], slopes: |_| [[number(1.0)]] };
        let found = zeros(&mut given, &[Interval::new(-1.0, 2.0)], LIMITS, || false);
        assert_eq!(found.undecided, [[Interval::new(-1.0, 2.0)]]);
    }
}
