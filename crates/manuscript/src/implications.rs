//! Conditions that are equivalent, and those of steady motions.

use crate::claim_text::ClaimText;
use crate::conditions::{Hypothesis, assume, conditions, scalar};
use crate::display::{Told, divisors, point};
use crate::equation::{Outcome, vanishes};
use crate::finding::Finding;
use crate::letters::Letters;
use crate::motion::{Motion, Solution, solution};
use crate::refutation::Refutation;
use crate::resting::Resting;
use crate::signs::completed;
use crate::verdict::neither;
use claims::{Condition, Verdict};
use latex::{Chain, Relation, Statement};
use model::equations::{Characteristics, Equations};
use reader::Issue;
use symbolic::Sym;

/// What follows from a condition.
enum Step {
    /// The other one, where this does not vanish.
    Follows(Sym),
    /// Not the other one.
    Fails(Refutation),
    Open(Outcome),
}

/// Whether `then` vanishes where `zero` does.
fn step(motion: &Motion<'_, '_>, zero: Sym, then: Sym, conditions: &[Condition]) -> Step {
    let zero = motion.reduced(zero);
    let Some(Solution { symbol, value, divisor }) = solution(motion.trace, zero, None) else {
        let why = "a condition is linear in none of its letters, so that it was not solved";
        return Step::Open(Outcome::Undecided(why.to_owned()));
    };
    let there = motion.reduced(then).substitute(&[(symbol, value)]);
    match vanishes(motion, there, &[]) {
        Outcome::Zero(_) => Step::Follows(divisor),
        Outcome::NonZero(mut refutation) => {
            if let Some(value) = refutation.value(value) {
                refutation.point.push((symbol, value));
            }
            match completed(refutation, conditions) {
                Some(refutation) => Step::Fails(refutation),
                None => {
                    Step::Open(Outcome::Undecided("no exact point was found that satisfies the hypotheses".to_owned()))
                }
            }
        }
        other => Step::Open(other),
    }
}

/// A condition of the form `a = b`.
fn condition(claim: &ClaimText, chain: &Chain, letters: &Letters<'_, '_>) -> Result<(Sym, [Sym; 2]), Issue> {
    let ([left, right], [Relation::Equal]) = (&chain.sides[..], &chain.relations[..]) else {
        let issue = Issue::at(claim.formula.span.clone(), "a condition is one equality", "here");
        return Err(issue.accepted(r"a = b, and a = b \iff c = d in an equivalence"));
    };
    let ((left, left_own), (right, right_own)) =
        (scalar(&claim.formula, left, letters)?, scalar(&claim.formula, right, letters)?);
    Ok((left - right, [left_own, right_own]))
}

/// `a = b \iff c = d`, where the hypotheses hold.
pub(crate) fn equivalence(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
) -> Result<(), Issue> {
    let [first, second] = &statement.chains[..] else {
        let issue = Issue::at(claim.formula.span.clone(), "an equivalence has two conditions", "here");
        return Err(issue.accepted(r"a = b \iff c = d"));
    };
    let ((one, own), (other, other_own)) = (condition(claim, first, letters)?, condition(claim, second, letters)?);
    let told = |[left, right]: [Sym; 2]| (format!("{left} = {right}"), format!("{} = {}", left.latex(), right.latex()));
    let ((text, latex), (other_text, other_latex)) = (told(own), told(other_own));
    finding.judged.text = vec![format!("{text} <=> {other_text}")];
    finding.judged.latex = vec![format!(r"{latex} \iff {other_latex}")];
    let mut motion = match Motion::by_equations(letters.trace) {
        Ok(motion) => motion,
        Err(why) => {
            neither(Outcome::Undecided(why), letters, finding);
            return Ok(());
        }
    };
    assume(&mut motion, assumed)?;
    let conditions = conditions(&motion, assumed);
    finding.allowed = "each condition is solved for one of its letters, and put into the other".to_owned();
    for (zero, then) in [(one, other), (other, one)] {
        let own = [own[0] - own[1], other_own[0] - other_own[1]];
        if !followed(step(&motion, zero, then, &conditions), own, &motion, &conditions, letters, finding) {
            return Ok(());
        }
    }
    for &divisor in &motion.divisors {
        require(divisor, &conditions, letters, finding);
    }
    finding.judged.verdict = Verdict::Proved;
    finding.judged.evidence = "each condition follows from the other: normal form zero".to_owned();
    Ok(())
}

/// Whether a step holds; else the verdict is told. A divisor that may vanish makes it undecided, unless a hypothesis excludes that.
fn followed(
    step: Step,
    own: [Sym; 2],
    motion: &Motion<'_, '_>,
    conditions: &[Condition],
    letters: &Letters<'_, '_>,
    finding: &mut Finding,
) -> bool {
    match step {
        Step::Follows(divisor) => {
            require(divisor, conditions, letters, finding);
            true
        }
        Step::Fails(refutation) => {
            finding.judged.verdict = Verdict::Refuted;
            finding.judged.evidence = "at the exact point one condition holds and the other does not".to_owned();
            finding.judged.counterexample = point(own, &refutation, motion, Told(letters));
            false
        }
        Step::Open(outcome) => {
            neither(outcome, letters, finding);
            false
        }
    }
}

/// Lists the factors of a divisor that no hypothesis keeps from vanishing.
fn require(divisor: Sym, conditions: &[Condition], letters: &Letters<'_, '_>, finding: &mut Finding) {
    let known = conditions.iter().filter_map(|condition| match condition {
        Condition::NonZero(e) | Condition::Positive(e) => Some(*e),
        _ => None,
    });
    let known = divisors(&known.collect::<Vec<Sym>>(), Told(letters));
    for line in divisors(&[divisor], Told(letters)) {
        if !known.contains(&line) && !finding.judged.requires.contains(&line) {
            finding.judged.requires.push(line);
        }
    }
}

/// The condition of the motions on which the letters of `resting` are constant.
pub(crate) fn steady_motion(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
) -> Result<(), Issue> {
    let [chain] = &statement.chains[..] else {
        let issue = Issue::at(claim.formula.span.clone(), "a steady motion has one condition", "here");
        return Err(issue.accepted("a = b"));
    };
    let (printed, own) = condition(claim, chain, letters)?;
    finding.judged.text = vec![format!("{} = {}", own[0], own[1])];
    finding.judged.latex = vec![format!("{} = {}", own[0].latex(), own[1].latex())];
    let trace = letters.trace;
    let mut motion = Motion::by_constraints(trace);
    motion.set(Resting::of(claim, letters)?.rates(letters));
    assume(&mut motion, assumed)?;
    let conditions = conditions(&motion, assumed);
    let all = Equations::of(trace);
    let inertia: Vec<Sym> = (all.mass.iter().zip(&all.bias))
        .map(|(row, &bias)| row.iter().zip(&trace.accelerations).fold(bias, |sum, (&entry, &rate)| sum + entry * rate))
        .collect();
    let equations = match all.constraints.is_empty() {
        true => inertia,
        false => Characteristics::of(trace, &all.constraints).along(&inertia),
    };
    let names: Vec<String> = (0..equations.len()).map(|k| trace.direction(k)).collect();
    finding.allowed = format!(
        "the equations of motion where {} rest",
        claim.resting.iter().map(|one| one.text.as_str()).collect::<Vec<_>>().join(", ")
    );
    let own = [own[0] - own[1], Sym::ZERO];
    let mut of_print: Vec<String> = Vec::new();
    for (equation, name) in equations.iter().zip(&names) {
        let reduced = motion.reduced(*equation);
        if let Outcome::Zero(_) = vanishes(&motion, reduced, &conditions) {
            continue;
        }
        if !followed(step(&motion, printed, reduced, &conditions), own, &motion, &conditions, letters, finding) {
            if finding.judged.verdict == Verdict::Refuted {
                finding.judged.evidence =
                    format!("at the exact point the printed condition holds and the equation of {name} does not");
                crate::display::told_difference(reduced, &motion, Told(letters), finding);
            }
            return Ok(());
        }
        if let Step::Follows(divisor) = step(&motion, reduced, printed, &conditions) {
            of_print.push(name.clone());
            require(divisor, &conditions, letters, finding);
        }
    }
    if of_print.is_empty() {
        let why = "the equations of motion hold there whenever the printed condition does, and it was not shown that they ask for it";
        neither(Outcome::Undecided(why.to_owned()), letters, finding);
        return Ok(());
    }
    for &divisor in &motion.divisors {
        require(divisor, &conditions, letters, finding);
    }
    finding.judged.verdict = Verdict::Proved;
    finding.judged.evidence =
        format!("the printed condition is the equation of {} there, and the others hold", of_print.join(" and of "));
    Ok(())
}
