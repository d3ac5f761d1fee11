//! Functions that write verdicts with their reasons into findings.

use crate::conditions::Hypothesis;
use crate::display::{Told, tell_point};
use crate::equation::Outcome;
use crate::finding::{Finding, Sides};
use crate::letters::Letters;
use crate::lines::Line;
use crate::motion::Motion;
use crate::refutation::Refutation;
use claims::Verdict;
use model::Trace;
use model::equations::constraints_of;
use symbolic::{Mismatch, Sym, dimension};

/// Writes the verdict of an outcome that neither proves nor refutes.
pub(crate) fn neither(outcome: Outcome, letters: &Letters<'_, '_>, finding: &mut Finding) {
    let (verdict, evidence) = match outcome {
        Outcome::Undefined(denominator) => {
            let why = match letters.told(denominator).to_string().as_str() {
                "undefined" | "0" => {
                    "wherever the hypotheses hold it divides by zero, or has the root of a negative number".to_owned()
                }
                told => format!("it divides by {told}, which vanishes wherever the model and the hypotheses hold"),
            };
            (Verdict::Undefined, why)
        }
        Outcome::Identified(why) => (Verdict::Identified, why),
        Outcome::Undecided(why) => (Verdict::Undecided, why),
        Outcome::Zero(_) | Outcome::NonZero(_) => return,
    };
    (finding.judged.verdict, finding.judged.evidence) = (verdict, evidence);
}

/// The sentence on the permitted use of the model: constraints, equations of motion, hypotheses.
pub(crate) fn allowed(trace: &Trace<'_>, is_dynamic: bool) -> String {
    let constraints = constraints_of(trace).len();
    let held = match constraints {
        0 => String::new(),
        1 => " and the constraint with its derivatives".to_owned(),
        n => format!(" and the {n} equations of constraints with their derivatives"),
    };
    let changes =
        !(trace.model.events.is_empty() && trace.model.switches.is_empty() && trace.model.contacts.is_empty());
    let between = if changes { "between events and changes of contacts and conditions, " } else { "" };
    match (is_dynamic, constraints) {
        (true, _) => format!("{between}along every motion: the claim may use the model's equations of motion{held}"),
        (false, 0) => "identically: for all positions, speeds and accelerations".to_owned(),
        (false, _) => format!(
            "for all positions, speeds and accelerations that the constraints allow:{}",
            held.trim_start_matches(" and")
        ),
    }
}

/// Writes a refutation at an exact point at which the sides of a line differ.
pub(crate) fn refute(
    line: &Line,
    refutation: &Refutation,
    motion: &Motion<'_, '_>,
    told: Told<'_, '_, '_>,
    finding: &mut Finding,
) {
    finding.judged.verdict = Verdict::Refuted;
    let value = |side: Sym| refutation.value(motion.reduced(side)).map(|value| value.to_string());
    finding.sides = value(line.model[0]).zip(value(line.model[1])).map(|(left, right)| Sides { left, right });
    let sides = match &finding.sides {
        Some(Sides { left, right }) => {
            format!("at the exact point the left side is {left} and the right side is {right}")
        }
        None => "at the exact point the sides differ".to_owned(),
    };
    let formal =
        if refutation.is_formal { "; sines and cosines are taken there as independent of their angles" } else { "" };
    finding.judged.evidence = format!("{sides}{formal}");
    tell_point(line.own, refutation, motion, told, finding);
}

/// Adds an objection if a hypothesis has mixed dimensions.
pub(crate) fn mixed_hypotheses(assumed: &[Hypothesis], letters: &Letters<'_, '_>, finding: &mut Finding) {
    let of = |name: &str| letters.dimension(name);
    for hypothesis in assumed {
        let mismatch = hypothesis.own.and_then(|own| dimension(own, &of).err());
        if let Some(mismatch) = mismatch.filter(|mismatch| !matches!(mismatch, Mismatch::Unknown(_))) {
            finding.judged.objections.push(format!("in the hypothesis {}: {mismatch}", hypothesis.told.0));
        }
    }
}
