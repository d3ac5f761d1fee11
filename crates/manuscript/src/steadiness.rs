//! Claims on conditions of steady motions.

use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::conditions::Hypothesis;
use crate::consequence::{Step, followed, require, step, written_divisors};
use crate::display::{Told, point};
use crate::equation::{Outcome, vanishes};
use crate::finding::Finding;
use crate::implications::condition;
use crate::letters::Letters;
use crate::refutation::Refutation;
use crate::resting_equations::SteadyMotion;
use crate::steady_conditions::{Joint, together};
use crate::verdict::neither;
use claims::{Condition, Judged, Verdict};
use latex::{Statement, read};
use model::Trace;
use reader::Issue;
use symbolic::{Hypotheses, Sym, decide};

/// The condition of the motions on which the letters of `resting` are constant: alone, or together with the claims `beside` about this motion.
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
    let is_too_little = match SteadyMotion::of(claim, &[printed], letters, assumed, finding)? {
        Ok(steady) => alone(&steady, printed, own, letters, assumed, finding, record),
        Err(why) => {
            neither(Outcome::Undecided(why), letters, finding);
            false
        }
    };
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
    let names: Vec<&str> = beside.iter().map(|(_, name)| name.as_str()).collect();
    if let Ok(mut steady) = SteadyMotion::of(claim, &all, letters, assumed, &mut trial)? {
        let written: Vec<Sym> = all.iter().copied().flat_map(written_divisors).collect();
        // a line states nothing where it has no value
        let have_values = written.iter().map(|&divisor| Condition::NonZero(steady.motion.reduced(divisor)));
        let have_values: Vec<Condition> = have_values.collect();
        let given = steady.conditions.len();
        steady.conditions.extend(have_values);
        match together(&steady, &names, assumed, record) {
            // it is wrong with any other claims
            Some(Joint::Other) => return Ok(()),
            Some(found) => {
                // the conditions added above are dropped, so that their divisors are listed as required
                steady.conditions.truncate(given);
                found.told(&steady, &written, letters, &mut trial);
                *finding = trial;
                return Ok(());
            }
            None => {}
        }
    }
    if is_too_little {
        // the point at which this claim fails alone need not satisfy the others
        record.restart();
        finding.judged.counterexample.clear();
        finding.judged.difference = None;
        let why = format!(
            "the printed condition alone is not that of the motion, and it was not decided together with {}",
            names.join(", ")
        );
        neither(Outcome::Undecided(why), letters, finding);
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

/// The verdict on the first printed condition alone; `is` is this condition over the model, as it was read. Returns whether it was refuted since
/// it is too weak.
fn alone(
    steady: &SteadyMotion<'_, '_>,
    is: Sym,
    own: [Sym; 2],
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> bool {
    let SteadyMotion { motion, equations, printed, conditions, rates } = steady;
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
            return finding.judged.verdict == Verdict::Refuted;
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
        // a motion on which all letters are constant satisfies every equation
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
            return false;
        }
        let why = "the equations of motion hold there whenever the printed condition does, and it was not shown that they ask for it";
        let why = open.pop().map_or_else(|| why.to_owned(), |reason| format!("{why}: {reason}"));
        neither(Outcome::Undecided(why), letters, finding);
        return false;
    }
    for divisor in motion.divisors.iter().copied().chain(written_divisors(is)) {
        require(divisor, conditions, letters, finding);
    }
    finding.judged.verdict = Verdict::Proved;
    finding.judged.evidence =
        format!("the printed condition is the equation of {} there, and the others hold", of_print.join(" and of "));
    false
}

/// Whether an expression is constant if these rates are zero.
fn lasts(expression: Sym, rates: &[(Sym, Sym)], trace: &Trace<'_>) -> bool {
    crate::letters::rate(trace, expression)
        .is_ok_and(|rate| decide(rate.substitute(rates), &Hypotheses::none()).is_zero())
}
