//! The terms that a printed condition lacks, compared with the equation of motion of which it should be a multiple.

use crate::consequence::is_apart;
use crate::display::{Told, factors, length, readable};
use crate::finding::Finding;
use crate::ideal_membership::combination;
use crate::motion::Motion;
use crate::resting_equations::SteadyMotion;
use symbolic::{Sym, coefficients, normal};

/// The largest number of terms of a condition that is compared term by term.
const MOST_TERMS: usize = 16;

/// Adds the terms to a finding that the right side of a printed condition lacks. If these are not simpler than the equation of motion, or the
/// condition with them states less, adds the equation of motion.
pub(crate) fn tell_shortfall(
    (printed, own): (Sym, [Sym; 2]),
    (equation, name): (Sym, &str),
    steady: &SteadyMotion<'_, '_>,
    told: Told<'_, '_, '_>,
    finding: &mut Finding,
) {
    let SteadyMotion { motion, equations, conditions, .. } = steady;
    let short = |expression: Sym| readable(expression, own, motion, told);
    let is_apart = |factor: Sym| is_apart(factor, motion, conditions);
    let follows = |(other, _): &(Sym, String)| combination(motion.reduced(*other), &[equation], &is_apart).is_some();
    let is_whole = equations.iter().all(follows);
    let whole = short(equation);
    let beside = scales(printed, equation, motion).into_iter().filter(|_| is_whole).filter_map(|scale| {
        let form = normal(scale, &motion.hypotheses).ok()?;
        if !factors(form.numerator()).into_iter().chain(factors(form.denominator())).all(is_apart) {
            return None;
        }
        let own = short(printed - scale * equation).filter(|own| *own != Sym::ZERO)?;
        let moves = scale.symbols_of().iter().any(|symbol| !motion.trace.parameters.contains(symbol));
        let rank = if scale.as_constant().is_some() { 0 } else { 1 + usize::from(moves) };
        // unless the factor is a number, the missing terms must be shorter than the equation
        let is_less = rank == 0 || whole.is_none_or(|whole| length(own) < length(whole));
        let is_fraction = normal(own, &motion.hypotheses).is_ok_and(|form| form.denominator().as_constant().is_none());
        is_less.then(|| ((is_fraction, rank, length(own)), own))
    });
    if let Some((_, own)) = beside.min_by_key(|(size, _)| *size) {
        finding.judged.evidence +=
            &format!("; with the terms below on its right side it is a multiple of the equation of {name}");
        finding.judged.difference = Some((own.to_string(), own.latex()));
    } else if let Some(whole) = whole {
        finding.judged.evidence += &format!("; the equation of {name} is {whole} = 0");
    }
}

/// The ratios of a term of the printed condition and a term of an equation.
fn scales(printed: Sym, equation: Sym, motion: &Motion<'_, '_>) -> Vec<Sym> {
    let (Some(own), Some(other)) = (terms(printed, motion), terms(equation, motion)) else { return Vec::new() };
    let mut all: Vec<Sym> = Vec::new();
    for (one, term) in own.iter().flat_map(|one| other.iter().map(move |term| (one, term))) {
        if let Ok(scale) = normal(*one / *term, &motion.hypotheses).map(|form| form.to_sym())
            && !all.contains(&scale)
        {
            all.push(scale);
        }
    }
    all
}

/// The terms of an expression in normal form, each divided by its denominator; `None` if there are too many.
fn terms(expression: Sym, motion: &Motion<'_, '_>) -> Option<Vec<Sym>> {
    let form = normal(expression, &motion.hypotheses).ok()?;
    let (above, below) = (form.numerator(), form.denominator());
    let leaves: Vec<Sym> = above.leaves_of().into_iter().filter(|leaf| leaf.as_constant().is_none()).collect();
    let found = coefficients(above, &leaves).ok().filter(|found| found.len() <= MOST_TERMS)?;
    let product = |(exponents, value): (Vec<u32>, Sym)| {
        let powers = leaves.iter().zip(exponents).filter(|(_, power)| *power > 0);
        powers.fold(value / below, |product, (&leaf, power)| product * leaf.powi(power as i32))
    };
    Some(found.into_iter().map(product).collect())
}
