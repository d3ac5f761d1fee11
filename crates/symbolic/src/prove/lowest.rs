//! Quotients in lowest terms, whose denominators contain no leading generator of a rule.
//!
//! With a rule g^2 = t every element has the form a + b g. A denominator a + b g is made free of g by its conjugate:
//! (a + b g)(a - b g) = a^2 - b^2 t. The result is a quotient over a polynomial ring, whose lowest terms are unique.
//! For readability, powers of t in the denominator are then replaced by powers of g: 1/sin(x) in place of sin(x)/(1 - cos(x)^2).

use super::fraction::{Arithmetic, Fraction};
use super::reduce::PolyRule;
use algebra::multivariate::{Coefficient, Limit, Poly, monomial};

/// A denominator is not rationalised if the result would have more terms.
const LONGEST_NORM: usize = 400;

/// The quotient numerator / (constant * denominator) in lowest terms.
pub(super) struct LowestTerms<C, const W: usize> {
    pub numerator: Poly<C, W>,
    pub constant: C,
    pub denominator: Poly<C, W>,
}

pub(super) fn lowest_terms<C: Coefficient, const W: usize>(
    fraction: Fraction<C, W>,
    arithmetic: &mut Arithmetic<C, W>,
) -> Result<LowestTerms<C, W>, Limit> {
    let fraction = rationalised(fraction, arithmetic)?.without_content();
    let Fraction { mut numerator, constant, powers } = fraction;
    let budget = &arithmetic.budget;
    let mut denominator = Poly::one();
    for (number, exponent) in powers {
        for _ in 0..exponent {
            let mut rest = arithmetic.factors[number].clone();
            loop {
                let common = numerator.common_divisor(&rest, budget)?;
                if common.is_one() {
                    break;
                }
                numerator = numerator.exact_quotient(&common, budget)?.ok_or(Limit::Overflow)?;
                rest = rest.exact_quotient(&common, budget)?.ok_or(Limit::Overflow)?;
            }
            denominator = denominator.times(&rest, budget)?;
        }
    }
    readable(LowestTerms { numerator, constant, denominator }, arithmetic)
}

/// Returns whether a rule has the form scale g^2 = t with t free of g.
fn is_quadratic<C: Coefficient, const W: usize>(rule: &PolyRule<C, W>) -> bool {
    rule.power == 2 && monomial::exponent(&rule.tail.degrees(), rule.generator) == 0
}

/// Makes the denominator free of the leading generators of quadratic rules.
fn rationalised<C: Coefficient, const W: usize>(
    mut fraction: Fraction<C, W>,
    arithmetic: &mut Arithmetic<C, W>,
) -> Result<Fraction<C, W>, Limit> {
    for place in 0..arithmetic.rules.len() {
        let generator = arithmetic.rules[place].generator;
        if !is_quadratic(&arithmetic.rules[place]) {
            continue;
        }
        let holds = |factor: &Poly<C, W>| monomial::exponent(&factor.degrees(), generator) > 0;
        while let Some(at) = fraction.powers.iter().position(|&(number, _)| holds(&arithmetic.factors[number])) {
            let (number, exponent) = fraction.powers[at];
            let factor = arithmetic.factors[number].clone();
            let mut conjugate = Vec::with_capacity(factor.terms().len());
            for (m, c) in factor.terms() {
                let odd = monomial::exponent(m, generator) % 2 == 1;
                conjugate.push((*m, if odd { c.negated() } else { c.clone() }));
            }
            let conjugate = Fraction::whole(Poly::collected(conjugate)?);
            let norm = arithmetic.product(&Fraction::whole(factor), &conjugate)?;
            if norm.numerator.is_zero() || norm.numerator.terms().len() > LONGEST_NORM || holds(&norm.numerator) {
                return Ok(fraction);
            }
            fraction.powers.remove(at);
            for _ in 0..exponent {
                fraction = arithmetic.product(&fraction, &conjugate)?;
                fraction = arithmetic.quotient(&fraction, &norm)?;
            }
        }
    }
    Ok(fraction)
}

/// Replaces tails of rules in the denominator by the squares of their leading generators.
fn readable<C: Coefficient, const W: usize>(
    mut terms: LowestTerms<C, W>,
    arithmetic: &Arithmetic<C, W>,
) -> Result<LowestTerms<C, W>, Limit> {
    let budget = &arithmetic.budget;
    for rule in arithmetic.rules.iter().filter(|rule| is_quadratic(rule) && rule.tail.as_constant().is_none()) {
        let (content, primitive) = (rule.tail.content(), rule.tail.primitive()?);
        let lead = monomial::power(rule.generator, 1)?;
        while let Some(rest) = terms.denominator.exact_quotient(&primitive, budget)? {
            // primitive = scale g^2 / content
            let LowestTerms { mut numerator, mut constant, denominator: _ } = terms;
            numerator = numerator.times_constant(&content)?;
            constant = constant.times(&rule.scale)?;
            let mut denominator = rest.scaled(&lead, &C::of(1))?;
            match numerator.over_monomial(&lead) {
                Some(quotient) => numerator = quotient,
                None => denominator = denominator.scaled(&lead, &C::of(1))?,
            }
            let Fraction { numerator, constant, .. } =
                Fraction { numerator, constant, powers: Vec::new() }.without_content();
            terms = LowestTerms { numerator, constant, denominator };
        }
    }
    Ok(terms)
}
