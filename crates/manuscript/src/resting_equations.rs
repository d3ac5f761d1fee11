//! The conditions under which letters are constant along a motion: the equations of motion without reactions and accelerations.

use crate::claim_text::ClaimText;
use crate::conditions::{Hypothesis, assume, conditions};
use crate::consequence::{is_apart, require};
use crate::determinant::determinant;
use crate::finding::Finding;
use crate::letters::Letters;
use crate::motion::{Motion, solution};
use crate::steady_motion::Resting;
use claims::Condition;
use model::Trace;
use model::equations::{Characteristics, Equation, Equations, constraints_of, solved};
use reader::Issue;
use symbolic::{Hypotheses, Sym, decide, normal};

/// The motions on which letters are constant, with the conditions that follow from the equations of motion.
pub(crate) struct SteadyMotion<'t, 'm> {
    pub motion: Motion<'t, 'm>,
    /// The conditions as expressions that vanish, each with the name of the coordinate of its equation.
    pub equations: Vec<(Sym, String)>,
    /// The printed conditions, as expressions.
    pub printed: Vec<Sym>,
    pub conditions: Vec<Condition>,
    pub rates: Vec<(Sym, Sym)>,
}

impl<'t, 'm> SteadyMotion<'t, 'm> {
    /// The conditions without reactions and accelerations. Divisors are added to the requirements of the finding.
    ///
    /// # Errors
    /// A fault of the file (outer result), or the reason for which there are no such conditions (inner result).
    pub fn of(
        claim: &ClaimText,
        printed: &[Sym],
        letters: &Letters<'t, 'm>,
        assumed: &[Hypothesis],
        finding: &mut Finding,
    ) -> Result<Result<Self, String>, Issue> {
        let trace = letters.trace;
        let rates = Resting::of(claim, letters)?.rates(letters);
        let mut motion = Motion::at_rest(trace, &rates);
        assume(&mut motion, assumed)?;
        let conditions = conditions(&motion, assumed);
        let all = Equations::of(trace);
        let inertia: Vec<Sym> = (all.mass.iter().zip(&all.bias))
            .map(|(row, &bias)| {
                row.iter().zip(&trace.accelerations).fold(bias, |sum, (&entry, &rate)| sum + entry * rate)
            })
            .collect();
        let places = connected(&all, |k| rates.iter().any(|(rate, _)| *rate == trace.accelerations[k]));
        let mut equations: Vec<(Sym, String)> = match all.constraints.is_empty() {
            true => places.iter().map(|&k| (inertia[k], trace.direction(k))).collect(),
            false => without_reactions(trace, &all.constraints, &inertia, &places),
        };
        equations.iter_mut().for_each(|(equation, _)| *equation = motion.reduced(*equation));
        let mut printed: Vec<Sym> = printed.iter().map(|&one| motion.reduced(one)).collect();
        let moving: Vec<Sym> =
            trace.accelerations.iter().copied().filter(|one| rates.iter().all(|(rate, _)| rate != one)).collect();
        // equations that are as many as the nonzero accelerations in them only determine these accelerations
        let holds_one = |equation: Sym| moving.iter().any(|one| equation.symbols_of().contains(one));
        let is_held = |one: &&Sym| equations.iter().any(|(equation, _)| equation.symbols_of().contains(one));
        let held = moving.iter().filter(is_held).count();
        if held == equations.iter().filter(|(equation, _)| holds_one(*equation)).count()
            && !printed.iter().any(|one| holds_one(*one))
        {
            equations.retain(|(equation, _)| !holds_one(*equation));
        }
        match determined(&moving, &mut equations, &mut motion, &mut printed, &conditions) {
            Ok(divided) => divided.into_iter().for_each(|pivot| require(pivot, &conditions, letters, finding)),
            Err(acceleration) => {
                let told = letters.told(acceleration);
                return Ok(Err(format!("{told} was not given by the equations of motion")));
            }
        }
        for one in &mut printed {
            if let Some(reaction) = motion.undetermined(*one) {
                match reactions(trace) {
                    Some(values) => *one = motion.reduced(one.substitute(&values)),
                    None => {
                        let told = letters.told(reaction);
                        return Ok(Err(format!("{told} is not given by the equations of motion")));
                    }
                }
            }
        }
        Ok(Ok(SteadyMotion { motion, equations, printed, conditions, rates }))
    }
}

/// The largest number of equations that are combined without divisions.
const MOST_SPEEDS: usize = 7;

/// The equations of motion without reactions of constraints: determinants of rows of constraints and equations, which
/// need no division, or, for many constraints, combinations along the independent speeds.
fn without_reactions(
    trace: &Trace<'_>,
    constraints: &[Equation],
    inertia: &[Sym],
    places: &[usize],
) -> Vec<(Sym, String)> {
    let acts = |one: &&Equation| places.iter().any(|&k| one.row[k] != Sym::ZERO);
    let rows: Vec<&Equation> = constraints.iter().filter(acts).collect();
    let (free, places) = free_directions(&rows, inertia, places, trace);
    if places.len() > MOST_SPEEDS || rows.len() > MOST_CONSTRAINTS {
        let along = Characteristics::of(trace, constraints).along(inertia);
        return along.into_iter().enumerate().map(|(k, equation)| (equation, trace.direction(k))).collect();
    }
    let of = |columns: Vec<usize>| {
        let above = rows.iter().map(|one| columns.iter().map(|&k| one.row[k]).collect());
        let all: Vec<Vec<Sym>> = above.chain([columns.iter().map(|&k| inertia[k]).collect()]).collect();
        let names: Vec<String> = columns.iter().map(|&k| trace.direction(k)).collect();
        (determinant(&all), names.join(" and "))
    };
    let choices = chosen(0, places.len(), rows.len() + 1).into_iter();
    let tied = choices
        .map(|choice| of(choice.into_iter().map(|place| places[place]).collect()))
        .filter(|(equation, _)| *equation != Sym::ZERO);
    free.into_iter().chain(tied).collect()
}

/// The equations along virtual displacements that the constraints allow everywhere (of one coordinate, or of two with a numerical ratio), and the
/// indices of the remaining coordinates.
fn free_directions(
    rows: &[&Equation],
    inertia: &[Sym],
    places: &[usize],
    trace: &Trace<'_>,
) -> (Vec<(Sym, String)>, Vec<usize>) {
    let (mut free, mut left): (Vec<(Sym, String)>, Vec<usize>) = (Vec::new(), Vec::new());
    for &k in places {
        if rows.iter().all(|one| one.row[k] == Sym::ZERO) {
            free.push((inertia[k], trace.direction(k)));
            continue;
        }
        match left.iter().find_map(|&j| Some((j, ratio(rows, k, j)?))) {
            Some((j, ratio)) => {
                let name = format!("{} and {}", trace.direction(j), trace.direction(k));
                free.push((inertia[k] - ratio * inertia[j], name));
            }
            None => left.push(k),
        }
    }
    (free, left)
}

/// The number by which the column of one coordinate in the constraints is a multiple of that of another; `None` if there is none.
fn ratio(rows: &[&Equation], of: usize, to: usize) -> Option<Sym> {
    let first = rows.iter().find(|one| one.row[to] != Sym::ZERO)?;
    let ratio = normal(first.row[of] / first.row[to], &Hypotheses::none()).ok()?.to_sym();
    let is_it = |one: &&Equation| decide(one.row[of] - ratio * one.row[to], &Hypotheses::none()).is_zero();
    (ratio.as_constant().is_some() && rows.iter().all(is_it)).then_some(ratio)
}

/// The largest number of constraints for which determinants are expanded.
const MOST_CONSTRAINTS: usize = 3;

/// All choices of `count` indices from `from` to `end` - 1.
fn chosen(from: usize, end: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let after =
        |first: usize| chosen(first + 1, end, count - 1).into_iter().map(move |rest| [vec![first], rest].concat());
    (from..end).flat_map(after).collect()
}

/// The divisors with which equations of motion determine the accelerations that are not zero. These equations are removed from the conditions.
///
/// # Errors
/// A divisor that may vanish.
fn determined(
    moving: &[Sym],
    equations: &mut Vec<(Sym, String)>,
    motion: &mut Motion<'_, '_>,
    printed: &mut [Sym],
    conditions: &[Condition],
) -> Result<Vec<Sym>, Sym> {
    let mut divided = Vec::new();
    for &acceleration in moving {
        let holds_it = |expression: Sym| expression.symbols_of().contains(&acceleration);
        if !printed.iter().any(|one| holds_it(*one)) && !equations.iter().any(|(equation, _)| holds_it(*equation)) {
            continue;
        }
        let found = equations.iter().enumerate().find_map(|(place, (equation, _))| {
            let found = solution(motion.trace, *equation, Some(acceleration))?;
            (found.symbol == acceleration && is_apart(found.divisor, motion, conditions)).then_some((place, found))
        });
        let (place, found) = found.ok_or(acceleration)?;
        equations.remove(place);
        divided.push(found.divisor);
        motion.set(vec![(acceleration, found.value)]);
        equations.iter_mut().for_each(|(equation, _)| *equation = motion.reduced(*equation));
        printed.iter_mut().for_each(|one| *one = motion.reduced(*one));
    }
    Ok(divided)
}

/// The indices of speeds that inertia or constraints couple to a constant speed, directly or through other speeds.
fn connected(all: &Equations, rests: impl Fn(usize) -> bool) -> Vec<usize> {
    let n = all.mass.len();
    let mut is_in: Vec<bool> = (0..n).map(rests).collect();
    let is_linked = |k: usize, j: usize| {
        let by_constraint = |one: &Equation| one.row[k] != Sym::ZERO && one.row[j] != Sym::ZERO;
        all.mass[k][j] != Sym::ZERO || all.constraints.iter().any(by_constraint)
    };
    while let Some(next) = (0..n).find(|&k| !is_in[k] && (0..n).any(|j| is_in[j] && is_linked(k, j))) {
        is_in[next] = true;
    }
    (0..n).filter(|&k| is_in[k]).collect()
}

/// The multipliers of constraints with their values along every motion.
fn reactions(trace: &Trace<'_>) -> Option<Vec<(Sym, Sym)>> {
    let (_, multipliers) = solved(trace).ok()?;
    Some(constraints_of(trace).iter().map(|one| one.multiplier).zip(multipliers).collect())
}
