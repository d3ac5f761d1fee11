//! The smallest edit of a printed formula that makes a refuted claim true.
//!
//! # Overview
//! * [`places`]: terms, factors, letters, numbers and powers with their ranges in the printed formula;
//! * [`exchanges`], [`factors`], [`terms`], [`lost`]: the edits, ordered by size;
//! * [`ground`]: letters, test points and judge of a formula: of a claim about its model ([`text_claim`], with [`probe`]), or of a recorded
//!   equation that is compared with the derived one ([`recorded_equation`]);
//! * [`search`]: the search for the smallest edits that are proved.

mod combinations;
mod comparison;
mod edit;
mod exchanges;
mod factors;
mod ground;
mod hypotheses;
mod integral_terms;
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
use std::cmp::Reverse;
use text_claim::TextClaim;

/// Corrections of a refuted claim, all of the same size; empty if no edit is proved.
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
        let right = right(claim, statement, letters, assumed);
        // signs are tried from the end, since the printed number is on the right
        let mut signs = exchanges::signs(&search.places, ground.text());
        signs.sort_by_key(|sign| Reverse(sign.span.start));
        let power = right.as_ref().and_then(|right| power_of_ten(claim, right));
        // a sign and a power of ten together
        let with_sign = power.iter().flat_map(|power| signs.iter().map(|sign| vec![sign.clone(), power.clone()]));
        let with_sign: Vec<Vec<Edit>> = with_sign.collect();
        let digits = right.map(|right| digits(claim, right));
        let single = signs.into_iter().chain(power).map(|edit| vec![edit]);
        let edits = single.chain(with_sign).chain(digits.map(|edit| vec![edit]));
        return search.proved(edits).into_iter().take(1).collect();
    }
    let signs = || hypotheses::signs_of_letters(&search.places, ground.text(), ground.rates());
    let zeros = |are_parameters| hypotheses::zeros(claim.kind, &search.places, ground.rates(), are_parameters);
    let together = || hypotheses::signs_of_parameters(claim, statement, letters, ground.rates());
    let sizes: [&dyn Fn() -> Vec<Correction>; 6] = [
        &|| under(&ground, hypotheses::of_parameters(claim.kind, &search.places, ground.text(), ground.rates())),
        &|| under_all(&ground, together()).into_iter().collect(),
        &|| search.small(),
        &|| under(&ground, [signs(), zeros(false)].concat()),
        &|| search.large(),
        &|| under(&ground, zeros(true)),
    ];
    sizes.into_iter().map(|found| found()).find(|found| !found.is_empty()).unwrap_or_default()
}

/// Corrections by one additional hypothesis under which the claim as printed is proved.
fn under(ground: &TextClaim<'_, '_, '_>, candidates: Vec<String>) -> Vec<Correction> {
    let mut found: Vec<Correction> = Vec::new();
    for hypothesis in candidates {
        if found.len() >= MOST_TOLD || !ground.goes_on() {
            break;
        }
        // one hypothesis about the sign of a letter suffices
        let letter = hypothesis.split(' ').next();
        if found.iter().any(|one| one.changes[0].after.split(' ').next() == letter) {
            continue;
        }
        let claim = with_hypotheses(ground, std::slice::from_ref(&hypothesis));
        if !hypotheses::leaves_something(&claim, ground.letters) {
            continue;
        }
        if let Some(proof) = ground.proof(&claim) {
            found.push(by_hypotheses(ground, vec![hypothesis], proof));
        }
    }
    found
}

/// The correction by several additional hypotheses that are necessary together; `None` if the claim is not proved under all of them.
fn under_all(ground: &TextClaim<'_, '_, '_>, mut all: Vec<String>) -> Option<Correction> {
    let proof = |all: &[String]| ground.proof(&with_hypotheses(ground, all)).filter(|_| ground.goes_on());
    let mut proved = if all.len() > 1 { proof(&all) } else { None }?;
    for hypothesis in all.clone() {
        let fewer: Vec<String> = all.iter().filter(|one| **one != hypothesis).cloned().collect();
        if let Some(enough) = proof(&fewer) {
            (all, proved) = (fewer, enough);
        }
    }
    Some(by_hypotheses(ground, all, proved))
}

/// The claim with additional hypotheses.
fn with_hypotheses(ground: &TextClaim<'_, '_, '_>, hypotheses: &[String]) -> ClaimText {
    let mut claim = ground.claim.clone();
    claim.given.extend(hypotheses.iter().map(|hypothesis| claim.formula.with_text(hypothesis.clone())));
    claim.expected = None;
    claim
}

fn by_hypotheses(ground: &TextClaim<'_, '_, '_>, hypotheses: Vec<String>, proof: Proof) -> Correction {
    let change = |hypothesis: String| Change {
        kind: EditKind::Hypothesis,
        words: format!("the hypothesis `{hypothesis}`"),
        before: String::new(),
        after: hypothesis,
    };
    let changes = hypotheses.into_iter().map(change).collect();
    let Proof { judged, certificate } = proof;
    Correction { changes, formula: ground.text().to_owned(), parts: Vec::new(), judged, certificate }
}

/// The edit of the power of ten, if the printed digits are correct with another power.
fn power_of_ten(claim: &ClaimText, right: &Right) -> Option<Edit> {
    let (span, power) = right.power.clone()?;
    let words = format!("the power of ten `10{power}` for `10{}`", &claim.formula.text[span.clone()]);
    Some(Edit::new(EditKind::Exponent, span, power, words))
}

/// The edit that replaces a printed number by its correct digits, as many as are printed.
fn digits(claim: &ClaimText, Right { span, digits, .. }: Right) -> Edit {
    let words = format!("the number `{digits}` for `{}`", &claim.formula.text[span.clone()]);
    Edit::new(EditKind::Digits, span, digits, words)
}
