//! A claim on the page: its statement, conditions, evidence, counterexample and remarks.

use super::{conditions, findings};
use crate::{ClaimRow, Verdict, text::Typesetter};
use maud::{Markup, html};

/// The body of a claim, without its heading. A refuted claim has a link to the finding, which shows the counterexample and the correction.
pub(super) fn whole(claim: &ClaimRow, set: &mut Typesetter) -> Markup {
    let found = claim.verdict == Verdict::Refuted;
    html! {
        @for latex in &claim.latex { (set.formula(latex)) }
        div.known {
            (conditions::requires(&claim.requires, set))
            (evidence(claim, set))
        }
        @if found {
            p.note { a href={ "#" (findings::link(claim)) } { "Where it fails, and what holds instead" } }
        } @else {
            @if let Some(difference) = &claim.difference {
                div.difference { p.side { "Left minus right" } (set.formula(difference)) }
            }
            @if !claim.counterexample.is_empty() {
                div.counterexample { p.side { "Exact values" } (values(&claim.counterexample, set)) }
            }
            (remarks(claim, set))
        }
    }
}

/// Evidence that hundreds of rows share. The page states it once, next to the meaning of the verdict.
const USUAL: [&str; 2] = ["normal form zero", "normal form of the difference is zero"];

/// The sentence that stands for the evidence in `USUAL`, next to the meaning of the verdict.
pub(super) const UNTOLD: &str = "; if no reason is given, the normal form of the difference is zero";

/// The evidence of a claim; empty where it is in `USUAL`.
pub(super) fn evidence(claim: &ClaimRow, set: &mut Typesetter) -> Markup {
    let is_told = !claim.evidence.is_empty() && !USUAL.contains(&claim.evidence.as_str());
    html! { @if is_told { p.evidence { (set.text(&claim.evidence)) } } }
}

/// The remarks on a claim: the reason for which the printed formula fails, the reading of an ambiguous print, and notes.
pub(super) fn remarks(claim: &ClaimRow, set: &mut Typesetter) -> Markup {
    html! {
        @for (word, remark) in [("Why. ", &claim.why), ("Reading. ", &claim.reading), ("", &claim.note)] {
            @if !remark.is_empty() { p.note { @if !word.is_empty() { b { (word) } } (set.text(remark)) } }
        }
    }
}

/// Names with their values, side by side.
pub(super) fn values(values: &[(String, String)], set: &mut Typesetter) -> Markup {
    html! {
        dl.values { @for (name, value) in values {
            div { dt; (set.text(name)) " " dd; (set.text(&signed(value))) }
        } }
    }
}

/// The text with each hyphen before a number replaced by a minus sign.
fn signed(value: &str) -> String {
    let mut out = String::with_capacity(value.len());
    let mut letters = value.chars().peekable();
    let mut before = ' ';
    while let Some(c) = letters.next() {
        let minus = c == '-' && !before.is_alphanumeric() && letters.peek().is_some_and(char::is_ascii_digit);
        out.push(if minus { '−' } else { c });
        before = c;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minus_signs_are_true_ones_and_hyphens_stay() {
        assert_eq!(
            [signed("-1/2"), signed("(0, -3/5)"), signed("e-3"), signed("-x")],
            ["−1/2", "(0, −3/5)", "e-3", "-x"]
        );
    }
}
