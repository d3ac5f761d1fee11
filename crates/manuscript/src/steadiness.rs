//! Conditions of steady motions.

use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::conditions::{Hypothesis, assume, conditions};
use crate::consequence::{Step, followed, is_apart, require, step, written_divisors};
use crate::display::{Told, point};
use crate::equation::{Outcome, vanishes};
use crate::finding::Finding;
use crate::implications::condition;
use crate::letters::Letters;
use crate::linear_motion::determinant;
use crate::motion::{Motion, solution};
use crate::refutation::Refutation;
use crate::steady_conditions::together;
use crate::steady_motion::Resting;
use crate::verdict::neither;
use claims::{Condition, Judged, Verdict};
use latex::{Statement, read};
use model::Trace;
use model::equations::{Characteristics, Equation, Equations, constraints_of, solved};
use reader::Issue;
use symbolic::{Hypotheses, Sym, decide};

/// The condition of the motions on which the letters of `resting` are constant: alone, or together with those of `beside`, which name the same motion.
pub(crate) fn steady_motion(
    claim: &ClaimText,
    beside: &[&ClaimText],
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    let (printed, own) = of_statement(claim, statement, letters)?;
    finding.judged.text = vec![format!("{} = {}", own[0], own[1])];
    finding.judged.latex = vec![format!("{} = {}", own[0].latex(), own[1].latex())];
    finding.allowed = format!(
        "the equations of motion where {} rest",
        claim.resting.iter().map(|one| one.text.as_str()).collect::<Vec<_>>().join(", ")
    );
    let presupposed = finding.judged.requires.clone();
    match SteadyMotion::of(claim, &[printed], letters, assumed, finding)? {
        Ok(steady) => steady.alone(printed, own, letters, assumed, finding, record),
        Err(why) => neither(Outcome::Undecided(why), letters, finding),
    }
    if beside.is_empty() || finding.judged.verdict == Verdict::Proved {
        return Ok(());
    }
    let of = |other: &&ClaimText| {
        let statement = read(&other.formula.text, &letters.spelt()).ok()?;
        of_statement(other, &statement, letters).ok().map(|(zero, _)| (zero, other.key()))
    };
    let beside: Vec<(Sym, String)> = beside.iter().filter_map(of).collect();
    let all: Vec<Sym> = [printed].into_iter().chain(beside.iter().map(|(zero, _)| *zero)).collect();
    let mut trial = Finding { judged: Judged { requires: presupposed, ..finding.judged.clone() }, ..finding.clone() };
    if let Ok(steady) = SteadyMotion::of(claim, &all, letters, assumed, &mut trial)? {
        let names: Vec<&str> = beside.iter().map(|(_, name)| name.as_str()).collect();
        let written: Vec<Sym> = all.iter().copied().flat_map(written_divisors).collect();
        if let Some(found) = together(&steady, &names, assumed, record) {
            found.told(&steady, &written, letters, &mut trial);
            *finding = trial;
        }
    }
    Ok(())
}

/// The condition that a claim prints, over the model, with both of its sides.
fn of_statement(claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Result<(Sym, [Sym; 2]), Issue> {
    match &statement.chains[..] {
        [chain] => condition(claim, chain, letters),
        _ => {
            let issue = Issue::at(claim.formula.span.clone(), "a steady motion has one condition", "here");
            Err(issue.accepted("a = b"))
        }
    }
}

/// Motions on which letters rest: what the equations of motion ask of them.
pub(crate) struct SteadyMotion<'t, 'm> {
    pub motion: Motion<'t, 'm>,
    /// With the coordinates of their equations.
    pub equations: Vec<(Sym, String)>,
    /// The printed conditions.
    pub printed: Vec<Sym>,
    pub conditions: Vec<Condition>,
    rates: Vec<(Sym, Sym)>,
}

impl<'t, 'm> SteadyMotion<'t, 'm> {
    /// The equations that hold no reaction and no acceleration. What was divided by is listed in the finding.
    ///
    /// # Errors
    /// All that is wrong in the file; else, inside, why there are no such equations.
    fn of(
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
        // as many equations as such accelerations give these, and state nothing else
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

    /// The verdict on the first of the printed conditions by itself; `is` is that over the model, as it was read.
    fn alone(
        &self,
        is: Sym,
        own: [Sym; 2],
        letters: &Letters<'_, '_>,
        assumed: &[Hypothesis],
        finding: &mut Finding,
        record: &mut Record,
    ) {
        let SteadyMotion { motion, equations, printed, conditions, rates } = self;
        let (printed, own) = (printed[0], [own[0] - own[1], Sym::ZERO]);
        let mut of_print: Vec<String> = Vec::new();
        let mut failing: Vec<Refutation> = Vec::new();
        let mut open: Vec<String> = Vec::new();
        for (equation, name) in equations {
            let reduced = motion.reduced(*equation);
            if let Outcome::Zero(_) = vanishes(motion, reduced, conditions) {
                record.vanishes(motion, assumed, &[Condition::Zero(*equation)]);
                continue;
            }
            let of_equation = step(motion, printed, reduced, conditions);
            record.step(motion, assumed, [printed, reduced], &of_equation);
            if !followed(of_equation, own, motion, conditions, letters, finding) {
                if finding.judged.verdict == Verdict::Refuted {
                    finding.judged.evidence =
                        format!("at the exact point the printed condition holds and the equation of {name} does not");
                    crate::display::told_difference(reduced, motion, Told(letters), finding);
                }
                return;
            }
            match step(motion, reduced, printed, conditions) {
                of_print_itself @ Step::Follows(..) => {
                    record.step(motion, assumed, [reduced, printed], &of_print_itself);
                    let Step::Follows(divided, _) = of_print_itself else { continue };
                    of_print.push(name.clone());
                    divided.into_iter().for_each(|divisor| require(divisor, conditions, letters, finding));
                }
                Step::Fails(refutation) => failing.push(refutation),
                Step::Open(Outcome::Undecided(why)) => open.push(why),
                Step::Open(_) => {}
            }
        }
        if of_print.is_empty() {
            // a motion on which all of it rests satisfies every equation
            let is_steady = |found: &Refutation| {
                equations.iter().all(|(equation, _)| {
                    let left = motion.reduced(*equation);
                    decide(left, &motion.hypotheses).is_zero() || found.value(left) == Some(Sym::ZERO)
                })
            };
            let rests = equations.iter().all(|(equation, _)| lasts(*equation, rates, motion.trace));
            if let Some(found) = failing.iter().find(|found| rests && is_steady(found)) {
                let zeros: Vec<Sym> = equations.iter().map(|(equation, _)| motion.reduced(*equation)).collect();
                record.fails_where(motion, assumed, &zeros, printed, found);
                finding.judged.verdict = Verdict::Refuted;
                finding.judged.evidence =
                    "at the exact point the letters rest along a motion, and the printed condition does not hold"
                        .to_owned();
                finding.judged.counterexample = point(own, found, motion, Told(letters));
                return;
            }
            let why = "the equations of motion hold there whenever the printed condition does, and it was not shown that they ask for it";
            let why = open.pop().map_or_else(|| why.to_owned(), |reason| format!("{why}: {reason}"));
            neither(Outcome::Undecided(why), letters, finding);
            return;
        }
        for divisor in motion.divisors.iter().copied().chain(written_divisors(is)) {
            require(divisor, conditions, letters, finding);
        }
        finding.judged.verdict = Verdict::Proved;
        finding.judged.evidence = format!(
            "the printed condition is the equation of {} there, and the others hold",
            of_print.join(" and of ")
        );
    }
}

/// Combinations of more equations divide.
const MOST_SPEEDS: usize = 7;

/// Equations of motion without the reactions of constraints: determinants of the rows of constraints with the equations below them, which
/// divide by nothing; where those are many, the combinations along the speeds that stay free.
fn without_reactions(
    trace: &Trace<'_>,
    constraints: &[Equation],
    inertia: &[Sym],
    places: &[usize],
) -> Vec<(Sym, String)> {
    let acts = |one: &&Equation| places.iter().any(|&k| one.row[k] != Sym::ZERO);
    let rows: Vec<&Equation> = constraints.iter().filter(acts).collect();
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
    choices
        .map(|choice| of(choice.into_iter().map(|place| places[place]).collect()))
        .filter(|(equation, _)| *equation != Sym::ZERO)
        .collect()
}

/// Determinants of more rows are not expanded.
const MOST_CONSTRAINTS: usize = 3;

/// Every choice of so many places from here on.
fn chosen(from: usize, end: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let after =
        |first: usize| chosen(first + 1, end, count - 1).into_iter().map(move |rest| [vec![first], rest].concat());
    (from..end).flat_map(after).collect()
}

/// Accelerations that do not rest are given by equations of motion, which state nothing else then. What was divided by.
///
/// # Errors
/// One of them is given by no equation without a divisor that may vanish.
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

/// Directions that inertia or a constraint connects with one that rests, from one to the next.
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

/// The multipliers of constraints along every motion.
fn reactions(trace: &Trace<'_>) -> Option<Vec<(Sym, Sym)>> {
    let (_, multipliers) = solved(trace).ok()?;
    Some(constraints_of(trace).iter().map(|one| one.multiplier).zip(multipliers).collect())
}

/// Whether an expression stays as it is where these rates vanish.
fn lasts(expression: Sym, rates: &[(Sym, Sym)], trace: &Trace<'_>) -> bool {
    crate::letters::rate(trace, expression)
        .is_ok_and(|rate| decide(rate.substitute(rates), &Hypotheses::none()).is_zero())
}
