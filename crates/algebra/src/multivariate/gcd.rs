//! Greatest common divisors of polynomials.
//!
//! Images modulo a prime bound the degree of the divisor in every generator. A generator that cannot occur in it is
//! removed by passing to coefficients; most pairs are thereby recognised as coprime. The remaining cases use the
//! primitive remainder sequence in one generator over the others.

use super::modular::Image;
use super::{Budget, Coefficient, Limit, Poly, monomial};

impl<C: Coefficient, const W: usize> Poly<C, W> {
    /// The greatest common divisor over the rationals, primitive, with a positive first coefficient.
    ///
    /// # Errors
    /// [`Limit`] where a limit of the computation is exceeded.
    pub fn common_divisor(&self, other: &Self, budget: &Budget) -> Result<Self, Limit> {
        match (self.is_zero(), other.is_zero()) {
            (true, _) => return other.primitive(),
            (_, true) => return self.primitive(),
            _ => {}
        }
        let (m, n) = (self.common_monomial(), other.common_monomial());
        let shared = monomial::extremes(&m, &n, false);
        let strip = |p: &Self, m| p.over_monomial(m).ok_or(Limit::Degree)?.primitive();
        let rest = stripped(strip(self, &m)?, strip(other, &n)?, budget)?;
        rest.scaled(&shared, &C::of(1))
    }

    /// The polynomial divided by its content: coefficients without common divisor, the first one positive.
    ///
    /// # Errors
    /// [`Limit`] where a limit of the computation is exceeded.
    pub fn primitive(&self) -> Result<Self, Limit> {
        if self.is_zero() {
            return Ok(self.clone());
        }
        self.over_constant(&self.content()).ok_or(Limit::Overflow)
    }

    /// The coefficients of the powers of a generator, from the zeroth power.
    ///
    /// # Errors
    /// [`Limit`] where a limit of the computation is exceeded.
    pub fn by_powers(&self, generator: usize) -> Result<Vec<Self>, Limit> {
        let degree = monomial::exponent(&self.degrees(), generator);
        let mut parts = vec![Vec::new(); degree as usize + 1];
        for (m, c) in self.terms() {
            let exponent = monomial::exponent(m, generator);
            let rest = monomial::quotient(m, &monomial::power(generator, exponent)?).ok_or(Limit::Degree)?;
            // removing an equal exponent keeps monomials in descending order
            parts[exponent as usize].push((rest, c.clone()));
        }
        Ok(parts.into_iter().map(Self::sorted).collect())
    }

    /// The greatest common divisor of the coefficients of the powers of a generator.
    fn content_in(&self, generator: usize, budget: &Budget) -> Result<Self, Limit> {
        let mut coefficients = self.by_powers(generator)?;
        coefficients.retain(|each| !each.is_zero());
        coefficients.sort_by_key(Self::len);
        let mut content = Self::zero();
        for each in &coefficients {
            content = content.common_divisor(each, budget)?;
            if content.is_one() {
                break;
            }
        }
        Ok(content)
    }
}

/// The greatest common divisor of two primitive polynomials without monomial factors.
fn stripped<C: Coefficient, const W: usize>(
    a: Poly<C, W>,
    b: Poly<C, W>,
    budget: &Budget,
) -> Result<Poly<C, W>, Limit> {
    if a.is_one() || b.is_one() {
        return Ok(Poly::one());
    }
    let (large, small) = if a.len() >= b.len() { (a, b) } else { (b, a) };
    if large.exact_quotient(&small, budget)?.is_some() {
        return Ok(small);
    }
    let (high, low) = (large.degrees(), small.degrees());
    let both = monomial::extremes(&high, &low, true);
    let mut main: Option<(u32, usize)> = None;
    for (generator, _) in monomial::support(&both) {
        let (p, q) = (monomial::exponent(&high, generator), monomial::exponent(&low, generator));
        let bound = if p.min(q) == 0 { 0 } else { degree_bound(&large, &small, generator, p, q) };
        if bound == 0 {
            // the common divisor does not contain this generator: it divides every coefficient
            let a = if p > 0 { large.content_in(generator, budget)? } else { large };
            if a.is_one() {
                return Ok(a);
            }
            let b = if q > 0 { small.content_in(generator, budget)? } else { small };
            return a.common_divisor(&b, budget);
        }
        main = main.min(Some((p.min(q), generator))).or(Some((p.min(q), generator)));
    }
    match main {
        Some((_, generator)) => remainder_sequence(&large, &small, generator, budget),
        None => Ok(Poly::one()),
    }
}

/// An upper bound of the degree of the greatest common divisor in a generator, by images.
fn degree_bound<C: Coefficient, const W: usize>(
    a: &Poly<C, W>,
    b: &Poly<C, W>,
    generator: usize,
    p: u32,
    q: u32,
) -> usize {
    let (first, second) = (Image::of(a, generator), Image::of(b, generator));
    let (whole_a, whole_b) = (first.degree() == Some(p as usize), second.degree() == Some(q as usize));
    // the image of the divisor has full degree if the leading coefficient of a multiple does not vanish
    if whole_a || whole_b { first.common_degree(second) } else { p.min(q) as usize }
}

/// Euclid's algorithm in one generator with primitive remainders.
fn remainder_sequence<C: Coefficient, const W: usize>(
    a: &Poly<C, W>,
    b: &Poly<C, W>,
    generator: usize,
    budget: &Budget,
) -> Result<Poly<C, W>, Limit> {
    let divide = |p: &Poly<C, W>, content: &Poly<C, W>| p.exact_quotient(content, budget)?.ok_or(Limit::Overflow);
    let (content_a, content_b) = (a.content_in(generator, budget)?, b.content_in(generator, budget)?);
    let shared = content_a.common_divisor(&content_b, budget)?;
    let (mut p, mut q) = (divide(a, &content_a)?, divide(b, &content_b)?);
    let degree = |p: &Poly<C, W>| monomial::exponent(&p.degrees(), generator);
    if degree(&p) < degree(&q) {
        std::mem::swap(&mut p, &mut q);
    }
    loop {
        let remainder = pseudo_remainder(&p, &q, generator, budget)?;
        if remainder.is_zero() {
            return q.primitive()?.times(&shared, budget);
        }
        if degree(&remainder) == 0 {
            return Ok(shared);
        }
        let primitive = divide(&remainder, &remainder.content_in(generator, budget)?)?.primitive()?;
        (p, q) = (q, primitive);
    }
}

/// The pseudo-remainder: a multiple of p minus a multiple of q, of lower degree than q in the generator.
fn pseudo_remainder<C: Coefficient, const W: usize>(
    p: &Poly<C, W>,
    q: &Poly<C, W>,
    generator: usize,
    budget: &Budget,
) -> Result<Poly<C, W>, Limit> {
    let mut rest = p.by_powers(generator)?;
    let divisor = q.by_powers(generator)?;
    let Some((lead, tail)) = divisor.split_last() else {
        return Ok(Poly::zero());
    };
    while rest.len() > tail.len() {
        let Some(top) = rest.pop() else { break };
        if top.is_zero() {
            continue;
        }
        for each in &mut rest {
            *each = each.times(lead, budget)?;
        }
        let offset = rest.len() - tail.len();
        for (place, coefficient) in tail.iter().enumerate() {
            let product = top.times(coefficient, budget)?;
            rest[offset + place] = rest[offset + place].plus(&product.negated())?;
        }
    }
    let mut powers = Vec::with_capacity(rest.len());
    for (exponent, coefficient) in rest.into_iter().enumerate() {
        powers.push(coefficient.scaled(&monomial::power(generator, exponent as u32)?, &C::of(1))?);
    }
    Poly::sum(powers, budget)
}
