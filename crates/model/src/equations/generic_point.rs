//! Generic ranks and pivots of matrices: the entries are evaluated at a random point of the field of 2^61 - 1 elements, where each angle is a random point of
//! the unit circle. An expression that is not identically zero vanishes there only with a small probability.
//!
//! Pivots that are found are valid, since a quantity that vanishes identically vanishes at the point
//! too. The computed rank is a lower bound of the true one.

use rustc_hash::FxHashMap;
use symbolic::{Node, Sym};

/// The prime 2^61 - 1.
const PRIME: u64 = (1 << 61) - 1;

fn times(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

fn minus(a: u64, b: u64) -> u64 {
    (a + PRIME - b) % PRIME
}

fn power(base: u64, mut exponent: u64) -> u64 {
    let (mut product, mut square) = (1, base);
    while exponent > 0 {
        if exponent & 1 == 1 {
            product = times(product, square);
        }
        square = times(square, square);
        exponent >>= 1;
    }
    product
}

fn quotient(a: u64, b: u64) -> Option<u64> {
    (b != 0).then(|| times(a, power(b, PRIME - 2)))
}

/// Reproducible pseudorandom numbers (splitmix64).
struct Drawn(u64);

impl Drawn {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) % PRIME
    }
}

/// The values of subexpressions at the point; `None` if a denominator vanishes.
struct Point {
    values: FxHashMap<Sym, Option<u64>>,
    circle: FxHashMap<Sym, Option<(u64, u64)>>,
    drawn: Drawn,
}

impl Point {
    fn new() -> Self {
        Point { values: FxHashMap::default(), circle: FxHashMap::default(), drawn: Drawn(1) }
    }

    /// Evaluates an expression without recursion, its operands first.
    fn value(&mut self, expression: Sym) -> Option<u64> {
        let mut open = vec![expression];
        while let Some(&each) = open.last() {
            let leaf = each.node().is_leaf();
            let missing: Vec<Sym> =
                each.node().children().filter(|child| !leaf && !self.values.contains_key(child)).collect();
            if missing.is_empty() {
                let value = self.of_node(each);
                self.values.insert(each, value);
                open.pop();
            }
            open.extend(missing);
        }
        self.values[&expression]
    }

    fn of_node(&mut self, each: Sym) -> Option<u64> {
        if let Some(known) = self.values.get(&each) {
            return *known;
        }
        let of = |a: &Sym| self.values[a];
        match each.node() {
            Node::Constant(_) => {
                let (numerator, denominator) = each.as_constant()?.to_big()?.into_parts();
                let signed = numerator % (PRIME as i64);
                let below = denominator % PRIME;
                quotient(signed.rem_euclid(PRIME as i64) as u64, below)
            }
            Node::Sum(a, b) => Some((of(&a)? + of(&b)?) % PRIME),
            Node::Difference(a, b) => Some(minus(of(&a)?, of(&b)?)),
            Node::Product(a, b) => Some(times(of(&a)?, of(&b)?)),
            Node::Quotient(a, b) => quotient(of(&a)?, of(&b)?),
            Node::Negation(a) => Some(minus(0, of(&a)?)),
            Node::Power(a, n) => Some(power(of(&a)?, n.into())),
            Node::Cos(a) => self.on_circle(a).map(|(cos, _)| cos),
            Node::Sin(a) => self.on_circle(a).map(|(_, sin)| sin),
            Node::Symbol(_) | Node::Root(_) | Node::Elementary(..) | Node::Function(..) => Some(self.drawn.next()),
        }
    }

    /// Returns a point of the circle that is determined by the value of the angle, so that it is constant if the symbols of the angle are.
    fn on_circle(&mut self, angle: Sym) -> Option<(u64, u64)> {
        if let Some(known) = self.circle.get(&angle) {
            return *known;
        }
        let point = self.value(angle).and_then(|value| {
            let t = Drawn(value).next();
            let square = times(t, t);
            let below = (1 + square) % PRIME;
            Some((quotient(minus(1, square), below)?, quotient((t + t) % PRIME, below)?))
        });
        self.circle.insert(angle, point);
        point
    }
}

/// The dependence of an expression on the symbols that vary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dependence {
    Zero,
    /// Equal values at two points that differ in all varying symbols.
    Constant,
    Varying,
}

/// Determines the dependence of expressions if the symbols `stay` are constant and all other symbols and angles vary.
pub(crate) fn courses(expressions: &[Sym], stay: &[Sym]) -> Vec<Dependence> {
    let [first, second] = [2, 3].map(|seed| {
        let mut point = Point::new();
        for &letter in stay {
            point.value(letter);
        }
        point.drawn = Drawn(seed);
        expressions.iter().map(|&each| point.value(each)).collect::<Vec<_>>()
    });
    let pairs = first.into_iter().zip(second);
    pairs
        .map(|pair| match pair {
            (Some(0), Some(0)) => Dependence::Zero,
            (Some(one), Some(other)) if one == other => Dependence::Constant,
            _ => Dependence::Varying,
        })
        .collect()
}

/// Returns the generic rank of a matrix.
pub fn generic_rank(rows: &[Vec<Sym>]) -> usize {
    let columns = rows.first().map_or(0, Vec::len);
    pivots(rows, &(0..columns).collect::<Vec<_>>()).len()
}

/// Returns whether a row is generically a combination of other rows.
pub(crate) fn depends(row: &[Sym], others: &[Vec<Sym>]) -> bool {
    let all: Vec<Vec<Sym>> = others.iter().cloned().chain([row.to_vec()]).collect();
    generic_rank(&all) == generic_rank(others)
}

/// Returns generic pivots (row, column) of a matrix. Rows are taken in order; each uses the first column of `order` that is possible.
/// A row without a pivot depends on earlier rows.
pub fn pivots(rows: &[Vec<Sym>], order: &[usize]) -> Vec<(usize, usize)> {
    Elimination::of(rows, order).pivots
}

/// Returns, for each row without a generic pivot, the indices of this row and of the earlier rows of which it is a combination.
pub(crate) fn circuits(rows: &[Vec<Sym>], order: &[usize]) -> Vec<Vec<usize>> {
    Elimination::of(rows, order).circuits
}

/// Gaussian elimination at the random point.
struct Elimination {
    /// (row, column) of each pivot.
    pivots: Vec<(usize, usize)>,
    /// For each row without a pivot, the rows of its vanishing combination.
    circuits: Vec<Vec<usize>>,
}

impl Elimination {
    fn of(rows: &[Vec<Sym>], order: &[usize]) -> Self {
        let mut point = Point::new();
        let columns = rows.first().map_or(0, Vec::len);
        // each row is extended by a unit row, which records the combination of rows
        let mut reduced: Vec<Vec<u64>> = Vec::new();
        let (mut pivots, mut circuits) = (Vec::<(usize, usize)>::new(), Vec::new());
        for (row, entries) in rows.iter().enumerate() {
            let own = entries.iter().map(|&entry| point.value(entry).unwrap_or(0));
            let mut values: Vec<u64> = own.chain((0..rows.len()).map(|other| u64::from(other == row))).collect();
            for &(above, column) in &pivots {
                let Some(factor) = quotient(values[column], reduced[above][column]).filter(|factor| *factor != 0)
                else {
                    continue;
                };
                for (value, above) in values.iter_mut().zip(&reduced[above]) {
                    *value = minus(*value, times(factor, *above));
                }
            }
            match order.iter().find(|&&column| values[column] != 0) {
                Some(&column) => pivots.push((row, column)),
                None => circuits.push((0..=row).filter(|other| values[columns + other] != 0).collect()),
            }
            reduced.push(values);
        }
        Elimination { pivots, circuits }
    }
}

#[cfg(test)]
mod tests {
    use super::{Dependence, circuits, courses, generic_rank, pivots};
    use field::{Analytic, Scalar};
    use symbolic::{Sym, apart, symbols};

    /// An entry that is identically zero adds no rank.
    #[test]
    fn identities_of_numbers_powers_and_angles_hold_at_the_point() {
        apart(|| {
            let [x, y] = symbols(["x", "y"]);
            let circle = x.circle();
            let square = circle.cos * circle.cos + circle.sin * circle.sin;
            for zero in [
                square - Sym::ONE,
                (x - y) * (x + y) - x.powi(2) + y.powi(2),
                x.powi(3) - x * x * x,
                x * Sym::int(-3) + x + x + x,
                x * Sym::ratio(-3, 7) + x * Sym::ratio(3, 7),
                x / y - Sym::ONE / (y / x),
            ] {
                assert_eq!(generic_rank(&[vec![zero]]), 0, "{zero}");
                assert_eq!(generic_rank(&[vec![zero + x]]), 1, "{zero} + x");
            }
        });
    }

    #[test]
    fn a_constant_is_one_by_identities_and_of_letters_that_stay() {
        apart(|| {
            let [x, r] = symbols(["x", "r"]);
            let circle = x.circle();
            let square = circle.cos * circle.cos + circle.sin * circle.sin;
            let all = [r * square, square - Sym::ONE, r * x, r, circle.cos, (r + r).circle().sin];
            let found = courses(&all, &[r]).into_iter();
            let known = [
                Dependence::Constant,
                Dependence::Zero,
                Dependence::Varying,
                Dependence::Constant,
                Dependence::Varying,
                Dependence::Constant,
            ];
            assert!(found.eq(known));
        });
    }

    #[test]
    fn a_row_that_depends_on_those_before_it_has_no_pivot() {
        apart(|| {
            let [x, y] = symbols(["x", "y"]);
            let rows =
                [vec![x, y, Sym::ONE], vec![x * y, y * y, y], vec![Sym::ZERO, y, x], vec![x, y + y, Sym::ONE + x]];
            // the second row is y times the first, the last one is the sum of the first and the third
            assert_eq!(pivots(&rows, &[0, 1, 2]), [(0, 0), (2, 1)]);
            assert_eq!(pivots(&rows, &[2, 1, 0]), [(0, 2), (2, 1)]);
            assert_eq!(circuits(&rows, &[0, 1, 2]), [vec![0, 1], vec![0, 2, 3]]);
            assert_eq!(generic_rank(&rows), 2);
        });
    }
}
