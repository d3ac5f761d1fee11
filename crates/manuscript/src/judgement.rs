//! The judgement of every claim of a paper.

use crate::certificate::Record;
use crate::change::{EditKind, Search};
use crate::claim_text::{ClaimText, Kind};
use crate::combination::told_combination;
use crate::conditions::{Hypothesis, assume, conditions, hypotheses, placed};
use crate::correction::{Judge, corrections};
use crate::display::{Told, divisors, missing, shown};
use crate::equation::{Outcome, vanishes, vanishes_or_fails};
use crate::extent::is_met;
use crate::finding::Finding;
use crate::half_turn_bounds::bounds;
use crate::implications::equivalence;
use crate::inequalities::inequality;
use crate::integrals::{integral, known};
use crate::letters::{Letters, model};
use crate::linearisation::linearised;
use crate::lines::{Line, lines};
use crate::motion::Motion;
use crate::numbers::number;
use crate::paper_findings::PaperFindings;
use crate::paper_text::PaperText;
use crate::presuppositions::{presupposed, where_they_hold};
use crate::real_signs::are_equal_by_squares;
use crate::signs::without_real_value;
use crate::stability::stability;
use crate::steadiness::steady_motion;
use crate::verdict::{allowed, mixed, mixed_hypotheses, neither, refute};
use ::model::Trace;
use claims::{Condition, Judged, Verdict};
use latex::{Statement, read};
use reader::{Issue, SceneError};
use symbolic::{Sym, decide};

impl PaperText {
    /// Judges every claim, in the order of the file, and searches for corrections of refuted ones.
    ///
    /// # Errors
    /// All that is wrong with the system, the meanings of letters and the formulas, each at its place.
    pub fn judge(&self) -> Result<Vec<Finding>, SceneError> {
        self.judge_each(|_| (), || true)
    }

    /// Judges every claim, and calls `told` with all findings so far after each new one. When every claim has a verdict, corrections are searched for
    /// while `goes_on` returns true.
    ///
    /// # Errors
    /// As those of [`PaperText::judge`].
    pub fn judge_each(
        &self,
        told: impl FnMut(&[Finding]) + Send,
        goes_on: impl Fn() -> bool + Send + Sync,
    ) -> Result<Vec<Finding>, SceneError> {
        self.findings(false, told, goes_on)?.whole()
    }

    /// Judges every claim as `judge_each` does, with the certificate of each verdict.
    ///
    /// # Errors
    /// As those of [`PaperText::judge`].
    pub fn certify_each(
        &self,
        told: impl FnMut(&[Finding]) + Send,
        goes_on: impl Fn() -> bool + Send + Sync,
    ) -> Result<Vec<Finding>, SceneError> {
        self.findings(true, told, goes_on)?.whole()
    }

    /// Judges every claim that can be read, as `judge_each` does, with certificates where they are asked for; the faults of the others stand beside.
    ///
    /// # Errors
    /// All that is wrong with the system and the meanings of letters, each at its place.
    pub fn findings(
        &self,
        is_certified: bool,
        mut told: impl FnMut(&[Finding]) + Send,
        goes_on: impl Fn() -> bool + Send + Sync,
    ) -> Result<PaperFindings, SceneError> {
        let model = model(self)?;
        symbolic::apart(|| {
            let trace = Trace::of(&model);
            let letters = Letters::of(self, &trace);
            let (mut findings, mut judged, mut faults) = (Vec::new(), Vec::new(), Vec::new());
            for claim in &self.claims {
                let finding = statement_of(claim, &letters).and_then(|statement| {
                    let finding = judge(self, claim, &statement, &letters, is_certified)?;
                    judged.push((claim, statement));
                    Ok(finding)
                });
                match finding {
                    Ok(finding) => {
                        findings.push(finding);
                        told(&findings);
                    }
                    Err(issue) => faults.push((claim, issue)),
                }
            }
            for (place, (claim, statement)) in judged.iter().enumerate() {
                if findings[place].judged.verdict == Verdict::Refuted {
                    correct(self, claim, statement, &letters, (&goes_on, is_certified), &mut findings[place]);
                    told(&findings);
                }
            }
            Ok(PaperFindings::of(self, findings, faults))
        })
    }
}

/// Reads the formula of a claim.
fn statement_of(claim: &ClaimText, letters: &Letters<'_, '_>) -> Result<Statement, Issue> {
    let fault = match &claim.fault {
        Some(fault) => fault.clone(),
        None => match read(&claim.formula.text, &known(claim.kind, letters)) {
            Ok(statement) => return Ok(statement),
            Err(fault) => fault,
        },
    };
    Err(placed(&claim.formula, fault))
}

/// Looks for the corrections of a refuted claim.
fn correct(
    paper: &PaperText,
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    (goes_on, is_certified): (&dyn Fn() -> bool, bool),
    finding: &mut Finding,
) {
    if !goes_on() {
        finding.search = Search::Cut;
        return;
    }
    let Ok(assumed) = hypotheses(&claim.given, letters) else { return };
    let decide = |claim: &ClaimText| {
        let statement = read(&claim.formula.text, &known(claim.kind, letters)).ok()?;
        judge(paper, claim, &statement, letters, is_certified).ok()
    };
    finding.corrections = corrections(claim, statement, letters, &assumed, &Judge { decide: &decide, goes_on });
    finding.search = if goes_on() { Search::Whole } else { Search::Cut };
    let values = finding.judged.counterexample.iter().map(|(name, value)| format!("{name} = {value}"));
    let at = values.collect::<Vec<_>>().join(", ");
    // if the direction of the relation is right, the print fails at a point of equality
    let loose = finding.corrections.iter_mut().flat_map(|one| &mut one.changes);
    for change in loose.filter(|change| change.kind == EditKind::Strictness && !at.is_empty()) {
        change.words += &format!(" (both sides are equal at {at})");
    }
    finding.judged.correction = finding.corrections.first().map(|first| {
        let several = match finding.corrections.len() {
            1 => String::new(),
            count => format!("{count} edits of one size make the claim true; this is the first one"),
        };
        let (says, latex) = (first.typeset(), vec![first.marked()]);
        Box::new(Judged { says, latex, note: several, reading: String::new(), ..first.judged.clone() })
    });
}

fn judge(
    paper: &PaperText,
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    is_certified: bool,
) -> Result<Finding, Issue> {
    let mut assumed = hypotheses(&claim.given, letters)?;
    let mut judged = Judged {
        id: paper.id_of(claim),
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
    assumed.extend(bounds(claim, statement, &assumed, letters));
    let there = where_they_hold(paper, claim.kind, &assumed, letters)?;
    let mut finding = Finding {
        judged,
        kind: claim.kind,
        printed: claim.formula.text.clone(),
        given: claim.given.iter().map(|given| given.text.clone()).collect(),
        expected: claim.expected,
        allowed: String::new(),
        sides: None,
        corrections: Vec::new(),
        search: Search::None,
        unusual: String::new(),
        has_inside: false,
        certificate: None,
    };
    let mut record = Record::of(is_certified);
    match claim.kind {
        Kind::EquationOfMotion | Kind::Formula | Kind::Identity => {
            equalities(claim, statement, letters, &assumed, &mut finding, &mut record)?
        }
        Kind::LinearisedEquation => linearised(claim, statement, letters, &assumed, &mut finding, &mut record)?,
        Kind::IntegralOfMotion => integral(claim, statement, letters, &assumed, &mut finding, &mut record)?,
        Kind::Inequality => inequality(claim, statement, letters, &assumed, &mut finding, &mut record)?,
        Kind::Equivalence => equivalence(claim, statement, letters, &assumed, &mut finding, &mut record)?,
        Kind::SteadyMotion => {
            let beside: Vec<&ClaimText> = paper.claims.iter().filter(|other| claim.has_motion_of(other)).collect();
            steady_motion(claim, &beside, statement, letters, &assumed, &mut finding, &mut record)?;
        }
        Kind::Stability => stability(claim, statement, letters, &assumed, &mut finding, &mut record)?,
        Kind::Number => number(claim, statement, letters, &assumed, &mut finding, &mut record)?,
    }
    if finding.judged.verdict == Verdict::Proved && !is_met(&there) {
        let why = "it follows from the hypotheses, but no exact point was found that satisfies them";
        neither(Outcome::Undecided(why.to_owned()), letters, &mut finding);
    }
    mixed_hypotheses(&assumed, letters, &mut finding);
    if matches!(finding.judged.verdict, Verdict::Proved | Verdict::Identified | Verdict::Undecided) {
        presupposed(paper, claim, statement, letters, (&assumed, &there), &mut finding);
    }
    // a letter that is given as positive does not vanish
    let positive = assumed.iter().filter_map(|one| match one.condition {
        Some(Condition::Positive(of)) => Some(of),
        _ => None,
    });
    let excluded = divisors(&positive.collect::<Vec<Sym>>(), Told(letters));
    finding.judged.requires.retain(|line| !excluded.contains(line));
    if finding.judged.verdict == Verdict::Refuted && !finding.unusual.is_empty() {
        finding.judged.evidence += &format!("; {}", finding.unusual);
    }
    finding.judged.expected = claim.expected.unwrap_or(finding.judged.verdict);
    finding.certificate = record.finished(&finding.judged, claim.kind.without_certificate());
    Ok(finding)
}

fn equalities(
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
    let (mut is_dynamic, mut by_squares) = (false, false);
    finding.judged.verdict = Verdict::Proved;
    for line in &lines {
        let difference = line.model[0] - line.model[1];
        let equal = Condition::Equal(line.model[0], line.model[1]);
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
        // with a divisor that is zero along every motion the formula is undefined
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
        if is_open && are_equal_by_squares(line.model, motion, &conditions(motion, assumed)) {
            by_squares = true;
            requires.extend(motion.divisors.iter().copied());
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
                record.fails(motion, assumed, equal, &refutation);
                refute(line, &refutation, motion, told, finding);
                missing(claim.kind, line, motion, told, finding);
                break;
            }
            other => {
                // a divisor may be zero along motions only
                let dynamic = along.as_ref().and_then(|along| along.as_ref().ok()).unwrap_or(motion);
                let where_undefined = if matches!(other, Outcome::Undefined(_)) { dynamic } else { motion };
                record.undecided(where_undefined, assumed, equal, &other);
                neither(other, letters, finding);
                break;
            }
        }
    }
    if finding.judged.verdict == Verdict::Proved {
        finding.judged.evidence = match by_squares {
            true => {
                "both sides have one sign, and the normal form of the difference of their squares is zero".to_owned()
            }
            false => "normal form of the difference is zero".to_owned(),
        };
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
