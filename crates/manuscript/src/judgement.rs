//! The judgement of all claims of a paper.

use crate::case_findings::joined;
use crate::cases::{Case, cases};
use crate::certificate::Record;
use crate::change::{EditKind, Search};
use crate::claim_text::{ClaimText, Kind};
use crate::conditions::{Hypothesis, hypotheses};
use crate::correction::{Judge, corrections};
use crate::dimensions::object_to_dimensions;
use crate::display::{Told, divisors};
use crate::equalities::equalities;
use crate::equation::Outcome;
use crate::extent::{contradiction, is_met};
use crate::finding::Finding;
use crate::half_turn_bounds::bounds;
use crate::implications::equivalence;
use crate::inequalities::inequality;
use crate::integrals::{integral, known};
use crate::letters::{Letters, model};
use crate::linearisation::linearised;
use crate::motion::Motion;
use crate::numbers::number;
use crate::paper_findings::PaperFindings;
use crate::paper_text::PaperText;
use crate::passage::placed;
use crate::presuppositions::{presupposed, where_they_hold};
use crate::stability::stability;
use crate::steadiness::steady_motion;
use crate::verdict::{mixed_hypotheses, neither};
use ::model::Trace;
use claims::certificate::Certificate;
use claims::{Condition, Judged, Verdict};
use latex::{Statement, read};
use reader::{Issue, SceneError};
use std::time::{Duration, Instant};
use symbolic::Sym;

/// The times after which the search for corrections of one claim is cut, one round of all claims after the other.
const SHARES: [Duration; 4] = [Duration::from_secs(2), Duration::from_secs(8), Duration::from_secs(32), Duration::MAX];

impl PaperText {
    /// Judges all claims in the order of the file, and searches for corrections of refuted ones.
    ///
    /// # Errors
    /// All faults of the system, of the meanings of letters and of the formulas, with their places in the file.
    pub fn judge(&self) -> Result<Vec<Finding>, SceneError> {
        self.judge_each(|_| (), || true)
    }

    /// Judges all claims, and calls `told` with all findings so far after each new one. Once every claim has a verdict, corrections are searched for
    /// as long as `goes_on` returns true.
    ///
    /// # Errors
    /// Those of [`PaperText::judge`].
    pub fn judge_each(
        &self,
        told: impl FnMut(&[Finding]) + Send,
        goes_on: impl Fn() -> bool + Send + Sync,
    ) -> Result<Vec<Finding>, SceneError> {
        self.findings(false, told, goes_on)?.whole()
    }

    /// Judges all claims like [`PaperText::judge_each`], with the certificate of each verdict.
    ///
    /// # Errors
    /// Those of [`PaperText::judge`].
    pub fn certify_each(
        &self,
        told: impl FnMut(&[Finding]) + Send,
        goes_on: impl Fn() -> bool + Send + Sync,
    ) -> Result<Vec<Finding>, SceneError> {
        self.findings(true, told, goes_on)?.whole()
    }

    /// Judges all claims that can be read, like [`PaperText::judge_each`]; the result also contains the faults of the other claims. `is_certified`
    /// requests certificates.
    ///
    /// # Errors
    /// All faults of the system and of the meanings of letters, with their places in the file.
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
                    let finding =
                        judge(self, claim, &statement, &letters, is_certified).map_err(|issue| vec![issue])?;
                    judged.push((claim, statement));
                    Ok(finding)
                });
                match finding {
                    Ok(mut finding) => {
                        // the search for its corrections has not begun
                        if finding.judged.verdict == Verdict::Refuted {
                            finding.search = Search::Cut;
                        }
                        findings.push(finding);
                        told(&findings);
                    }
                    Err(issues) => faults.push((claim, issues)),
                }
            }
            // each search has a share of the time; one that was cut is repeated with a longer share when all others had theirs
            for share in SHARES {
                for (place, (claim, statement)) in judged.iter().enumerate() {
                    if findings[place].judged.verdict == Verdict::Refuted && findings[place].search == Search::Cut {
                        let start = Instant::now();
                        let goes_on = || goes_on() && start.elapsed() < share;
                        correct(self, claim, statement, &letters, (&goes_on, is_certified), &mut findings[place]);
                        told(&findings);
                    }
                }
            }
            Ok(PaperFindings::of(self, findings, faults))
        })
    }
}

/// Reads the formula of a claim.
fn statement_of(claim: &ClaimText, letters: &Letters<'_, '_>) -> Result<Statement, Vec<Issue>> {
    if !claim.faults.is_empty() {
        return Err(claim.faults.clone());
    }
    read(&claim.formula.text, &known(claim.kind, letters)).map_err(|fault| vec![placed(&claim.formula, fault)])
}

/// Searches for corrections of a refuted claim.
fn correct(
    paper: &PaperText,
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    (goes_on, is_certified): (&dyn Fn() -> bool, bool),
    finding: &mut Finding,
) {
    if !goes_on() {
        return;
    }
    let Ok(assumed) = hypotheses(&claim.given, letters) else { return };
    let decide = |claim: &ClaimText| {
        let statement = read(&claim.formula.text, &known(claim.kind, letters)).ok()?;
        judge(paper, claim, &statement, letters, is_certified).ok()
    };
    let missing = finding.judged.difference.clone();
    let judge = Judge { decide: &decide, goes_on, missing: missing.as_ref() };
    let found = corrections(claim, statement, letters, &assumed, &judge);
    // a shorter search may have found some
    if !found.is_empty() {
        finding.corrections = found;
    }
    finding.search = if goes_on() { Search::Whole } else { Search::Cut };
    let values = finding.judged.counterexample.iter().map(|(name, value)| format!("{name} = {value}"));
    let at = values.collect::<Vec<_>>().join(", ");
    // a strict relation with the correct direction fails only at points of equality
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

/// Judges a claim in all cases of its hypotheses.
fn judge(
    paper: &PaperText,
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    is_certified: bool,
) -> Result<Finding, Issue> {
    let assumed = hypotheses(&claim.given, letters)?;
    if assumed.iter().all(|hypothesis| hypothesis.equality.is_none()) {
        return judge_case(paper, claim, statement, letters, assumed, is_certified);
    }
    let base = Motion::by_constraints(letters.trace);
    let told = |factor: Sym| letters.told(factor);
    let mut cases = cases(&base, &assumed, &told)?;
    if cases.len() > 1 {
        cases.retain(|case| contradiction(&base, &case.assumed, &[]).is_none());
    }
    let is_replaced = cases.iter().any(|case| case.is_replaced);
    let found = cases.into_iter().map(|Case { assumed, chosen, .. }| {
        let words = chosen.into_iter().map(|factor| format!("{} = 0", told(factor))).collect::<Vec<_>>().join(", ");
        Ok((words, judge_case(paper, claim, statement, letters, assumed, is_certified)?))
    });
    let mut finding = match joined(found.collect::<Result<Vec<_>, Issue>>()?) {
        Some(finding) => finding,
        // every case is contradictory, and judging the hypotheses together gives a message that names them
        None => judge_case(paper, claim, statement, letters, assumed, is_certified)?,
    };
    if is_replaced && let Some(certificate) = &mut finding.certificate {
        let why = "the verdict rests on the factors of a hypothesis, for which the second checker has no steps yet";
        *certificate = Certificate::for_claim(&finding.judged).proved_by(Vec::new(), Vec::new(), why);
    }
    Ok(finding)
}

/// Judges a claim under hypotheses without several cases.
fn judge_case(
    paper: &PaperText,
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    mut assumed: Vec<Hypothesis>,
    is_certified: bool,
) -> Result<Finding, Issue> {
    let mut judged = Judged {
        id: paper.id_of(claim),
        section: claim.section.clone(),
        equation: claim.key().split('/').next().unwrap_or_default().to_owned(),
        says: claim.says.clone(),
        note: claim.note.clone(),
        reading: format!("printed: {}", claim.formula.text),
        ..Judged::default()
    };
    let mut in_order: Vec<&Hypothesis> = assumed.iter().collect();
    in_order.sort_by_key(|hypothesis| hypothesis.at.start);
    for hypothesis in in_order {
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
    if !assumed.iter().any(|hypothesis| hypothesis.scales) {
        object_to_dimensions(claim.kind, statement, letters, &mut finding);
    }
    if matches!(finding.judged.verdict, Verdict::Proved | Verdict::Identified | Verdict::Undecided) {
        presupposed(paper, claim, statement, letters, (&assumed, &there), &mut finding);
    }
    // letters that are positive by a hypothesis are not listed as divisors
    let positive = assumed.iter().filter_map(|one| match one.condition {
        Some(Condition::Positive(of)) => Some(of),
        _ => None,
    });
    let excluded = divisors(&positive.collect::<Vec<Sym>>(), Told(letters));
    let mut listed: Vec<(String, String)> = Vec::new();
    finding.judged.requires.retain(|line| {
        let is_new = !excluded.contains(line) && !listed.contains(line);
        listed.extend(is_new.then(|| line.clone()));
        is_new
    });
    if finding.judged.verdict == Verdict::Refuted && !finding.unusual.is_empty() {
        finding.judged.evidence += &format!("; {}", finding.unusual);
    }
    finding.judged.expected = claim.expected.unwrap_or(finding.judged.verdict);
    finding.certificate = record.finished(&finding.judged, claim.kind.without_certificate());
    Ok(finding)
}
