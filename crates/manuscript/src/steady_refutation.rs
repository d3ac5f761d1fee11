//! Motions on which letters are constant and a printed condition fails.

use crate::admissible::admissible;
use crate::consequence::{Step, is_of_inertia, step};
use crate::equation::{Outcome, vanishes};
use crate::exact_points::{Effort, completed, search};
use crate::inertia::inertia_determinant;
use crate::motion::{Motion, solution};
use crate::refutation::Refutation;
use crate::resting_equations::SteadyMotion;
use claims::Condition;
use model::Trace;
use model::equations::constraints_of;
use symbolic::{Hypotheses, Sym, decide};

/// An exact point of such a motion at which the first printed condition fails. It is searched for where another printed condition holds, where the
/// equations of motion are solved, and among small numbers.
pub(crate) fn failing_motion(steady: &SteadyMotion<'_, '_>) -> Option<Refutation> {
    let steady = &lasting(steady)?;
    let SteadyMotion { motion, equations, printed, .. } = steady;
    let (&first, others) = printed.split_first()?;
    let is_motion =
        |found: &Refutation| is_steady(steady, found) && keeps_constraints(steady, found) && fails_at(first, found);
    let within = |conditions: &[Condition], effort: Effort| {
        let beside = || others.iter().find_map(|&other| beside(steady, other, conditions).filter(is_motion));
        let solved = || by_equations(steady, conditions, effort).into_iter().find(is_motion);
        let among_small = || {
            let expressions: Vec<Sym> = equations.iter().map(|(equation, _)| *equation).chain([first]).collect();
            let is_it = |signs: &[i8]| {
                signs.split_last().is_some_and(|(last, all)| *last != 0 && all.iter().all(|sign| *sign == 0))
            };
            search(&expressions, conditions, motion, effort, is_it).filter(is_motion)
        };
        beside().or_else(solved).or_else(among_small)
    };
    let conditions = with_inertia(steady, first)?;
    let found = within(&conditions, Effort::Whole)?;
    Some(admissible(found, motion, &conditions, |wanted| within(wanted, Effort::Part)))
}

/// A point at which another printed condition holds and the first one fails.
fn beside(steady: &SteadyMotion<'_, '_>, other: Sym, conditions: &[Condition]) -> Option<Refutation> {
    match step(&steady.motion, other, steady.printed[0], conditions) {
        Step::Fails(found) => Some(found),
        _ => None,
    }
}

/// Points at which the equations of motion, each solved for a letter, hold and the first printed condition fails.
fn by_equations(steady: &SteadyMotion<'_, '_>, conditions: &[Condition], effort: Effort) -> Vec<Refutation> {
    let mut there = steady.motion.clone();
    for (equation, _) in &steady.equations {
        if there.assume(*equation, letter_beside_constraints(&there, *equation)).is_err() {
            return Vec::new();
        }
    }
    let known: Vec<Condition> = conditions.iter().map(|condition| condition.mapped(|of| there.reduced(of))).collect();
    let by_witness = match vanishes(&there, steady.printed[0], &known) {
        Outcome::NonZero(found) => Some(found),
        _ => None,
    };
    // a witness of a normal form need not satisfy the constraints
    let among_small = || search(&[there.reduced(steady.printed[0])], &known, &there, effort, |signs| signs[0] != 0);
    let inputs = || there.trace.model.inputs.iter().map(|input| Sym::symbol(&input.name));
    let whole = |mut found: Refutation| {
        for symbol in there.replaced().into_iter().chain(inputs()) {
            let is_listed = found.point.iter().any(|(known, _)| *known == symbol);
            if let (false, Some(value)) = (is_listed, found.value(there.reduced(symbol))) {
                found.point.push((symbol, value));
            }
        }
        completed(found, conditions)
    };
    by_witness.into_iter().chain(among_small()).filter_map(whole).collect()
}

/// An input or parameter for which an equation is solved, such that constraints of positions remain unchanged.
fn letter_beside_constraints(there: &Motion<'_, '_>, equation: Sym) -> Option<Sym> {
    if there.squares.is_empty() {
        return None;
    }
    let tied: Vec<Sym> = there.squares.iter().flat_map(|(_, zero)| there.reduced(*zero).symbols_of()).collect();
    let left = there.reduced(equation);
    let inputs = there.trace.model.inputs.iter().map(|input| Sym::symbol(&input.name));
    let letters = inputs.chain(there.trace.parameters.iter().copied()).filter(|letter| !tied.contains(letter));
    let is_solved =
        |letter: &Sym| solution(there.trace, left, Some(*letter)).is_some_and(|found| found.symbol == *letter);
    letters.filter(|letter| left.symbols_of().contains(letter)).find(is_solved)
}

/// The conditions of a motion, and those under which the model has inertia there; at a pole of its coordinates the equations of motion require less.
fn with_inertia(steady: &SteadyMotion<'_, '_>, first: Sym) -> Option<Vec<Condition>> {
    let SteadyMotion { motion, equations, conditions, .. } = steady;
    let regular = motion.reduced(inertia_determinant(motion.trace)?);
    let expressions = equations.iter().map(|(equation, _)| *equation).chain([first, regular]);
    let mut inertia: Vec<Sym> = expressions.flat_map(Sym::symbols_of).collect();
    inertia.retain(|symbol| is_of_inertia(*symbol, motion));
    inertia.sort_unstable();
    inertia.dedup();
    let positive = inertia.into_iter().map(Condition::Positive);
    Some(conditions.iter().copied().chain(positive).chain([Condition::NonZero(regular)]).collect())
}

/// Whether a motion that satisfies the conditions at an instant satisfies them at all later times.
pub(crate) fn all_rests(steady: &SteadyMotion<'_, '_>) -> bool {
    let SteadyMotion { motion, equations, rates, .. } = steady;
    equations.iter().all(|(equation, _)| lasts(*equation, rates, motion.trace))
}

/// Whether all conditions from the equations of motion hold at a point.
pub(crate) fn is_steady(steady: &SteadyMotion<'_, '_>, found: &Refutation) -> bool {
    let SteadyMotion { motion, equations, .. } = steady;
    equations.iter().all(|(equation, _)| {
        let left = motion.reduced(*equation);
        decide(left, &motion.hypotheses).is_zero() || found.value(left) == Some(Sym::ZERO)
    })
}

/// Whether the accelerations at a point satisfy the constraints: a speed that a constraint couples to constant speeds must be constant too.
fn keeps_constraints(steady: &SteadyMotion<'_, '_>, found: &Refutation) -> bool {
    let SteadyMotion { motion, rates, .. } = steady;
    constraints_of(motion.trace).iter().filter(|constraint| constraint.gains.is_none()).all(|constraint| {
        let Ok(change) = crate::letters::rate(motion.trace, constraint.rate) else { return false };
        let left = motion.reduced(change.substitute(rates));
        decide(left, &motion.hypotheses).is_zero() || found.value(left) == Some(Sym::ZERO)
    })
}

/// Whether a printed condition has a nonzero value at a point.
fn fails_at(printed: Sym, found: &Refutation) -> bool {
    found.value(printed).is_some_and(|value| value != Sym::ZERO && crate::refutation::sign(value).is_some())
}

/// Whether an expression is constant where these rates vanish.
fn lasts(expression: Sym, rates: &[(Sym, Sym)], trace: &Trace<'_>) -> bool {
    rate_there(expression, rates, trace).is_some_and(|rate| decide(rate, &Hypotheses::none()).is_zero())
}

/// The time derivative of an expression where these rates vanish, with inputs kept constant.
fn rate_there(expression: Sym, rates: &[(Sym, Sym)], trace: &Trace<'_>) -> Option<Sym> {
    let inputs = trace.model.inputs.iter().map(|input| (Sym::symbol(&input.name), Sym::ONE));
    // the expression must contain no other quantity without a known rate
    crate::letters::rate(trace, expression.substitute(&inputs.collect::<Vec<_>>())).ok()?;
    Some(trace.rate_of(expression).substitute(rates))
}

/// The largest number of times that the conditions of a steady motion are differentiated.
const MOST_RATES: usize = 2;

/// The steady motion with the time derivatives of its conditions, which also vanish since the conditions hold at all times; `None` if further derivatives
/// were necessary.
fn lasting<'t, 'm>(steady: &SteadyMotion<'t, 'm>) -> Option<SteadyMotion<'t, 'm>> {
    let SteadyMotion { motion, equations, printed, conditions, rates } = steady;
    let mut all = SteadyMotion {
        motion: motion.clone(),
        equations: equations.clone(),
        printed: printed.clone(),
        conditions: conditions.clone(),
        rates: rates.clone(),
    };
    for _ in 0..MOST_RATES {
        let mut new: Vec<(Sym, String)> = Vec::new();
        for (equation, name) in &all.equations {
            let rate = motion.reduced(rate_there(*equation, rates, motion.trace)?);
            let is_known = all.equations.iter().chain(&new).any(|(known, _)| *known == rate);
            if !is_known && !decide(rate, &motion.hypotheses).is_zero() {
                new.push((rate, name.clone()));
            }
        }
        if new.is_empty() {
            break;
        }
        all.equations.extend(new);
    }
    all_rests(&all).then_some(all)
}
