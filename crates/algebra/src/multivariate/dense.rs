//! Products of dense polynomials in an array with one element for every possible monomial.
//!
//! The index of a monomial is the number with its exponents as digits (Kronecker substitution): the index of a product
//! is the sum of the indices.

use super::{Coefficient, Monomial, Poly, monomial};
use std::ops::AddAssign;

/// The largest length of the array.
const PLACES: u64 = 1 << 23;

/// An integer of fixed size, large enough for the sums of products.
trait Accumulator: Copy + Default + PartialEq + AddAssign {
    fn product(a: i64, b: i64) -> Self;
    fn wide(self) -> i128;
}

impl Accumulator for i64 {
    #[inline]
    fn product(a: i64, b: i64) -> Self {
        a * b
    }

    fn wide(self) -> i128 {
        self.into()
    }
}

impl Accumulator for i128 {
    #[inline]
    fn product(a: i64, b: i64) -> Self {
        i128::from(a) * i128::from(b)
    }

    fn wide(self) -> i128 {
        self
    }
}

/// The generators of a product, each with its number of digit values.
struct Digits(Vec<(usize, u64)>);

impl Digits {
    fn place<const W: usize>(&self, m: &Monomial<W>) -> u32 {
        let place = |sum, &(generator, count): &_| sum * count + u64::from(monomial::exponent(m, generator));
        // at most PLACES
        self.0.iter().fold(0, place) as u32
    }

    fn monomial<const W: usize>(&self, mut place: u64) -> Option<Monomial<W>> {
        let mut all = monomial::unit();
        for &(generator, count) in self.0.iter().rev() {
            let power = monomial::power(generator, (place % count) as u32).ok()?;
            all = monomial::product(&all, &power).ok()?;
            place /= count;
        }
        Some(all)
    }
}

impl<C: Coefficient, const W: usize> Poly<C, W> {
    /// The product by an array, if there are fewer possible monomials than products of terms and all sums fit in
    /// machine integers; `None` otherwise.
    pub(super) fn dense_product(&self, other: &Self) -> Option<Self> {
        let degrees = monomial::product(&self.degrees(), &other.degrees()).ok()?;
        let digits = Digits(monomial::support(&degrees).map(|(g, highest)| (g, u64::from(highest) + 1)).collect());
        let most = PLACES.min(self.len() as u64 * other.len() as u64);
        let places = digits.0.iter().try_fold(1u64, |all, &(_, count)| Some(all * count).filter(|&all| all <= most))?;
        let small = |poly: &Self| -> Option<Vec<(u32, i64)>> {
            poly.terms.iter().map(|(m, c)| Some((digits.place(m), c.small()?))).collect()
        };
        let (a, b) = (small(self)?, small(other)?);
        let sizes =
            |terms: &[(u32, i64)]| -> Vec<u128> { terms.iter().map(|(_, c)| c.unsigned_abs().into()).collect() };
        let largest = sizes(&b).into_iter().max()?;
        let bound = sizes(&a).into_iter().try_fold(0u128, |sum, size| sum.checked_add(size.checked_mul(largest)?))?;
        let terms = if i64::try_from(bound).is_ok() {
            products::<i64, C, W>(&a, &b, places, &digits)
        } else {
            i128::try_from(bound).ok()?;
            products::<i128, C, W>(&a, &b, places, &digits)
        };
        Some(Poly { terms: terms? })
    }
}

fn products<A: Accumulator, C: Coefficient, const W: usize>(
    a: &[(u32, i64)],
    b: &[(u32, i64)],
    places: u64,
    digits: &Digits,
) -> Option<Vec<(Monomial<W>, C)>> {
    let mut sums = vec![A::default(); places as usize];
    for &(first, p) in a {
        let sums = &mut sums[first as usize..];
        for &(second, q) in b {
            sums[second as usize] += A::product(p, q);
        }
    }
    let zero = A::default();
    let found = sums.iter().enumerate().rev().filter(|(_, sum)| **sum != zero);
    found.map(|(place, sum)| Some((digits.monomial(place as u64)?, C::from_wide(sum.wide())?))).collect()
}
