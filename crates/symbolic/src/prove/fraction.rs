//! Quotients of polynomials whose denominators are products of known factors.
//!
//! A proof needs no greatest common divisors, since over a common denominator the numerator either is zero or is not. Known factors are tried
//! as divisors, which keeps numerators small when terms cancel.

use super::reduce::{PolyRule, reduce};
use algebra::multivariate::{Budget, Coefficient, Limit, Poly, monomial};
use std::rc::Rc;

/// The quotient numerator / (constant * product of factors^powers), with a positive constant.
#[derive(Clone, Debug)]
pub(super) struct Fraction<C, const W: usize> {
    pub numerator: Poly<C, W>,
    pub constant: C,
    /// (index of a factor in [`Arithmetic::factors`], exponent), in ascending order of the index.
    pub powers: Vec<(usize, u32)>,
}

/// Arithmetic of quotients modulo rules, with the factors of all denominators that occurred so far.
pub(super) struct Arithmetic<C, const W: usize> {
    pub budget: Budget,
    pub rules: Vec<PolyRule<C, W>>,
    /// Primitive polynomials with positive leading coefficients.
    pub factors: Vec<Poly<C, W>>,
}

impl<C: Coefficient, const W: usize> Fraction<C, W> {
    pub fn whole(numerator: Poly<C, W>) -> Self {
        Fraction { numerator, constant: C::of(1), powers: Vec::new() }
    }

    /// Divides numerator and denominator by the common factor of their coefficients.
    pub fn without_content(mut self) -> Self {
        if !self.constant.is_one() {
            let mut common = self.constant.clone();
            for (_, coefficient) in self.numerator.terms() {
                if common.is_one() {
                    return self;
                }
                common = common.common(coefficient);
            }
            if let (Some(numerator), Some(constant)) =
                (self.numerator.over_constant(&common), self.constant.exact_quotient(&common))
            {
                (self.numerator, self.constant) = (numerator, constant);
            }
        }
        self
    }
}

impl<C: Coefficient, const W: usize> Arithmetic<C, W> {
    pub fn new() -> Self {
        Arithmetic { budget: Budget::default(), rules: Vec::new(), factors: Vec::new() }
    }

    /// Returns the sum of the quotients; those marked `true` are subtracted.
    pub fn sum(&mut self, mut summands: Vec<(Rc<Fraction<C, W>>, bool)>) -> Result<Fraction<C, W>, Limit> {
        summands.retain(|(each, _)| !each.numerator.is_zero());
        if summands.iter().all(|(each, _)| each.constant.is_one() && each.powers.is_empty()) {
            let polys: Vec<_> = summands.iter().map(|(each, negative)| (&each.numerator, *negative)).collect();
            return Ok(Fraction::whole(Poly::signed_sum(&polys, &self.budget)?));
        }
        let mut constant = C::of(1);
        let mut powers: Vec<(usize, u32)> = Vec::new();
        for (each, _) in &summands {
            let common = constant.common(&each.constant);
            let missing = each.constant.exact_quotient(&common).unwrap_or(C::of(1));
            constant = constant.times(&missing)?;
            powers = merged(&powers, &each.powers, u32::max);
        }
        let mut numerators = Vec::with_capacity(summands.len());
        for (each, negative) in summands {
            let scale = constant.exact_quotient(&each.constant).unwrap_or(C::of(1));
            let scale = if negative { scale.negated() } else { scale };
            let missing = merged(&powers, &each.powers, |all, own| all - own);
            let raised = self.times_factors(each.numerator.clone(), &missing)?;
            numerators.push(raised.times_constant(&scale)?);
        }
        let numerator = Poly::sum(numerators, &self.budget)?;
        // multiplication by factors that contain a rule's generator may undo the reduction
        self.reduced(Fraction { numerator, constant, powers })
    }

    pub fn product(&mut self, a: &Fraction<C, W>, b: &Fraction<C, W>) -> Result<Fraction<C, W>, Limit> {
        if a.powers.is_empty() && b.powers.is_empty() {
            let numerator = a.numerator.times(&b.numerator, &self.budget)?;
            let constant = a.constant.times(&b.constant)?;
            return self.reduced_product(Fraction { numerator, constant, powers: Vec::new() });
        }
        let (mut first, mut second) = (a.numerator.clone(), b.numerator.clone());
        let mut right = b.powers.clone();
        let mut left = a.powers.clone();
        self.cancel(&mut first, &mut right)?;
        self.cancel(&mut second, &mut left)?;
        let numerator = first.times(&second, &self.budget)?;
        let constant = a.constant.times(&b.constant)?;
        self.reduced_product(Fraction { numerator, constant, powers: merged(&left, &right, |a, b| a + b) })
    }

    /// Returns a / b; the numerator of b must not be zero.
    pub fn quotient(&mut self, a: &Fraction<C, W>, b: &Fraction<C, W>) -> Result<Fraction<C, W>, Limit> {
        // first cancels the denominators of a and b, factor by factor
        let common = merged(&a.powers, &b.powers, u32::min);
        let mut powers = merged(&a.powers, &common, |all, own| all - own);
        let upward = merged(&b.powers, &common, |all, own| all - own);
        let mut numerator = self.times_factors(a.numerator.clone(), &upward)?.times_constant(&b.constant)?;
        let Inverse { mut content, multiplier, powers: mut below } = self.inverse(&b.numerator)?;
        if content.is_negative() {
            content = content.negated();
            numerator = numerator.negated();
        }
        self.cancel(&mut numerator, &mut below)?;
        if !multiplier.is_one() {
            numerator = numerator.times(&multiplier, &self.budget)?;
        }
        powers = merged(&powers, &below, |a, b| a + b);
        let constant = a.constant.times(&content)?;
        self.reduced_product(Fraction { numerator, constant, powers })
    }

    /// Reduces the numerator modulo the rules, then cancels common factors.
    fn reduced(&mut self, mut fraction: Fraction<C, W>) -> Result<Fraction<C, W>, Limit> {
        let (numerator, constant) = reduce(fraction.numerator, &self.rules, &self.budget)?;
        fraction.numerator = numerator;
        fraction.constant = fraction.constant.times(&constant)?;
        self.cancelled(fraction)
    }

    /// Like [`Arithmetic::reduced`], for a product whose factors were cancelled already: without rules nothing else cancels.
    fn reduced_product(&mut self, product: Fraction<C, W>) -> Result<Fraction<C, W>, Limit> {
        if self.rules.is_empty() && !product.numerator.is_zero() {
            return Ok(product.without_content());
        }
        self.reduced(product)
    }

    fn cancelled(&self, mut fraction: Fraction<C, W>) -> Result<Fraction<C, W>, Limit> {
        if fraction.numerator.is_zero() {
            return Ok(Fraction::whole(fraction.numerator));
        }
        self.cancel(&mut fraction.numerator, &mut fraction.powers)?;
        Ok(fraction.without_content())
    }

    /// Cancels the factors of the denominator that divide the numerator.
    fn cancel(&self, numerator: &mut Poly<C, W>, powers: &mut Vec<(usize, u32)>) -> Result<(), Limit> {
        for (factor, exponent) in powers.iter_mut() {
            while *exponent > 0 {
                match numerator.exact_quotient(&self.factors[*factor], &self.budget)? {
                    Some(quotient) => *numerator = quotient,
                    None => break,
                }
                *exponent -= 1;
            }
        }
        powers.retain(|&(_, exponent)| exponent > 0);
        Ok(())
    }

    pub fn times_factors(&self, mut poly: Poly<C, W>, powers: &[(usize, u32)]) -> Result<Poly<C, W>, Limit> {
        for &(factor, exponent) in powers {
            for _ in 0..exponent {
                poly = poly.times(&self.factors[factor], &self.budget)?;
            }
        }
        Ok(poly)
    }

    /// Returns 1 / poly, factorised into content, generators, known factors, and the rest as a new factor.
    fn inverse(&mut self, poly: &Poly<C, W>) -> Result<Inverse<C, W>, Limit> {
        let mut content = poly.content();
        let common = poly.common_monomial();
        let mut rest = poly.over_constant(&content).and_then(|p| p.over_monomial(&common)).ok_or(Limit::Degree)?;
        let mut multiplier = Poly::one();
        let mut powers = Vec::new();
        for (generator, exponent) in monomial::support(&common) {
            let root = self.rules.iter().find(|rule| rule.generator == generator && rule.tail.as_constant().is_some());
            match root {
                // the generator is the root of a number: 1/g = scale g^(k-1) / tail
                Some(rule) => {
                    let inverse = Poly::term(monomial::power(generator, rule.power - 1)?, rule.scale.clone());
                    multiplier = multiplier.times(&inverse.power(exponent, &self.budget)?, &self.budget)?;
                    content = content.times(&rule.tail.content().power(exponent)?)?;
                }
                None => powers.push((self.factor(Poly::term(monomial::power(generator, 1)?, C::of(1))), exponent)),
            }
        }
        for known in 0..self.factors.len() {
            if rest.as_constant().is_some() {
                break;
            }
            let mut exponent = 0;
            while let Some(quotient) = rest.exact_quotient(&self.factors[known], &self.budget)? {
                rest = quotient;
                exponent += 1;
            }
            if exponent > 0 {
                powers.push((known, exponent));
            }
        }
        if rest.as_constant().is_none() {
            powers.push((self.factor(rest), 1));
        }
        powers.sort_unstable();
        Ok(Inverse { content, multiplier, powers })
    }

    fn factor(&mut self, factor: Poly<C, W>) -> usize {
        self.factors.iter().position(|known| *known == factor).unwrap_or_else(|| {
            self.factors.push(factor);
            self.factors.len() - 1
        })
    }
}

/// The reciprocal multiplier / (content * product of factors^powers).
struct Inverse<C, const W: usize> {
    content: C,
    multiplier: Poly<C, W>,
    powers: Vec<(usize, u32)>,
}

/// Combines the exponents of equal factors; a missing factor has the exponent zero.
fn merged(a: &[(usize, u32)], b: &[(usize, u32)], combine: fn(u32, u32) -> u32) -> Vec<(usize, u32)> {
    let (mut a, mut b) = (a.iter().copied().peekable(), b.iter().copied().peekable());
    let mut result = Vec::new();
    loop {
        let next = match (a.peek(), b.peek()) {
            (None, None) => break,
            (Some(first), None) => first.0,
            (None, Some(second)) => second.0,
            (Some(first), Some(second)) => first.0.min(second.0),
        };
        let own = |side: Option<(usize, u32)>| side.map_or(0, |(_, exponent)| exponent);
        let exponent = combine(own(a.next_if(|each| each.0 == next)), own(b.next_if(|each| each.0 == next)));
        if exponent > 0 {
            result.push((next, exponent));
        }
    }
    result
}
