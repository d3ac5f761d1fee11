//! Every claim of a paper, decided.

use crate::claim_text::{ClaimText, Kind};
use crate::combination::told_combination;
use crate::conditions::{Hypothesis, assume, conditions, hypotheses, placed, side};
use crate::display::{Line, Told, divisors, missing, shown};
use crate::equation::{Outcome, vanishes};
use crate::finding::Finding;
use crate::implications::{equivalence, steady_motion};
use crate::inequalities::inequality;
use crate::integrals::{CONSTANTS, integral};
use crate::letters::{Letters, model};
use crate::motion::Motion;
use crate::numbers::number;
use crate::paper_text::PaperText;
use crate::refutation::Refutation;
use crate::signs::completed;
use crate::stability::stability;
use crate::verdict::{allowed, mixed, neither, refute};
use ::model::Trace;
use claims::{Condition, Judged, Verdict};
use latex::{Chain, Relation, Statement, read};
use reader::{Issue, SceneError};
use symbolic::Sym;

impl PaperText {
    /// Decides every claim, in the order of the file.
    ///
    /// # Errors
    /// All that is wrong with the system, the meanings of letters and the formulas, each at its place.
    pub fn judge(&self) -> Result<Vec<Finding>, SceneError> {
        self.judge_each(|_| ())
    }

    /// The same, each finding told as it is made.
    ///
    /// # Errors
    /// As those of [`PaperText::judge`].
    pub fn judge_each(&self, told: impl FnMut(&Finding) + Send) -> Result<Vec<Finding>, SceneError> {
        judged(self, told)
    }
}

fn judged(paper: &PaperText, mut told: impl FnMut(&Finding) + Send) -> Result<Vec<Finding>, SceneError> {
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
                Ok(finding) => {
                    told(&finding);
                    findings.push(finding);
                }
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
        equation: claim.key().split('/').next().unwrap_or_default().to_owned(),
        says: claim.says.clone(),
        note: claim.note.clone(),
        reading: format!("printed: {}", claim.formula.text),
        ..Judged::default()
    };
    for hypothesis in &assumed {
        let list = if matches!(hypothesis.condition, Some(Condition::Positive(_))) {
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
        Kind::Stability => stability(claim, statement, letters, &assumed, &mut finding)?,
        Kind::Number => number(claim, statement, letters, &assumed, &mut finding)?,
    }
    if finding.judged.verdict == Verdict::Proved && !is_met(&assumed) {
        finding.judged.objections.push("no exact point was found that satisfies the hypotheses".to_owned());
    }
    finding.judged.expected = claim.expected.unwrap_or(finding.judged.verdict);
    Ok(finding)
}

/// Whether an exact point satisfies the signs and what must not vanish.
fn is_met(assumed: &[Hypothesis]) -> bool {
    let conditions: Vec<Condition> = assumed.iter().filter_map(|hypothesis| hypothesis.condition).collect();
    completed(Refutation { point: Vec::new(), is_formal: false }, &conditions).is_some()
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
    if let (true, Verdict::Proved, [line], Some(Ok(motion))) = (is_dynamic, finding.judged.verdict, &lines[..], &along)
        && let Some(combination) = told_combination(line.model[0] - line.model[1], motion, told)
    {
        finding.allowed += &format!("; here {combination}");
    }
    if !assumed.iter().any(|hypothesis| hypothesis.scales) {
        mixed(&lines, letters, finding);
    }
    Ok(())
}
