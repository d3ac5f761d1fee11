//! Claims that two conditions are equivalent.

use crate::admissible::has_positive_parameters;
use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::conditions::{Hypothesis, assume, conditions, scalar};
use crate::consequence::{Step, followed, require, step};
use crate::equation::Outcome;
use crate::finding::Finding;
use crate::letters::Letters;
use crate::motion::Motion;
use crate::natural_domain::written_divisors;
use crate::verdict::neither;
use claims::Verdict;
use latex::{Chain, Relation, Statement};
use reader::Issue;
use symbolic::Sym;

/// A condition `a = b`: the difference in the symbols of the model, and both sides in the paper's letters.
pub(crate) fn condition(claim: &ClaimText, chain: &Chain, letters: &Letters<'_, '_>) -> Result<(Sym, [Sym; 2]), Issue> {
    let ([left, right], [Relation::Equal]) = (&chain.sides[..], &chain.relations[..]) else {
        let issue = Issue::at(claim.formula.span.clone(), "a condition is one equality", "here");
        return Err(issue.accepted(r"a = b, and a = b \iff c = d in an equivalence"));
    };
    let ((left, left_own), (right, right_own)) =
        (scalar(&claim.formula, left, letters)?, scalar(&claim.formula, right, letters)?);
    Ok((left - right, [left_own, right_own]))
}

/// Judges an equivalence `a = b \iff c = d` under its hypotheses.
pub(crate) fn equivalence(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
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
    let mut steps = [(one, other), (other, one)].map(|(zero, then)| {
        let step = step(&motion, zero, then, &conditions);
        record.step(&motion, assumed, [zero, then], &step);
        step
    });
    // a counterexample is preferred to a step without proof, and a counterexample with positive parameters to any other
    steps.sort_by_key(|step| match step {
        Step::Fails(found) => 1 - i32::from(has_positive_parameters(found, &motion)),
        _ => 2,
    });
    let own = [own[0] - own[1], other_own[0] - other_own[1]];
    for step in steps {
        if !followed(step, own, &motion, &conditions, letters, finding) {
            return Ok(());
        }
    }
    let written = [one, other].into_iter().flat_map(written_divisors);
    for divisor in motion.divisors.iter().copied().chain(written) {
        require(divisor, &conditions, letters, finding);
    }
    finding.judged.verdict = Verdict::Proved;
    finding.judged.evidence = "each condition follows from the other: normal form zero".to_owned();
    Ok(())
}
