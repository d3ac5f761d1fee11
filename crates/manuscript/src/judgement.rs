//! Every claim of a paper, decided.

use crate::claim_text::{ClaimText, Kind};
use crate::conditions::{Hypothesis, assume, conditions, hypotheses, placed, side};
use crate::display::{Told, divisors, missing, point, shown};
use crate::equation::{Outcome, Refutation, vanishes};
use crate::finding::{Finding, Sides};
use crate::implications::{equivalence, steady_motion};
use crate::inequalities::inequality;
use crate::integrals::{CONSTANTS, integral};
use crate::letters::{Letters, model};
use crate::motion::Motion;
use crate::paper_text::PaperText;
use ::model::Trace;
use claims::{Judged, Verdict};
use latex::{Chain, Relation, Statement, read};
use reader::{Issue, SceneError};
use symbolic::{Sym, dimension};

/// Decides every claim of a paper.
///
/// # Errors
/// All that is wrong with the system, the letters or the formulas, each at its place.
pub(crate) fn judged(paper: &PaperText) -> Result<Vec<Finding>, SceneError> {
    let model = model(paper)?;
    symbolic::apart(|| {
        let trace = Trace::of(&model);
        let letters = Letters::of(paper, &trace);
        let mut issues = Vec::new();
        let mut findings = Vec::new();
        let spelt = letters.spelt();
        // every formula is read before the first is decided
        let statements: Vec<Option<Statement>> = paper
            .claims
            .iter()
            .map(|claim| {
                let constants = CONSTANTS.map(str::to_owned);
                // a constant without a value stands in integrals alone
                let own: Vec<String> = match claim.kind {
                    Kind::IntegralOfMotion => spelt.iter().cloned().chain(constants).collect(),
                    _ => spelt.clone(),
                };
                read(&claim.formula.text, &own).map_err(|fault| issues.push(placed(&claim.formula, fault))).ok()
            })
            .collect();
        for (claim, statement) in paper.claims.iter().zip(&statements) {
            let Some(statement) = statement else { continue };
            match judge(paper, claim, statement, &letters) {
                Ok(finding) => findings.push(finding),
                Err(issue) => issues.push(issue),
            }
        }
        if issues.is_empty() { Ok(findings) } else { Err(paper.error(issues)) }
    })
}

fn judge(
    paper: &PaperText,
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
) -> Result<Finding, Issue> {
    let assumed = hypotheses(&claim.given, letters)?;
    let mut judged = Judged {
        id: format!("{}/{}", paper.key, claim.key()),
        section: claim.section.clone(),
        equation: format!("eq{}", claim.equation),
        says: claim.says.clone(),
        note: claim.note.clone(),
        reading: format!("printed: {}", claim.formula.text),
        ..Judged::default()
    };
    for hypothesis in &assumed {
        let list = if matches!(hypothesis.condition, Some(claims::Condition::Positive(_))) {
            &mut judged.signs
        } else {
            &mut judged.requires
        };
        list.push(hypothesis.told.clone());
    }
    let mut finding = Finding {
        judged,
        kind: claim.kind,
        printed: claim.formula.text.clone(),
        given: claim.given.iter().map(|given| given.text.clone()).collect(),
        expected: claim.expected,
        allowed: String::new(),
        sides: None,
    };
    match claim.kind {
        Kind::EquationOfMotion | Kind::Formula | Kind::Identity => {
            equalities(claim, statement, letters, &assumed, &mut finding)?
        }
        Kind::IntegralOfMotion => integral(claim, statement, letters, &assumed, &mut finding)?,
        Kind::Inequality => inequality(claim, statement, letters, &assumed, &mut finding)?,
        Kind::Equivalence => equivalence(claim, statement, letters, &assumed, &mut finding)?,
        Kind::SteadyMotion => steady_motion(claim, statement, letters, &assumed, &mut finding)?,
    }
    finding.judged.expected = claim.expected.unwrap_or(finding.judged.verdict);
    Ok(finding)
}

/// An equality between two neighbours of a chain, component by component.
pub(crate) struct Line {
    pub model: [Sym; 2],
    pub own: [Sym; 2],
}

/// The equalities of a formula.
pub(crate) fn lines(claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Result<Vec<Line>, Issue> {
    let accepted = "two sides or more with `=` between them";
    let refused = |title: &str| Issue::at(claim.formula.span.clone(), title.to_owned(), "here").accepted(accepted);
    let [Chain { sides, relations }] = &statement.chains[..] else {
        return Err(refused("an equivalence is a claim of the kind `equivalence`"));
    };
    if relations.is_empty() {
        return Err(refused("this formula has one side, and states nothing"));
    }
    if relations.iter().any(|relation| *relation != Relation::Equal) {
        return Err(refused("this formula is no equality; an inequality is a claim of the kind `inequality`"));
    }
    let sides: Vec<_> = sides.iter().map(|term| side(&claim.formula, term, letters)).collect::<Result<_, _>>()?;
    let mut lines = Vec::new();
    for pair in sides.windows(2) {
        let (left, right) = (pair[0].model.entries(), pair[1].model.entries());
        // zero is a vector too
        let all_zero = |side: &[Sym]| side.len() == 1 && side[0] == Sym::ZERO;
        let count = left.len().max(right.len());
        if left.len() != right.len() && !all_zero(&left) && !all_zero(&right) {
            return Err(refused(&format!("one side has {} components and the other {}", left.len(), right.len())));
        }
        let padded = |side: Vec<Sym>| if side.len() == count { side } else { vec![Sym::ZERO; count] };
        let own = [padded(pair[0].own.entries()), padded(pair[1].own.entries())];
        for (place, (left, right)) in padded(left).into_iter().zip(padded(right)).enumerate() {
            lines.push(Line { model: [left, right], own: [own[0][place], own[1][place]] });
        }
    }
    Ok(lines)
}

fn equalities(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
) -> Result<(), Issue> {
    let lines = lines(claim, statement, letters)?;
    let told = Told(letters);
    (finding.judged.text, finding.judged.latex) = lines.iter().map(|line| shown(line.own)).unzip();
    let trace = letters.trace;
    if claim.kind == Kind::EquationOfMotion {
        let moves = |line: &Line| {
            let symbols = (line.model[0] - line.model[1]).symbols_of();
            trace.accelerations.iter().any(|acceleration| symbols.contains(acceleration))
        };
        if !lines.iter().any(moves) {
            let issue =
                Issue::at(claim.formula.span.clone(), "no acceleration stands in this equation of motion", "here");
            return Err(issue.accepted("kind = \"formula\" or \"identity\" for what holds no acceleration"));
        }
    }
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
    let mut is_dynamic = false;
    finding.judged.verdict = Verdict::Proved;
    for line in &lines {
        let difference = line.model[0] - line.model[1];
        let plain = vanishes(&by_constraints, difference, &conditions(&by_constraints, assumed));
        let (outcome, motion) = match (plain, &along) {
            (Outcome::Zero(divisors), _) => (Outcome::Zero(divisors), &by_constraints),
            (plain, None) => (plain, &by_constraints),
            (_, Some(Err(why))) => (Outcome::Undecided(why.clone()), &by_constraints),
            (_, Some(Ok(motion))) => {
                is_dynamic = true;
                (vanishes(motion, difference, &conditions(motion, assumed)), motion)
            }
        };
        match outcome {
            Outcome::Zero(divisors) => requires.extend(divisors.into_iter().chain(motion.divisors.iter().copied())),
            Outcome::NonZero(refutation) => {
                refute(line, &refutation, motion, told, finding);
                missing(claim.kind, line, motion, told, finding);
                break;
            }
            other => {
                neither(other, letters, finding);
                break;
            }
        }
    }
    if finding.judged.verdict == Verdict::Proved {
        finding.judged.evidence = "normal form of the difference is zero".to_owned();
        finding.judged.requires.extend(divisors(&requires, told));
    }
    finding.allowed = allowed(trace, is_dynamic);
    mixed(&lines, letters, finding);
    Ok(())
}

/// A verdict that neither proves nor refutes.
pub(crate) fn neither(outcome: Outcome, letters: &Letters<'_, '_>, finding: &mut Finding) {
    let (verdict, evidence) = match outcome {
        Outcome::Undefined(denominator) => {
            (Verdict::Undefined, format!("{} vanishes identically", letters.told(denominator)))
        }
        Outcome::Identified(why) => (Verdict::Tested, why),
        Outcome::Undecided(why) => (Verdict::Undecided, why),
        Outcome::Zero(_) | Outcome::NonZero(_) => return,
    };
    (finding.judged.verdict, finding.judged.evidence) = (verdict, evidence);
}

/// What was used beside the formula.
pub(crate) fn allowed(trace: &Trace<'_>, is_dynamic: bool) -> String {
    let constraints = ::model::equations::constraints_of(trace).len();
    let held = match constraints {
        0 => String::new(),
        1 => " and the constraint with its derivatives".to_owned(),
        n => format!(" and the {n} equations of constraints with their derivatives"),
    };
    match (is_dynamic, constraints) {
        (true, _) => format!("along every motion: any combination of the model's equations of motion{held}"),
        (false, 0) => "identically: for all positions, speeds and accelerations".to_owned(),
        (false, _) => format!(
            "for all positions, speeds and accelerations that the constraints allow:{}",
            held.trim_start_matches(" and")
        ),
    }
}

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
    finding.judged.counterexample = point(line.own, refutation, motion, told);
}

/// Sides of mixed dimensions speak against what is false, and are an objection to whatever is said to hold.
fn mixed(lines: &[Line], letters: &Letters<'_, '_>, finding: &mut Finding) {
    let of = |name: &str| letters.dimension(name);
    let mismatch = lines.iter().find_map(|line| dimension(line.own[0] - line.own[1], &of).err());
    // a name of a derivative has no dimension of its own
    let Some(mismatch) = mismatch.filter(|mismatch| !matches!(mismatch, symbolic::Mismatch::Unknown(_))) else {
        return;
    };
    match finding.judged.verdict {
        Verdict::Refuted => finding.judged.evidence += &format!("; {mismatch}"),
        _ => finding.judged.objections.push(mismatch.to_string()),
    }
}
