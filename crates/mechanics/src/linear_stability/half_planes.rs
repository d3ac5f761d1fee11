//! The numbers of roots of a polynomial in the left half-plane, on the imaginary axis, and in the right half-plane.
//!
//! With p(i y) = i^n (f0(y) - i f1(y)), where f0 and f1 are real, one even and one odd, roots that are not common to
//! both satisfy
//!
//!   left - right = index of f1/f0 from minus to plus infinity ,
//!
//! where the index is Cauchy's. It is counted by Sturm's chain of f0, f1 (Hermite, Routh: the rows of Routh's array are
//! this chain). The last member of the chain is the greatest common divisor of f0 and f1. Its roots are those of p on
//! the axis, and pairs mu, -mu, half of them in either half-plane.

use super::derivative;
use algebra::real::Ordered;

/// The numbers of roots of a real polynomial in the left half-plane, on the imaginary axis and in the right half-plane,
/// with multiplicity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HalfPlanes {
    pub left: usize,
    /// The number of roots on the imaginary axis, zero included.
    pub axis: usize,
    pub right: usize,
    /// The number of distinct roots on the axis. A pair that was divided out counts as distinct from the others.
    pub distinct: usize,
}

impl HalfPlanes {
    /// Counts the roots of the polynomial with these coefficients, the highest first. `None` where a sign cannot be
    /// determined, and for the zero polynomial.
    pub fn of<R: Ordered>(coefficients: &[R]) -> Option<Self> {
        let first = coefficients.first()?;
        if first.sign()? == 0 {
            return HalfPlanes::of(&coefficients[1..]);
        }
        let degree = coefficients.len() - 1;
        let zero = first.integer(0);
        // the coefficients of y^(n-k), the highest first: p_k with the sign of i^k
        let part = |parity: usize| -> Vec<R> {
            let of = |(k, c): (usize, &R)| match (k % 2 == parity, (k / 2) % 2) {
                (false, _) => zero.clone(),
                (true, 0) => c.clone(),
                (true, _) => zero.minus(c),
            };
            coefficients.iter().enumerate().map(of).collect()
        };
        let chain = chain(part(0), part(1)[1..].to_vec())?;
        let common = chain.last()?;
        let shared = common.len() - 1;
        let index = index(&chain)?;
        // left + right = degree - shared, left - right = index
        let (axis, distinct) = on_the_axis(common)?;
        let beside = (shared - axis) / 2;
        let apart = degree as i64 - shared as i64;
        let left = usize::try_from((apart + index) / 2).ok()?;
        let right = usize::try_from((apart - index) / 2).ok()?;
        Some(HalfPlanes { left: left + beside, axis, right: right + beside, distinct })
    }

    /// Counts the roots of a polynomial that is known to be divisible by z^2 + `square`, with `square` not zero: a
    /// remainder that may be zero is dropped. `None` where a sign cannot be determined, or the remainder is certainly
    /// not zero.
    pub fn without_pair<R: Ordered>(coefficients: &[R], square: &R) -> Option<Self> {
        let sign = square.sign()?;
        if sign == 0 || coefficients.len() < 3 {
            return None;
        }
        let mut rest = coefficients.to_vec();
        for k in 0..rest.len() - 2 {
            rest[k + 2] = rest[k + 2].minus(&rest[k].times(square));
        }
        let remainder = rest.split_off(rest.len() - 2);
        if remainder.iter().any(|c| c.sign().is_some_and(|sign| sign != 0)) {
            return None;
        }
        let HalfPlanes { left, axis, right, distinct } = HalfPlanes::of(&rest)?;
        if sign < 0 {
            return Some(HalfPlanes { left: left + 1, axis, right: right + 1, distinct });
        }
        // the pair may coincide with other roots on the axis
        Some(HalfPlanes { left, axis: axis + 2, right, distinct: distinct + 2 })
    }

    /// The total number of roots.
    pub fn degree(&self) -> usize {
        self.left + self.axis + self.right
    }
}

/// The number of distinct real roots of a polynomial with these coefficients, the highest first. `None` where a sign
/// cannot be determined.
pub fn real_roots<R: Ordered>(coefficients: &[R]) -> Option<usize> {
    usize::try_from(index(&chain(coefficients.to_vec(), derivative(coefficients))?)?).ok()
}

/// Sturm's chain: each member is the negative remainder of the two before, divided by a positive number.
fn chain<R: Ordered>(first: Vec<R>, second: Vec<R>) -> Option<Vec<Vec<R>>> {
    let mut chain = vec![scaled(trimmed(first)?)?];
    let mut next = trimmed(second)?;
    while !next.is_empty() {
        let divisor = scaled(next)?;
        let rest = remainder(&chain[chain.len() - 1], &divisor)?;
        let zero = divisor[0].integer(0);
        next = trimmed(rest.iter().map(|c| zero.minus(c)).collect())?;
        chain.push(divisor);
    }
    Some(chain)
}

/// The polynomial without leading zeros; empty for the zero polynomial.
fn trimmed<R: Ordered>(polynomial: Vec<R>) -> Option<Vec<R>> {
    for (place, c) in polynomial.iter().enumerate() {
        if c.sign()? != 0 {
            return Some(polynomial[place..].to_vec());
        }
    }
    Some(Vec::new())
}

/// The polynomial divided by the magnitude of its leading coefficient, against growth of the numbers along the chain.
fn scaled<R: Ordered>(polynomial: Vec<R>) -> Option<Vec<R>> {
    let Some(lead) = polynomial.first() else { return Some(polynomial) };
    let size = if lead.sign()? < 0 { lead.integer(0).minus(lead) } else { lead.clone() };
    let unit = lead.integer(lead.sign()?.into());
    let rest = polynomial[1..].iter().map(|c| c.over(&size));
    std::iter::once(Some(unit)).chain(rest).collect()
}

/// The remainder modulo a divisor with leading coefficient 1 or -1; leading coefficients are dropped without a zero
/// test.
fn remainder<R: Ordered>(dividend: &[R], divisor: &[R]) -> Option<Vec<R>> {
    let mut rest = dividend.to_vec();
    let positive = divisor[0].sign()? > 0;
    while rest.len() >= divisor.len() {
        let lead = rest.remove(0);
        for (place, c) in divisor[1..].iter().enumerate() {
            let product = lead.times(c);
            rest[place] = if positive { rest[place].minus(&product) } else { rest[place].plus(&product) };
        }
    }
    Some(rest)
}

/// The number of sign changes at minus infinity minus that at plus infinity.
fn index<R: Ordered>(chain: &[Vec<R>]) -> Option<i64> {
    let signs: Vec<[i32; 2]> = chain
        .iter()
        .map(|member| {
            let sign = member[0].sign()?;
            Some([if member.len() % 2 == 0 { -sign } else { sign }, sign])
        })
        .collect::<Option<_>>()?;
    let changes = |side: usize| signs.windows(2).filter(|pair| pair[0][side] != pair[1][side]).count() as i64;
    Some(changes(0) - changes(1))
}

/// The numbers of real roots of a polynomial in y, with and without multiplicity.
fn on_the_axis<R: Ordered>(polynomial: &[R]) -> Option<(usize, usize)> {
    let mut repeated = polynomial.to_vec();
    let (mut all, mut distinct) = (0, None);
    while repeated.len() > 1 {
        let chain = chain(repeated.clone(), derivative(&repeated))?;
        let real = usize::try_from(index(&chain)?).ok()?;
        all += real;
        distinct = distinct.or(Some(real));
        // the greatest common divisor with the derivative has each root once less
        repeated = chain.last()?.clone();
    }
    Some((all, distinct.unwrap_or(0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::{Rational, Scalar};
    use proptest::prelude::*;

    /// The product of factors mu - a and mu^2 + b mu + c, highest first.
    fn product(factors: &[Vec<i64>]) -> Vec<Rational> {
        factors.iter().fold(vec![Rational::int(1)], |product, factor| {
            let mut next = vec![Rational::int(0); product.len() + factor.len() - 1];
            for (i, a) in product.iter().enumerate() {
                for (j, b) in factor.iter().enumerate() {
                    next[i + j] += *a * Rational::int(*b);
                }
            }
            next
        })
    }

    fn counted(factors: &[Vec<i64>]) -> [usize; 4] {
        let HalfPlanes { left, axis, right, distinct } = HalfPlanes::of(&product(factors)).unwrap();
        [left, axis, right, distinct]
    }

    #[test]
    fn regular_polynomials_are_counted_as_by_routh() {
        assert_eq!(counted(&[vec![1, 1], vec![1, 2], vec![1, 3]]), [3, 0, 0, 0]);
        assert_eq!(counted(&[vec![1, -1], vec![1, 2], vec![1, 1, 5]]), [3, 0, 1, 0]);
        assert_eq!(counted(&[vec![1, -1, 7]]), [0, 0, 2, 0]);
    }

    #[test]
    fn rows_that_vanish_are_pairs_on_the_axis_or_on_both_sides() {
        // mu^2 + 1 with a stable root; mu^2 - 1; both; mu^4 + 4 = (mu^2 + 2 mu + 2)(mu^2 - 2 mu + 2)
        assert_eq!(counted(&[vec![1, 0, 1], vec![1, 3]]), [1, 2, 0, 2]);
        assert_eq!(counted(&[vec![1, 0, -1], vec![1, 3]]), [2, 0, 1, 0]);
        assert_eq!(counted(&[vec![1, 0, 0, 0, 4]]), [2, 0, 2, 0]);
        assert_eq!(counted(&[vec![1, 0, 1], vec![1, 0, -1], vec![1, 0, 0, 0, 4], vec![1, -2]]), [3, 2, 4, 2]);
    }

    #[test]
    fn different_real_roots_are_counted_unless_an_enclosure_cannot_tell() {
        use algebra::real::Enclosure;
        let count = |factors: &[Vec<i64>]| real_roots(&product(factors));
        assert_eq!(count(&[vec![1, -1], vec![1, -1], vec![1, 2], vec![1, 0, 4]]), Some(2));
        assert_eq!(count(&[vec![1, 1, 5]]), Some(0));
        // y^2 - 2 y + c for all c from 1/2 to 3/4, and to 3/2
        let number = |x: f64| Enclosure::float(x, 64).unwrap();
        let with = |high: f64| [number(1.0), number(-2.0), number(0.5).hull(&number(high))];
        assert_eq!([real_roots(&with(0.75)), real_roots(&with(1.5))], [Some(2), None]);
    }

    #[test]
    fn a_row_that_begins_with_zero_is_no_exception() {
        // mu^4 + mu^3 + mu^2 + mu + 1: the third row begins with zero
        assert_eq!(counted(&[vec![1, 1, 1, 1, 1]]), [2, 0, 2, 0]);
        assert_eq!(counted(&[vec![1, 0, 2, 1]]), [1, 0, 2, 0]);
    }

    #[test]
    fn repeated_pairs_and_zeros_are_counted_as_often_as_they_are_roots() {
        let pair = vec![1, 0, 4];
        assert_eq!(counted(&[pair.clone(), pair.clone(), vec![1, 0, 9]]), [0, 6, 0, 4]);
        assert_eq!(counted(&[vec![1, 0], vec![1, 0], pair.clone(), pair, vec![1, 1]]), [1, 6, 0, 3]);
    }

    #[test]
    fn a_known_pair_is_divided_out_though_enclosures_cannot_see_it() {
        use algebra::real::Enclosure;
        let whole = |n: i64| Enclosure::integer(n, 64);
        // (z^2 + 1/9)(z + 2)
        let ninth = whole(1).over(&whole(9)).unwrap();
        let third = whole(1).over(&whole(3)).unwrap();
        let square = &third * &third;
        let all = [whole(1), whole(2), ninth.clone(), &ninth * &whole(2)];
        assert_eq!(HalfPlanes::of(&all), None);
        let found = HalfPlanes::without_pair(&all, &square).unwrap();
        assert_eq!((found.left, found.axis, found.right), (1, 2, 0));
        assert_eq!(HalfPlanes::without_pair(&all, &whole(1)), None);
    }

    #[test]
    fn a_known_pair_of_real_roots_lies_on_both_sides() {
        let whole = |n: i64| Rational::int(n);
        // (z^2 - 4)(z + 1)
        let found = HalfPlanes::without_pair(&[1, 1, -4, -4].map(whole), &whole(-4)).unwrap();
        assert_eq!([found.left, found.axis, found.right, found.distinct], [2, 0, 1, 0]);
    }

    #[test]
    fn an_enclosure_around_zero_is_no_sign() {
        use algebra::real::Enclosure;
        let whole = |n: i64| Enclosure::integer(n, 64);
        let third = whole(1).over(&whole(3)).unwrap();
        // 3 (1/3) - 1 is zero or not, as far as the enclosure decides
        let unknown = &(&third * &whole(3)) - &whole(1);
        assert_eq!(HalfPlanes::of(&[whole(1), unknown, whole(1)]), None);
        let found = HalfPlanes::of(&[whole(1), third, whole(1)]).unwrap();
        assert_eq!((found.left, found.axis, found.right), (2, 0, 0));
    }

    proptest! {
        /// Products of factors with known roots, including symmetric ones.
        #[test]
        fn products_of_known_factors_are_counted(factors in prop::collection::vec((-4..5i64, 0..5i64, any::<bool>()), 1..5)) {
            let mut known = [0, 0, 0];
            let mut all = Vec::new();
            for (a, c, linear) in factors {
                if linear {
                    // the root -a
                    known[usize::from(a == 0) + 2 * usize::from(a < 0)] += 1;
                    all.push(vec![1, a]);
                } else {
                    // mu^2 + a mu + (a^2/4 + c) 4: complex or double roots with real part -a/2
                    known[usize::from(a == 0) + 2 * usize::from(a < 0)] += 2;
                    all.push(vec![4, 4 * a, a * a + 4 * c]);
                }
            }
            let [left, axis, right, _] = counted(&all);
            prop_assert_eq!([left, axis, right], known);
        }
    }
}
