//! Claims about the conditions of steady motions.

use crate::admissible::has_positive_parameters;
use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::conditions::Hypothesis;
use crate::consequence::{Step, followed, require, step};
use crate::display::{Told, tell_point};
use crate::equation::{Outcome, vanishes};
use crate::finding::Finding;
use crate::implications::condition;
use crate::letters::Letters;
use crate::natural_domain::written_divisors;
use crate::refutation::Refutation;
use crate::resting_equations::SteadyMotion;
use crate::shortfall::tell_shortfall;
use crate::steady_conditions::{Joint, together};
use crate::steady_refutation::{all_rests, failing_motion, is_steady};
use crate::verdict::neither;
use claims::{Condition, Judged, Verdict};
use latex::{Statement, read};
use reader::Issue;
use symbolic::{Sym, decide};

/// Judges the condition of the motions on which the letters of `resting` are constant, alone or together with the claims `beside` about this motion.
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
    let print = Print { is: printed, own: [own[0] - own[1], Sym::ZERO], letters, assumed };
    let of = |other: &&ClaimText| {
        let statement = read(&other.formula.text, &letters.spelt()).ok()?;
        of_statement(other, &statement, letters).ok().map(|(zero, _)| (zero, other.key()))
    };
    let mut beside: Vec<(Sym, String)> = beside.iter().filter_map(of).collect();
    let is_too_little = match SteadyMotion::of(claim, &[printed], letters, assumed, finding)? {
        Ok(steady) => {
            let is_empty = |zero: Sym| decide(steady.motion.reduced(zero), &steady.motion.hypotheses).is_zero();
            if is_empty(printed) {
                finding.judged.verdict = Verdict::Undefined;
                finding.judged.evidence =
                    "both sides are equal wherever the letters of `resting` are constant, so that no condition is stated".to_owned();
                return Ok(());
            }
            beside.retain(|(zero, _)| !is_empty(*zero));
            let is_too_little = alone(&steady, &print, finding, record);
            if finding.judged.verdict == Verdict::Undecided
                && let Some(found) = failing_motion(&steady)
            {
                print.fails(&steady, &found, &[], finding, record);
            }
            is_too_little
        }
        Err(why) => {
            neither(Outcome::Undecided(why), letters, finding);
            false
        }
    };
    if beside.is_empty() || finding.judged.verdict == Verdict::Proved {
        return Ok(());
    }
    let all: Vec<Sym> = [printed].into_iter().chain(beside.iter().map(|(zero, _)| *zero)).collect();
    let mut trial = Finding { judged: Judged { requires: presupposed, ..finding.judged.clone() }, ..finding.clone() };
    let names: Vec<&str> = beside.iter().map(|(_, name)| name.as_str()).collect();
    if let Ok(mut steady) = SteadyMotion::of(claim, &all, letters, assumed, &mut trial)? {
        let written: Vec<Sym> = all.iter().copied().flat_map(written_divisors).collect();
        // a line states something only where it has a value
        let have_values = written.iter().map(|&divisor| Condition::NonZero(steady.motion.reduced(divisor)));
        let have_values: Vec<Condition> = have_values.collect();
        let given = steady.conditions.len();
        steady.conditions.extend(have_values);
        let joint = together(&steady, &names, assumed, record);
        // if the other conditions do not complete it, or this was not proved, a motion may refute it
        if matches!(joint, None | Some(Joint::Other))
            && (is_too_little && joint.is_none() || finding.judged.verdict == Verdict::Undecided)
            && let Some(found) = failing_motion(&steady)
        {
            print.fails(&steady, &found, &names, finding, record);
            return Ok(());
        }
        match joint {
            Some(Joint::Other) => return Ok(()),
            Some(found) => {
                // the conditions added above are removed, so that their divisors are listed as requirements
                steady.conditions.truncate(given);
                found.told(&steady, &written, letters, &mut trial);
                *finding = trial;
                return Ok(());
            }
            None => {}
        }
    }
    if is_too_little {
        // the counterexample to this claim alone need not satisfy the other conditions
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

/// The condition that a claim prints, in the symbols of the model, with both of its sides in the paper's letters.
fn of_statement(claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Result<(Sym, [Sym; 2]), Issue> {
    match &statement.chains[..] {
        [chain] => condition(claim, chain, letters),
        _ => {
            let issue = Issue::at(claim.formula.span.clone(), "a steady motion has one condition", "here");
            Err(issue.accepted("a = b"))
        }
    }
}

/// A printed condition.
struct Print<'a, 't, 'm> {
    /// The condition in the symbols of the model, as it was read.
    is: Sym,
    /// The sides of the condition in the paper's letters, with zero as the right side.
    own: [Sym; 2],
    letters: &'a Letters<'t, 'm>,
    assumed: &'a [Hypothesis],
}

impl Print<'_, '_, '_> {
    /// Writes a refutation: the letters are constant along a motion on which the printed condition fails. `names` are those of the other conditions.
    fn fails(
        &self,
        steady: &SteadyMotion<'_, '_>,
        found: &Refutation,
        names: &[&str],
        finding: &mut Finding,
        record: &mut Record,
    ) {
        let SteadyMotion { motion, equations, printed, .. } = steady;
        let zeros: Vec<Sym> = equations.iter().map(|(equation, _)| motion.reduced(*equation)).collect();
        record.restart();
        record.fails_where(motion, self.assumed, &zeros, printed[0], found);
        let holding = names.iter().zip(&printed[1..]).filter(|(_, other)| found.value(**other) == Some(Sym::ZERO));
        let holding: Vec<&str> = holding.map(|(name, _)| *name).collect();
        let beside = match holding.len() {
            0 => String::new(),
            1 => format!(", while that of {} does", holding[0]),
            _ => format!(", while those of {} do", holding.join(", ")),
        };
        finding.judged.verdict = Verdict::Refuted;
        finding.judged.evidence = format!(
            "at the exact point the letters rest along a motion, and the printed condition does not hold{beside}"
        );
        finding.judged.difference = None;
        let told = Told(self.letters);
        let is_open = |(equation, _): &&(Sym, String)| !decide(motion.reduced(*equation), &motion.hypotheses).is_zero();
        if let Some((equation, name)) = equations.iter().find(is_open) {
            tell_shortfall((printed[0], self.own), (motion.reduced(*equation), name), steady, told, finding);
        }
        tell_point(self.own, found, motion, told, finding);
    }
}

/// Judges the first printed condition alone; returns whether it was refuted because it is not sufficient.
fn alone(steady: &SteadyMotion<'_, '_>, print: &Print<'_, '_, '_>, finding: &mut Finding, record: &mut Record) -> bool {
    let SteadyMotion { motion, equations, printed, conditions, .. } = steady;
    let &Print { is, own, letters, assumed } = print;
    let printed = printed[0];
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
        // a motion that violates the printed condition is preferred if only this one has positive parameters
        if matches!(&of_equation, Step::Fails(found) if !has_positive_parameters(found, motion))
            && let Some(found) = failing_motion(steady).filter(|found| has_positive_parameters(found, motion))
        {
            print.fails(steady, &found, &[], finding, record);
            return false;
        }
        if !followed(of_equation, own, motion, conditions, letters, finding) {
            if finding.judged.verdict == Verdict::Refuted {
                finding.judged.evidence =
                    format!("at the exact point the printed condition holds and the equation of {name} does not");
                tell_shortfall((printed, own), (reduced, name), steady, Told(letters), finding);
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
        // along a motion on which all letters are constant, every equation stays satisfied
        let rests = all_rests(steady);
        if let Some(found) = failing.iter().find(|found| rests && is_steady(steady, found)) {
            let is_usual = |found: &Refutation| has_positive_parameters(found, motion);
            let usual = if is_usual(found) { None } else { failing_motion(steady).filter(is_usual) };
            print.fails(steady, usual.as_ref().unwrap_or(found), &[], finding, record);
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
