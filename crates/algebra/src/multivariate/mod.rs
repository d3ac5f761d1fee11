//! Sparse multivariate polynomials with integer coefficients.
//!
//! Terms are sorted by descending monomials. Exponents are packed, so that a product of monomials is an addition of
//! words. Generators are numbered.

mod coefficient;
mod dense;
mod division;
mod gcd;
mod modular;
pub mod monomial;
mod product;

pub use coefficient::Coefficient;
pub use monomial::Monomial;

use std::cell::Cell;
use std::cmp::{Ordering, Reverse};
use std::fmt;

/// The limit that ended a computation without a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// A coefficient overflowed the machine integers: the computation must be repeated with big integers.
    Overflow,
    /// An exponent above 127.
    Degree,
    /// More terms than the limit.
    Terms,
    /// More operations on terms than the limit.
    Work,
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Limit::Overflow => "a coefficient outgrew the machine integers",
            Limit::Degree => "an exponent rose above 127",
            Limit::Terms => "a polynomial outgrew the limit on terms",
            Limit::Work => "the computation outgrew the limit on operations",
        })
    }
}

impl std::error::Error for Limit {}

/// The number of operations that a computation may use.
#[derive(Debug)]
pub struct Budget {
    work: Cell<u64>,
}

impl Default for Budget {
    fn default() -> Self {
        Budget { work: Cell::new(Self::WORK) }
    }
}

impl Budget {
    /// The largest number of terms of a polynomial.
    pub const TERMS: usize = 1 << 20;
    /// The largest number of operations on terms: seconds with machine integers, a minute with big ones.
    const WORK: u64 = 1_000_000_000;

    /// Subtracts operations from the budget.
    ///
    /// # Errors
    /// [`Limit::Work`] where the budget is exhausted.
    #[inline]
    pub fn spend(&self, operations: usize) -> Result<(), Limit> {
        let left = self.work.get().checked_sub(operations as u64).ok_or(Limit::Work)?;
        self.work.set(left);
        Ok(())
    }
}

/// A polynomial: terms in descending order of monomials, with nonzero coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct Poly<C, const W: usize> {
    terms: Vec<(Monomial<W>, C)>,
}

/// The number of terms up to which a sum is computed by sorting; above, by merging.
const MERGED: usize = 1 << 8;

impl<C: Coefficient, const W: usize> Poly<C, W> {
    /// The zero polynomial.
    pub fn zero() -> Self {
        Poly { terms: Vec::new() }
    }

    /// A constant polynomial.
    pub fn constant(value: C) -> Self {
        Self::term(monomial::unit(), value)
    }

    /// The constant polynomial 1.
    pub fn one() -> Self {
        Self::constant(C::of(1))
    }

    /// A polynomial of one term; zero if the coefficient is zero.
    pub fn term(monomial: Monomial<W>, coefficient: C) -> Self {
        Poly { terms: if coefficient.is_zero() { Vec::new() } else { vec![(monomial, coefficient)] } }
    }

    /// A polynomial from terms in any order, with possibly repeated monomials.
    ///
    /// # Errors
    /// [`Limit`] where a coefficient overflows or there are too many terms.
    pub fn collected(mut terms: Vec<(Monomial<W>, C)>) -> Result<Self, Limit> {
        terms.sort_unstable_by_key(|term| Reverse(term.0));
        let mut kept: Vec<(Monomial<W>, C)> = Vec::with_capacity(terms.len());
        for (monomial, coefficient) in terms {
            match kept.last_mut() {
                Some(last) if last.0 == monomial => last.1 = last.1.plus(&coefficient)?,
                _ => {
                    if kept.last().is_some_and(|last| last.1.is_zero()) {
                        kept.pop();
                    }
                    kept.push((monomial, coefficient));
                }
            }
        }
        if kept.last().is_some_and(|last| last.1.is_zero()) {
            kept.pop();
        }
        Ok(Poly { terms: kept })
    }

    /// A polynomial from terms in descending order of distinct monomials, whose coefficients may be zero.
    fn sorted(mut terms: Vec<(Monomial<W>, C)>) -> Self {
        terms.retain(|(_, coefficient)| !coefficient.is_zero());
        Poly { terms }
    }

    /// The terms in descending order of monomials.
    pub fn terms(&self) -> &[(Monomial<W>, C)] {
        &self.terms
    }

    fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether the polynomial is zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value of a constant polynomial; `None` for others.
    pub fn as_constant(&self) -> Option<C> {
        match self.terms.as_slice() {
            [] => Some(C::of(0)),
            [(monomial, value)] if *monomial == monomial::unit() => Some(value.clone()),
            _ => None,
        }
    }

    /// Whether the polynomial is 1.
    pub fn is_one(&self) -> bool {
        self.as_constant().is_some_and(|value| value.is_one())
    }

    /// The negative of the polynomial.
    pub fn negated(&self) -> Self {
        Poly { terms: self.terms.iter().map(|(m, c)| (*m, c.negated())).collect() }
    }

    /// The sum.
    ///
    /// # Errors
    /// [`Limit::Overflow`] where a coefficient overflows, [`Limit::Terms`] where there are too many terms.
    pub fn plus(&self, other: &Self) -> Result<Self, Limit> {
        let (mut a, mut b) = (self.terms.as_slice(), other.terms.as_slice());
        let mut sum = Vec::with_capacity(a.len() + b.len());
        while let (Some(first), Some(second)) = (a.first(), b.first()) {
            match first.0.cmp(&second.0) {
                Ordering::Greater => {
                    sum.push(first.clone());
                    a = &a[1..];
                }
                Ordering::Less => {
                    sum.push(second.clone());
                    b = &b[1..];
                }
                Ordering::Equal => {
                    let coefficient = first.1.plus(&second.1)?;
                    if !coefficient.is_zero() {
                        sum.push((first.0, coefficient));
                    }
                    (a, b) = (&a[1..], &b[1..]);
                }
            }
        }
        sum.extend_from_slice(a);
        sum.extend_from_slice(b);
        if sum.len() > Budget::TERMS {
            return Err(Limit::Terms);
        }
        Ok(Poly { terms: sum })
    }

    /// The sum of many polynomials, those marked true with a negative sign.
    ///
    /// # Errors
    /// [`Limit`] where a coefficient overflows, or there are too many terms or operations.
    pub fn signed_sum(summands: &[(&Self, bool)], budget: &Budget) -> Result<Self, Limit> {
        let all = summands.iter().map(|(each, _)| each.len()).sum();
        if all > MERGED {
            let signed = |(each, negative): &(&Self, bool)| if *negative { each.negated() } else { (*each).clone() };
            return Self::sum(summands.iter().map(signed).collect(), budget);
        }
        budget.spend(all)?;
        let mut terms = Vec::with_capacity(all);
        for (each, negative) in summands {
            terms.extend(each.terms.iter().map(|(m, c)| (*m, if *negative { c.negated() } else { c.clone() })));
        }
        Self::collected(terms)
    }

    /// The sum of many polynomials, merged in pairs.
    ///
    /// # Errors
    /// [`Limit`] where a coefficient overflows, or there are too many terms or operations.
    pub fn sum(mut summands: Vec<Self>, budget: &Budget) -> Result<Self, Limit> {
        while summands.len() > 1 {
            let mut merged = Vec::with_capacity(summands.len().div_ceil(2));
            for pair in summands.chunks(2) {
                budget.spend(pair.iter().map(Poly::len).sum())?;
                merged.push(match pair {
                    [a, b] => a.plus(b)?,
                    rest => rest[0].clone(),
                });
            }
            summands = merged;
        }
        Ok(summands.pop().unwrap_or_else(Self::zero))
    }

    /// The product with one term.
    ///
    /// # Errors
    /// [`Limit`] where a coefficient overflows, or an exponent exceeds 127.
    pub fn scaled(&self, monomial: &Monomial<W>, factor: &C) -> Result<Self, Limit> {
        if factor.is_zero() {
            return Ok(Self::zero());
        }
        let scale = |(m, c): &(Monomial<W>, C)| Ok((monomial::product(m, monomial)?, c.times(factor)?));
        Ok(Poly { terms: self.terms.iter().map(scale).collect::<Result<_, Limit>>()? })
    }

    /// The product with a number.
    ///
    /// # Errors
    /// [`Limit::Overflow`] where a coefficient overflows.
    pub fn times_constant(&self, factor: &C) -> Result<Self, Limit> {
        if factor.is_one() { Ok(self.clone()) } else { self.scaled(&monomial::unit(), factor) }
    }

    /// The polynomial to a power.
    ///
    /// # Errors
    /// [`Limit`] where a product exceeds a limit.
    pub fn power(&self, exponent: u32, budget: &Budget) -> Result<Self, Limit> {
        if let [(monomial, coefficient)] = self.terms.as_slice() {
            let mut power = monomial::unit();
            for (generator, e) in monomial::support(monomial) {
                let total = e.checked_mul(exponent).ok_or(Limit::Degree)?;
                power = monomial::product(&power, &monomial::power(generator, total)?)?;
            }
            return Ok(Self::term(power, coefficient.power(exponent)?));
        }
        (0..exponent).try_fold(Self::one(), |product, _| product.times(self, budget))
    }

    /// The content: the greatest common divisor of the coefficients, with the sign of the first.
    pub fn content(&self) -> C {
        let mut content = C::of(0);
        for (_, coefficient) in &self.terms {
            content = content.common(coefficient);
            if content.is_one() {
                break;
            }
        }
        if self.terms.first().is_some_and(|(_, first)| first.is_negative()) { content.negated() } else { content }
    }

    /// The polynomial divided by a number; `None` where it does not divide all coefficients.
    pub fn over_constant(&self, divisor: &C) -> Option<Self> {
        if divisor.is_one() {
            return Some(self.clone());
        }
        let terms = self.terms.iter().map(|(m, c)| Some((*m, c.exact_quotient(divisor)?)));
        Some(Poly { terms: terms.collect::<Option<_>>()? })
    }

    /// The largest monomial that divides all terms.
    pub fn common_monomial(&self) -> Monomial<W> {
        let mut all = self.terms.iter().map(|(m, _)| *m);
        let first = all.next().unwrap_or(monomial::unit());
        all.fold(first, |common, m| monomial::extremes(&common, &m, false))
    }

    /// The highest exponent of every generator, as a monomial.
    pub fn degrees(&self) -> Monomial<W> {
        self.terms.iter().fold(monomial::unit(), |highest, (m, _)| monomial::extremes(&highest, m, true))
    }

    /// The polynomial divided by a monomial; `None` where it does not divide all terms.
    pub fn over_monomial(&self, divisor: &Monomial<W>) -> Option<Self> {
        let terms = self.terms.iter().map(|(m, c)| Some((monomial::quotient(m, divisor)?, c.clone())));
        Some(Poly { terms: terms.collect::<Option<_>>()? })
    }
}
