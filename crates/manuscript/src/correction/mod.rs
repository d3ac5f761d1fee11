//! The smallest edit of a printed formula that makes a refuted claim true.
//!
//! # Overview
//! * [`places`]: terms, factors, letters, numbers and powers with their places in the print;
//! * [`exchanges`], [`factors`], [`terms`], [`lost`]: the edits, by their size;
//! * [`ground`]: letters, points and judge of a formula: for a claim over its model ([`text_claim`], with [`probe`]), or for a recorded
//!   equation compared with the derived one ([`recorded_equation`]);
//! * [`search`]: the edits of the smallest size that are proved.

mod combinations;
mod comparison;
mod edit;
mod exchanges;
mod factors;
mod ground;
mod hypotheses;
mod letter_rates;
mod lost;
mod lost_inertia;
mod places;
mod printed_letters;
mod probe;
mod recorded_equation;
mod recorded_theorem;
mod redundancy;
mod renamings;
mod samples;
mod search;
mod terms;
mod text_claim;
mod theorem_premises;
mod values;

pub use recorded_equation::{LineCorrection, NotRead, line_corrections};
pub use recorded_theorem::theorem_corrections;
pub(crate) use text_claim::Judge;

use crate::change::{Change, Correction, EditKind};
use crate::claim_text::{ClaimText, Kind};
use crate::conditions::Hypothesis;
use crate::letters::Letters;
use crate::numbers::{Right, right};
use edit::Edit;
use ground::{Ground, Proof};
use latex::Statement;
use search::{MOST_TOLD, Search};
use text_claim::TextClaim;

/// Corrections of a refuted claim, all of one size; empty if no edit is proved.
pub(crate) fn corrections(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    judge: &Judge<'_>,
) -> Vec<Correction> {
    let ground = TextClaim::of(claim, statement, letters, assumed, judge);
    let search = Search::of(&ground, statement);
    if claim.kind == Kind::Number {
        let digits = digits(claim, statement, letters, assumed);
        let edits = exchanges::signs(&search.places, ground.text()).into_iter().chain(digits);
        return search.proved(edits.map(|edit| vec![edit])).into_iter().take(1).collect();
    }
    let candidates = || hypotheses::candidates(&search.places, ground.text(), ground.rates());
    let sizes: [&dyn Fn() -> Vec<Correction>; 4] = [
        &|| under(&ground, hypotheses::of_parameters(claim.kind, ground.rates())),
        &|| search.small(),
        &|| under(&ground, candidates()),
        &|| search.large(),
    ];
    sizes.into_iter().map(|found| found()).find(|found| !found.is_empty()).unwrap_or_default()
}

/// Hypotheses under which the claim as printed is proved.
fn under(ground: &TextClaim<'_, '_, '_>, candidates: Vec<String>) -> Vec<Correction> {
    let mut found: Vec<Correction> = Vec::new();
    for hypothesis in candidates {
        if found.len() >= MOST_TOLD || !ground.goes_on() {
            break;
        }
        // a hypothesis on the sign of a letter makes other ones on it superfluous
        let letter = hypothesis.split(' ').next();
        if found.iter().any(|one| one.changes[0].after.split(' ').next() == letter) {
            continue;
        }
        let mut claim = ground.claim.clone();
        claim.given.push(claim.formula.with_text(hypothesis.clone()));
        claim.expected = None;
        if !hypotheses::leaves_something(&claim, ground.letters) {
            continue;
        }
        if let Some(Proof { judged, certificate }) = ground.proof(&claim) {
            let change = Change {
                kind: EditKind::Hypothesis,
                words: format!("the hypothesis `{hypothesis}`"),
                before: String::new(),
                after: hypothesis,
            };
            let formula = ground.text().to_owned();
            found.push(Correction { changes: vec![change], formula, parts: Vec::new(), judged, certificate });
        }
    }
    found
}

/// The correct digits of a printed number, as many as are printed.
fn digits(claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>, assumed: &[Hypothesis]) -> Option<Edit> {
    let Right { span, digits } = right(claim, statement, letters, assumed)?;
    let words = format!("the number `{digits}` for `{}`", &claim.formula.text[span.clone()]);
    Some(Edit::new(EditKind::Digits, span, digits, words))
}
