//! Claims that are equalities along motions: equations of motion, values of quantities, identities.

use crate::certificate::Record;
use crate::claim_text::{ClaimText, Kind};
use crate::combination::{Combination, told_combination};
use crate::conditions::{Hypothesis, assume, conditions};
use crate::display::{Told, divisors, missing, shown};
use crate::equation::{Outcome, vanishes, vanishes_or_fails};
use crate::finding::Finding;
use crate::half_turn::sign_of_number;
use crate::letters::Letters;
use crate::lines::{Line, lines};
use crate::lost_divisors::Lost;
use crate::motion::Motion;
use crate::real_signs::are_equal_by_squares;
use crate::signs::without_real_value;
use crate::verdict::{allowed, neither, refute};
use claims::certificate::PartProof;
use claims::{Condition, Verdict};
use latex::Statement;
use reader::Issue;
use symbolic::{Hypotheses, Sym, decide};

/// Judges an equality: for all states that the constraints allow or, unless the claim is an identity, along every motion.
pub(crate) fn equalities(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    let lines = lines(claim, statement, letters)?;
    let told = Told(letters);
    (finding.judged.text, finding.judged.latex) = lines.iter().map(|line| shown(line.own)).unzip();
    let trace = letters.trace;
    let mut by_constraints = Motion::by_constraints(trace);
    assume(&mut by_constraints, assumed)?;
    let mut along = match claim.kind {
        Kind::Identity => None,
        _ => Some(Motion::by_equations(trace)),
    };
    if let Some(Ok(motion)) = &mut along {
        assume(motion, assumed)?;
    }
    let mut requires: Vec<Sym> = Vec::new();
    let (mut is_dynamic, mut by_squares) = (false, false);
    let mut combined = None;
    let are_free = assumed.iter().all(|hypothesis| hypothesis.equality.is_none());
    finding.judged.verdict = Verdict::Proved;
    for line in &lines {
        let difference = line.model[0] - line.model[1];
        let equal = Condition::Equal(line.model[0], line.model[1]);
        if let (Some(Ok(motion)), true) = (&along, are_free)
            && let Some(combination) = Combination::of(difference, motion)
        {
            is_dynamic = true;
            combination.recorded(motion, assumed, equal, record);
            requires.extend(&combination.requires);
            combined = Some(combination);
            continue;
        }
        let given = conditions(&by_constraints, assumed);
        let plain = match along {
            None => vanishes_or_fails(&by_constraints, difference, &given),
            Some(_) => vanishes(&by_constraints, difference, &given),
        };
        let (outcome, motion) = match (plain, &along) {
            (Outcome::Zero(divisors), _) => (Outcome::Zero(divisors), &by_constraints),
            (plain, None) => (plain, &by_constraints),
            (_, Some(Err(why))) => (Outcome::Undecided(why.clone()), &by_constraints),
            (_, Some(Ok(motion))) => {
                is_dynamic = true;
                (vanishes_or_fails(motion, difference, &conditions(motion, assumed)), motion)
            }
        };
        // if a divisor vanishes along every motion, the formula is undefined
        let outcome = match (outcome, &along) {
            (Outcome::Zero(divisors), Some(Ok(along))) => {
                let is_zero = |divisor: &&Sym| decide(along.reduced(**divisor), &along.hypotheses).is_zero();
                match divisors.iter().find(is_zero).copied() {
                    Some(divisor) => Outcome::Undefined(divisor),
                    None => Outcome::Zero(divisors),
                }
            }
            (outcome, _) => outcome,
        };
        let is_open = matches!(outcome, Outcome::Undecided(_) | Outcome::Identified(_));
        if is_open
            && let Lost::Divisors(hidden) = motion.lost_divisors(difference)
            && are_equal_by_squares(line.model, motion, &conditions(motion, assumed))
        {
            by_squares = true;
            requires.extend(motion.divisors.iter().copied().chain(hidden));
            record.leave_out();
            continue;
        }
        let unreal =
            line.model.into_iter().find_map(|side| without_real_value(side, motion, &conditions(motion, assumed)));
        if let Some(root) = unreal {
            finding.judged.verdict = Verdict::Undefined;
            finding.judged.evidence = format!("{} has no real value", letters.told(root));
            break;
        }
        match outcome {
            Outcome::Zero(divisors) => {
                record.vanishes(motion, assumed, &[equal]);
                requires.extend(divisors.into_iter().chain(motion.divisors.iter().copied()));
            }
            Outcome::NonZero(refutation) => {
                match sign_of_number(motion.reduced(difference)) {
                    // no exact point exists for a number such as cos(pi/5)
                    Some(_) => record.part(motion, assumed, &[equal], |_| PartProof::Excluded),
                    None => record.fails(motion, assumed, equal, &refutation),
                }
                refute(line, &refutation, motion, told, finding);
                missing(claim.kind, line, motion, told, finding);
                break;
            }
            other => {
                // the divisor may vanish only along motions
                let dynamic = along.as_ref().and_then(|along| along.as_ref().ok()).unwrap_or(motion);
                let where_undefined = if matches!(other, Outcome::Undefined(_)) { dynamic } else { motion };
                record.undecided(where_undefined, assumed, equal, &other);
                neither(other, letters, finding);
                break;
            }
        }
    }
    let moves = |line: &Line| {
        let symbols = (line.model[0] - line.model[1]).symbols_of();
        trace.accelerations.iter().any(|acceleration| symbols.contains(acceleration))
    };
    // a refuted formula with a speed may have lost a dot, so that the missing acceleration is not a fault of the file
    let has_rate =
        |line: &Line| line.own.into_iter().flat_map(Sym::symbols_of).any(|own| own.to_string().ends_with('\''));
    let has_lost_dot = finding.judged.verdict == Verdict::Refuted && lines.iter().any(has_rate);
    if claim.kind == Kind::EquationOfMotion && !has_lost_dot && !lines.iter().any(moves) {
        let issue = Issue::at(claim.formula.span.clone(), "no acceleration stands in this equation of motion", "here");
        return Err(issue.accepted("kind = \"formula\" or \"identity\" for what holds no acceleration"));
    }
    if finding.judged.verdict == Verdict::Proved {
        finding.judged.evidence = match by_squares {
            true => {
                "both sides have one sign, and the normal form of the difference of their squares is zero".to_owned()
            }
            false => "normal form of the difference is zero".to_owned(),
        };
        let says_nothing = |line: &Line| decide(line.own[0] - line.own[1], &Hypotheses::none()).is_zero();
        if claim.kind != Kind::Identity && lines.iter().all(says_nothing) {
            finding.judged.evidence += "; both sides are equal for all values of the printed letters, so that the formula says nothing of the model";
        }
        finding.judged.requires.extend(divisors(&requires, told));
    }
    finding.allowed = allowed(trace, is_dynamic);
    let by_equations = |line: &Line, motion: &Motion<'_, '_>| match &combined {
        Some(combination) => combination.told(motion, told),
        None => told_combination(line.model[0] - line.model[1], motion, told),
    };
    if let (true, Verdict::Proved, [line], Some(Ok(motion))) = (is_dynamic, finding.judged.verdict, &lines[..], &along)
        && let Some(combination) = by_equations(line, motion)
    {
        finding.allowed += &format!("; here {combination}");
    }
    Ok(())
}
