//! Fractions brought to lowest terms, with denominators free of the leads of rules.
//!
//! Where a rule g^2 = t holds, every element is a + b g, and a denominator a + b g is made free of g by its conjugate:
//! (a + b g)(a - b g) = a^2 - b^2 t. The result is a fraction over a polynomial ring, whose lowest terms are unique.
//! For reading, powers of t in the denominator are then written as powers of g again: 1/sin(x), not sin(x)/(1 - cos(x)^2).

use super::fraction::{Arithmetic, Fraction};
use super::reduce::PolyRule;
use algebra::multivariate::{Coefficient, Limit, Poly, monomial};

/// Conjugates are formed as long as the new denominator has no more terms than this.
const LONGEST_NORM: usize = 400;

/// numerator / (constant * denominator) with nothing in common.
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

/// A rule of the form scale g^2 = t, t free of g and not a number, that `poly` is subject to.
fn is_quadratic<C: Coefficient, const W: usize>(rule: &PolyRule<C, W>) -> bool {
    rule.power == 2 && monomial::exponent(&rule.tail.degrees(), rule.generator) == 0
}

/// The fraction with a denominator free of the leads of quadratic rules.
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

/// Tails of rules in the denominator replaced by the squares of their leads.
fn readable<C: Coefficient, const W: usize>(
    mut terms: LowestTerms<C, W>,
    arithmetic: &Arithmetic<C, W>,
) -> Result<LowestTerms<C, W>, Limit> {
    let budget = &arithmetic.budget;
    for rule in arithmetic.rules.iter().filter(|rule| is_quadratic(rule) && rule.tail.as_constant().is_none()) {
        let (content, primitive) = (rule.tail.content(), rule.tail.primitive()?);
        let lead = monomial::power(rule.generator, 1)?;
        while let Some(rest) = terms.denominator.exact_quotient(&primitive, budget)? {
            // primitive = scale g^2 / content.
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
