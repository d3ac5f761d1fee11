//! Reduction of polynomials modulo rewriting rules.

use algebra::multivariate::{Budget, Coefficient, Limit, Poly, monomial};

/// The rule scale * generator^power -> tail.
pub(super) struct PolyRule<C, const W: usize> {
    pub generator: usize,
    pub power: u32,
    pub scale: C,
    pub tail: Poly<C, W>,
}

/// Rewrites a polynomial until no rule applies. The given polynomial equals the first result divided by the second.
pub(super) fn reduce<C: Coefficient, const W: usize>(
    mut poly: Poly<C, W>,
    rules: &[PolyRule<C, W>],
    budget: &Budget,
) -> Result<(Poly<C, W>, C), Limit> {
    let mut constant = C::of(1);
    for rule in rules {
        let mut highest = monomial::exponent(&poly.degrees(), rule.generator);
        while highest >= rule.power {
            let most = highest / rule.power;
            let mut parts: Vec<Vec<_>> = vec![Vec::new(); most as usize + 1];
            for (m, c) in poly.terms() {
                let times = monomial::exponent(m, rule.generator) / rule.power;
                let removed = monomial::power(rule.generator, times * rule.power)?;
                let rest = monomial::quotient(m, &removed).ok_or(Limit::Degree)?;
                parts[times as usize].push((rest, c.clone()));
            }
            let mut tail = Poly::one();
            let mut summands = Vec::with_capacity(parts.len());
            for (times, part) in parts.into_iter().enumerate() {
                if times > 0 {
                    tail = tail.times(&rule.tail, budget)?;
                }
                let scale = rule.scale.power(most - times as u32)?;
                summands.push(Poly::collected(part)?.times(&tail, budget)?.times_constant(&scale)?);
            }
            constant = constant.times(&rule.scale.power(most)?)?;
            poly = Poly::sum(summands, budget)?;
            highest = monomial::exponent(&poly.degrees(), rule.generator);
        }
    }
    Ok((poly, constant))
}
