//! Identity testing at random points of random prime fields: an expression that vanishes at all of them is zero, up to a computed probability of
//! error (Schwartz 1980; Zippel 1979).
//!
//! Random values: each symbol gets a random value. Each angle gets a random point of the unit circle, by the tangent of its half. Each function gets a random
//! value, as if it were independent of its arguments; an expression that vanishes even then vanishes for the true values. Two angles, or two arguments of a
//! function, count as equal if their values are equal, as for w t and t w. Different arguments have equal values with a small probability, which the error
//! includes. A value that is not zero proves that the expression is not zero only if its angles are linearly independent, since cos (a + b) t depends on
//! the functions of a t and b t.
//!
//! Roots: a root takes both square roots of its argument, and the expression must vanish for all choices of signs. A point at which an argument has no
//! root in the field is replaced by another one. An expression that is not zero has a symmetric function of its conjugates that is not zero. For each root this
//! doubles the degree, and the probability, since all roots must exist. If there are more than four roots, they count as functions.
//!
//! Bounds: the expression is a quotient of polynomials in the random numbers. Its degree d and the number b of bits of its coefficients are bounded operation by
//! operation. If it is not zero, it vanishes modulo a random prime with probability at most (b/60)/2^54, since at most b/60 primes of the set divide its
//! coefficients; otherwise it vanishes at a random point with probability at most d/2^60. Products are not expanded: the cost is one operation per node and point.

mod bounds;
mod denominators;
mod point;
mod prime_field;
mod program;

use crate::Sym;
use crate::graph::Node;
use bounds::{Bounded, Bounds, bounds};
use point::{angles_are_independent, different_roots, values};
use prime_field::{Field, Random};
use program::{Part, Program};

/// Primes lie between 2^60 and 2^61, which contain more than 2^54 primes (a density of 1/42).
const BITS: f64 = 60.0;
const PRIMES: f64 = 54.0;

/// The accepted probability of error, as a power of two.
const ALLOWED: f64 = -100.0;

/// The largest number of points. If more are needed, the degree is too high for a test.
const MOST_POINTS: usize = 64;

/// The largest number of roots that are computed in the field.
const MOST_ROOTS: usize = 4;

/// After this number of points with a vanishing denominator, the denominator counts as zero everywhere. The number is multiplied by four for each root,
/// since a root may not exist in the field.
const MOST_IN_VAIN: usize = 16;

/// The result of a test at random points.
#[derive(Clone, Debug, PartialEq)]
pub enum Identity {
    /// The expression vanished at every point. It is zero, with a probability of error of at most 2^`error`.
    Identified { degree: f64, points: usize, error: f64 },
    /// The expression is not zero. Its angles are linearly independent.
    NotZero,
    /// The test gave no result; the text gives the reason.
    Untested(&'static str),
}

/// Tests whether all expressions are zero, at common random points.
pub fn identified(expressions: &[Sym]) -> Identity {
    IdentityTest::of(expressions).outcome()
}

/// A planned test; its cost is known before it is run.
pub struct IdentityTest {
    program: Program,
    /// The number of roots that are computed in the field.
    taken: usize,
    degree: f64,
    /// The probability of error at one point, as a power of two.
    each: f64,
    points: Option<usize>,
}

impl IdentityTest {
    /// Plans a test: counts the operations and bounds the degree.
    pub fn of(expressions: &[Sym]) -> Self {
        let program = Program::of(expressions);
        let roots = different_roots(&program);
        let taken = if roots <= MOST_ROOTS { roots } else { 0 };
        let Bounds { degree, bits, mistaken } = bounds(&program);
        let chance = |degree: f64, bits: f64| (degree.log2() - BITS).exp2() + (bits / BITS) * (-PRIMES).exp2();
        let each = (chance(degree, bits)
            + mistaken.map_or(0.0, |Bounded { degree, bits, pairs }| pairs * chance(degree, bits)))
        .log2();
        // factors for the conjugates and the existence of all roots, and for the primes 3 modulo 4, which are half of all primes
        let each = each + 2.0 * taken as f64 + if taken > 0 { 1.0 } else { 0.0 };
        let points = if each < 0.0 { (ALLOWED / each).ceil() } else { f64::INFINITY };
        let points = (1.0..=MOST_POINTS as f64).contains(&points).then_some(points as usize);
        IdentityTest { program, taken, degree, each, points }
    }

    /// Returns the number of distinct subexpressions of all expressions.
    pub fn operations(&self) -> usize {
        self.program.parts.len()
    }

    /// Returns a bound of the degree of the numerator over the common denominator.
    pub fn degree(&self) -> f64 {
        self.degree
    }

    /// Returns the required number of points; `None` if the degree is too high for these fields.
    pub fn points(&self) -> Option<usize> {
        self.points
    }

    /// Evaluates the expressions at random points until one point shows that an expression is not zero, or all points are used.
    pub fn outcome(&self) -> Identity {
        let IdentityTest { ref program, taken, degree, each, points } = *self;
        let is_opaque = |part: &Part| match part.node {
            Node::Elementary(..) | Node::Function(..) => true,
            Node::Root(_) => taken == 0,
            _ => false,
        };
        let opaque = program.parts.iter().any(is_opaque);
        if program.parts.iter().any(|part| part.is == Sym::UNDEFINED) {
            return Identity::Untested("a denominator is the constant zero");
        }
        let Some(points) = points else { return Identity::Untested("the degree is too high for these fields") };
        let (mut random, mut in_vain, mut done) = (Random(0x9e37_79b9_7f4a_7c15), 0, 0);
        // one entry per choice of signs of the roots
        let mut vanishes = vec![true; 1 << taken];
        while done < points && vanishes.contains(&true) {
            let field = Field(random.prime(taken > 0));
            let drawn = random.0;
            let of_signs = |signs: u32| {
                let mut random = Random(drawn);
                let values = values(program, &field, &mut random, (taken > 0).then_some(signs))?;
                Some((program.results.iter().all(|&place| values[place] == 0), random.0))
            };
            let all: Option<Vec<(bool, u64)>> = (0..1 << taken).map(of_signs).collect();
            match all {
                None if in_vain == MOST_IN_VAIN << (2 * taken) => {
                    return Identity::Untested("a denominator vanishes at every point that was tried");
                }
                None => {
                    in_vain += 1;
                    random.next();
                }
                Some(all) => {
                    done += 1;
                    vanishes.iter_mut().zip(&all).for_each(|(vanishes, (here, _))| *vanishes &= here);
                    random.0 = all[0].1;
                    if taken == 0 && !vanishes[0] {
                        break;
                    }
                }
            }
        }
        match (vanishes.iter().all(|all| *all), vanishes.contains(&true), opaque) {
            (true, ..) => Identity::Identified { degree, points, error: each * points as f64 },
            (false, true, _) => Identity::Untested("it vanishes for some signs of its roots alone"),
            (false, false, true) => Identity::Untested("it does not vanish for functions that are independent"),
            (false, false, false) if !angles_are_independent(program, &mut random) => {
                Identity::Untested("it does not vanish for angles that are independent")
            }
            (false, false, false) => Identity::NotZero,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::prime_field::is_prime;
    use super::*;
    use crate::symbols;
    use field::{Analytic, Elementary, Scalar};

    #[test]
    fn angles_are_the_same_in_whatever_order_their_factors_stand() {
        let [w, v, t, s] = symbols(["w", "v", "t", "s"]);
        let point = |angle: Sym| angle.circle();
        for zero in [
            point(w * t).cos - point(t * w).cos,
            point(w * t * s).sin - point(w * (s * t)).sin,
            (w * t).elementary(Elementary::Exp, w * t) - (t * w).elementary(Elementary::Exp, t * w),
        ] {
            assert!(matches!(identified(&[zero]), Identity::Identified { .. }), "{zero}: {:?}", identified(&[zero]));
        }
        // the sum of angles in parentheses is expanded
        let (a, b) = (point(w * t), point(v * t));
        let sum = point((w + v) * t).cos - (a.cos * b.cos - a.sin * b.sin);
        assert!(matches!(identified(&[sum]), Identity::Untested(_)), "{:?}", identified(&[sum]));
        assert_eq!(identified(&[a.cos - b.cos]), Identity::NotZero);
    }

    #[test]
    fn identities_are_seen_without_being_expanded() {
        let [x, y] = symbols(["x", "y"]);
        let (a, b) = (x.circle(), y.circle());
        let sum = (a.cos * b.cos - a.sin * b.sin) - (x + y).circle().cos;
        let tower = (0..20).fold(x + y, |power, _| power * power) - (0..20).fold(y + x, |power, _| power * power);
        let quotient = x / y - Sym::int(1) - (x - y) / y;
        for zero in [a.cos * a.cos + a.sin * a.sin - Sym::int(1), sum, quotient] {
            let Identity::Identified { error, .. } = identified(&[zero]) else { panic!("{zero}") };
            assert!(error <= ALLOWED, "{error}");
        }
        assert!(matches!(identified(&[tower]), Identity::Identified { .. }), "{:?}", identified(&[tower]));
        assert_eq!(identified(&[a.cos * a.cos + a.sin * a.sin - Sym::ratio(1_000_001, 1_000_000)]), Identity::NotZero);
    }

    #[test]
    fn a_number_that_one_prime_divides_is_not_taken_for_zero() {
        let [x] = symbols(["x"]);
        let prime = Random(0x9e37_79b9_7f4a_7c15).prime(false);
        assert_eq!(identified(&[x * Sym::int(prime as i64)]), Identity::NotZero);
        assert!(is_prime((1 << 61) - 1) && !is_prime((1 << 61) + 1) && is_prime(101) && !is_prime(3 * 5 * 17));
    }

    #[test]
    fn roots_are_those_of_their_squares() {
        let [x, y] = symbols(["x", "y"]);
        let length = (x * x + y * y).sqrt();
        let unit = x / length * (x / length) + y / length * (y / length) - Sym::ONE;
        assert!(matches!(identified(&[unit, length * length - x * x - y * y]), Identity::Identified { .. }));
        assert_eq!(identified(&[length - x - y]), Identity::NotZero);
        // the root of a square has one of two signs
        assert!(matches!(identified(&[(x * x).sqrt() - x]), Identity::Untested(_)));
        assert_eq!(identified(&[(x * x).sqrt() - y]), Identity::NotZero);
    }

    #[test]
    fn roots_of_equal_arguments_are_one() {
        let [x, y] = symbols(["x", "y"]);
        let (one, other) = (((x + y) * (x + y)).sqrt(), (x * x + (x + x + y) * y).sqrt());
        assert!(matches!(identified(&[one - other]), Identity::Identified { .. }));
        assert_eq!(identified(&[one - (x * x + y).sqrt()]), Identity::NotZero);
        // equal roots count once
        let many: Vec<Sym> = (1..9).map(|k| (x * Sym::int(k) - x * Sym::int(k - 1) + y).sqrt()).collect();
        let differences: Vec<Sym> = many.windows(2).map(|pair| pair[0] * pair[0] - pair[1] * pair[0]).collect();
        assert!(matches!(identified(&differences), Identity::Identified { .. }));
    }

    #[test]
    fn a_divisor_that_terms_share_is_counted_once() {
        let [x, y, z] = symbols(["x", "y", "z"]);
        let divisor = x * y + z;
        let sum = (1..50).fold(Sym::ZERO, |sum, k| sum + (x + Sym::int(k)) / divisor * (y / divisor));
        assert!(IdentityTest::of(&[sum]).degree() < 10.0, "{}", IdentityTest::of(&[sum]).degree());
        // constant denominators are shared too: the halves of a sum have one denominator
        let halves = (1..2000).fold(x, |sum, k| (sum + y * Sym::int(k)) * Sym::ratio(1, 2) + z);
        assert!(IdentityTest::of(&[halves]).points().is_some());
        // Gaussian elimination of twelve unknowns from a banded system
        let pivot = (0..12).fold(x, |pivot, k| x + y / (pivot + Sym::int(k)));
        assert!(matches!(identified(&[pivot - pivot * (z / z)]), Identity::Identified { .. }));
    }

    #[test]
    fn what_has_no_value_in_the_field_is_not_tested() {
        let [x] = symbols(["x"]);
        let many: Vec<Sym> = (1..6).map(|k| (x + Sym::int(k)).sqrt()).collect();
        assert_eq!(identified(&many[..3]), Identity::NotZero);
        assert!(matches!(identified(&many), Identity::Untested(_)));
        let twice = x.elementary(Elementary::Exp, x) - (x + x).elementary(Elementary::Exp, x).sqrt();
        assert!(matches!(identified(&[twice]), Identity::Untested(_)));
        let opaque = (x.sqrt() + Sym::ONE) * (x.sqrt() - Sym::ONE) - x.sqrt() * x.sqrt() + Sym::ONE;
        assert!(matches!(identified(&[opaque]), Identity::Identified { .. }));
        assert!(matches!(identified(&[Sym::ONE / (x - x)]), Identity::Untested(_)));
        let zero = (x + Sym::ONE) * (x - Sym::ONE) - x * x + Sym::ONE;
        assert!(matches!(identified(&[Sym::ONE / zero]), Identity::Untested(_)));
        let towering = (0..80).fold(x, |power, _| power * power);
        assert!(matches!(identified(&[towering]), Identity::Untested(_)));
    }
}
