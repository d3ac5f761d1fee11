//! Hypotheses that the printed formula may have omitted, such as that a letter is zero or has a sign.

use super::letter_rates::LetterRate;
use super::lost_inertia::takes_inertia;
use super::places::Places;
use super::probe::says_nothing;
use crate::claim_text::{ClaimText, Kind};
use crate::conditions::{assume, hypotheses};
use crate::consequence::is_of_inertia;
use crate::implications::condition;
use crate::inequalities::sides;
use crate::integrals::{difference, known};
use crate::letters::{Letters, rate};
use crate::lines::lines;
use crate::motion::Motion;
use crate::passage::Passage;
use crate::steady_motion::Resting;
use latex::{Function, Statement, read};
use std::cmp::Reverse;
use std::collections::BTreeSet;
use symbolic::{Node, Sym, decide};

/// Hypotheses about the signs of letters, for a formula with a root.
pub(super) fn signs_of_letters(places: &Places, text: &str, rates: &[LetterRate]) -> Vec<String> {
    // the root of a square depends on the sign of a letter
    let has_root = text.contains(r"\sqrt");
    let is_printed = |rate: &&LetterRate| places.atoms.iter().any(|atom| atom.name == rate.name);
    let signed = rates.iter().filter(|rate| has_root && rate.is_symbol && rate.order == 0).filter(is_printed);
    signed.flat_map(|rate| [r"\geq", r"\leq"].map(|sign| format!("{} {sign} 0", rate.latex))).collect()
}

/// Hypotheses that a letter or rate is zero. Letters of the formula come first, then inputs, then higher rates. Parameters are tried separately, since
/// without them the model is another one; for conditions and linearised equations they are not tried, since these state for which parameters they
/// hold, and for inequalities nothing is tried, since these state a region.
pub(super) fn zeros(kind: Kind, places: &Places, rates: &[LetterRate], are_parameters: bool) -> Vec<String> {
    let is_condition = matches!(kind, Kind::SteadyMotion | Kind::Equivalence | Kind::LinearisedEquation);
    if matches!(kind, Kind::Inequality | Kind::Stability) || are_parameters && is_condition {
        return Vec::new();
    }
    let names: BTreeSet<&str> = places.atoms.iter().map(|atom| atom.name.as_str()).collect();
    let has_acceleration = places.atoms.iter().any(|atom| atom.order == 2);
    // a reaction is a result of the motion, and so is an acceleration where the formula contains none
    let is_result = |rate: &LetterRate| rate.is_reaction || rate.order == 2 && !has_acceleration;
    let is_stated = |rate: &&LetterRate| rate.is_symbol && !is_result(rate) && rate.is_parameter == are_parameters;
    let mut all: Vec<&LetterRate> = rates.iter().filter(is_stated).collect();
    all.sort_by_key(|rate| (!names.contains(rate.name.as_str()), !rate.is_input, Reverse(rate.order)));
    let mut known: Vec<Sym> = Vec::new();
    all.retain(|rate| {
        let is_new = !known.contains(&rate.value);
        known.push(rate.value);
        is_new
    });
    all.iter().map(|rate| format!("{} = 0", rate.latex)).collect()
}

/// Hypotheses under which an inequality may hold (signs of parameters) or a condition may be divided (parameters, and printed letters, sines and
/// cosines, that differ from zero).
pub(super) fn of_parameters(kind: Kind, places: &Places, text: &str, rates: &[LetterRate]) -> Vec<String> {
    let signs: &[&str] = match kind {
        Kind::Inequality => &[r"\geq", ">"],
        Kind::Stability => &[">"],
        Kind::SteadyMotion | Kind::Equivalence => &[r"\neq"],
        _ => &[],
    };
    let is_printed =
        |rate: &LetterRate| places.atoms.iter().any(|atom| atom.name == rate.name && atom.order == rate.order);
    let is_divided = matches!(kind, Kind::SteadyMotion | Kind::Equivalence);
    let divides = |rate: &&LetterRate| is_divided && rate.is_symbol && is_printed(rate);
    let parameters = rates.iter().filter(|rate| rate.is_parameter);
    let others = rates.iter().filter(|rate| !rate.is_parameter).filter(divides);
    let letters = parameters.chain(others).map(|rate| rate.latex.clone());
    let calls = places.calls.iter().filter(|call| is_divided && is_circular(call.function));
    let circles =
        calls.flat_map(|call| [r"\sin", r"\cos"].map(|name| format!("{name}{{{}}}", &text[call.argument.clone()])));
    let all: Vec<String> = letters.chain(circles).collect();
    all.into_iter().flat_map(|latex| signs.iter().map(move |sign| format!("{latex} {sign} 0"))).collect()
}

fn is_circular(function: Function) -> bool {
    matches!(function, Function::Sin | Function::Cos)
}

/// Hypotheses that all parameters of an inequality are nonnegative.
pub(super) fn signs_of_parameters(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    rates: &[LetterRate],
) -> Vec<String> {
    let Some(sides) = (claim.kind == Kind::Inequality).then(|| sides(claim, statement, letters).ok()).flatten() else {
        return Vec::new();
    };
    let symbols = sides.greater.symbols_of();
    let held = rates.iter().filter(|rate| rate.is_parameter && symbols.contains(&rate.value));
    held.map(|rate| format!(r"{} \geq 0", rate.latex)).collect()
}

/// Whether a claim still states something if its last hypothesis sets a letter to zero: the model keeps its inertia, the equations
/// of motion are still needed, not all sides of the formula vanish, and most of its terms remain.
pub(super) fn leaves_something(claim: &ClaimText, letters: &Letters<'_, '_>) -> bool {
    let Some(last) = claim.given.last().filter(|last| last.text.ends_with("= 0")) else { return true };
    let zero =
        read(&last.text, &letters.spelt()).ok().and_then(|statement| super::probe::own_difference(&statement, letters));
    let statement = read(&claim.formula.text, &known(claim.kind, letters)).ok();
    let (Some(zero), Some(statement)) = (zero, statement) else { return false };
    if is_parameter_of_inertia(last, letters) || takes_inertia(&claim.given, letters) {
        return false;
    }
    let before = &claim.given[..claim.given.len() - 1];
    let is_parameter = vanishing_symbol(last, letters).is_some_and(|zero| letters.trace.parameters.contains(&zero));
    if !is_parameter && vanishing_parameters(&claim.given, letters) > vanishing_parameters(before, letters) {
        return false;
    }
    let (Some(motion), Some(free)) = (under(&claim.given, claim, letters), under(before, claim, letters)) else {
        return false;
    };
    let vanishes = |side: Sym| decide(motion.reduced(side), &motion.hypotheses).is_zero();
    // at rest every expression is constant
    if claim.kind == Kind::IntegralOfMotion && letters.trace.speeds.iter().all(|speed| vanishes(*speed)) {
        return false;
    }
    // an equation that holds without the equations of motion states nothing about them
    if stated(claim, &statement, letters).is_some_and(|zeros| zeros.into_iter().any(vanishes)) {
        return false;
    }
    // claims of other kinds are not checked further
    let Ok(mut lines) = lines(claim, &statement, letters) else { return true };
    // a formula also states nothing if both sides vanish by the hypothesis and the constraints
    if lines.iter().any(|line| line.model.into_iter().all(vanishes)) {
        return false;
    }
    let there = |own: Sym| own.substitute(&[(zero, Sym::ZERO)]);
    let terms: Vec<Sym> = lines.iter().flat_map(|line| line.own).flat_map(terms).collect();
    // a letter that denotes a product vanishes with a factor; a rate that vanishes anyway is not counted
    let is_gone = |term: &&Sym| {
        let meaning = term.substitute(&letters.meanings(**term));
        vanishes(meaning) && !decide(free.reduced(meaning), &free.hypotheses).is_zero()
    };
    let gone = terms.iter().filter(is_gone).count();
    lines.iter_mut().for_each(|line| line.own = line.own.map(there));
    2 * gone < terms.len() && !lines.iter().any(says_nothing)
}

/// The number of parameters that must vanish along every motion under some hypotheses, for example the weight if its acceleration is set to zero.
fn vanishing_parameters(given: &[Passage], letters: &Letters<'_, '_>) -> usize {
    let motion = Motion::by_equations(letters.trace).ok().zip(hypotheses(given, letters).ok());
    let motion = motion.and_then(|(mut motion, given)| assume(&mut motion, &given).ok().map(|()| motion));
    let vanishes =
        |motion: &Motion<'_, '_>, parameter: Sym| decide(motion.reduced(parameter), &motion.hypotheses).is_zero();
    motion.map_or(0, |motion| letters.trace.parameters.iter().filter(|one| vanishes(&motion, **one)).count())
}

/// The motion under constraints and hypotheses, with the letters of the claim constant; `None` where the hypotheses contradict each other.
fn under<'t, 'm>(given: &[Passage], claim: &ClaimText, letters: &Letters<'t, 'm>) -> Option<Motion<'t, 'm>> {
    let mut motion = match claim.kind {
        Kind::SteadyMotion => Motion::at_rest(letters.trace, &Resting::of(claim, letters).ok()?.rates(letters)),
        _ => Motion::by_constraints(letters.trace),
    };
    assume(&mut motion, &hypotheses(given, letters).ok()?).ok()?;
    Some(motion)
}

/// The expressions that a claim about motions states to vanish along them; for an equivalence those of both conditions.
fn stated(claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Option<Vec<Sym>> {
    match claim.kind {
        Kind::IntegralOfMotion => {
            let (is, _) = difference(claim, statement, letters).ok()?;
            Some(vec![rate(letters.trace, is).ok()?])
        }
        Kind::EquationOfMotion => {
            let lines = lines(claim, statement, letters).ok()?;
            Some(lines.iter().map(|line| line.model[0] - line.model[1]).collect())
        }
        Kind::SteadyMotion | Kind::Equivalence => {
            let conditions = statement.chains.iter().map(|chain| condition(claim, chain, letters).ok());
            conditions.map(|found| found.map(|(zero, _)| zero)).collect()
        }
        _ => None,
    }
}

/// Whether a hypothesis sets a parameter to zero without which a coordinate has no inertia.
fn is_parameter_of_inertia(hypothesis: &Passage, letters: &Letters<'_, '_>) -> bool {
    let zero = vanishing_symbol(hypothesis, letters);
    zero.is_some_and(|zero| is_of_inertia(zero, &Motion::without_anything(letters.trace)))
}

/// The expression that a hypothesis sets to zero.
fn vanishing_symbol(hypothesis: &Passage, letters: &Letters<'_, '_>) -> Option<Sym> {
    let read = hypotheses(std::slice::from_ref(hypothesis), letters).ok()?;
    read.first()?.equality.map(|(zero, _)| zero)
}

/// The terms of a sum, without simplification.
fn terms(sum: Sym) -> Vec<Sym> {
    match sum.node() {
        Node::Sum(a, b) | Node::Difference(a, b) => [terms(a), terms(b)].concat(),
        Node::Negation(a) => terms(a),
        _ if sum == Sym::ZERO => Vec::new(),
        _ => vec![sum],
    }
}
