//! The section with every refuted claim next to its correction. The ledger links to the entries of this section.

use super::{anchor, cards::chip, conditions, statement};
use crate::{ClaimRow, PaperSection, Report, Verdict, text::Typesetter};
use maud::{Markup, html};

pub(super) fn findings(report: &Report, set: &mut Typesetter) -> Markup {
    let failing = |paper: &&PaperSection| paper.count(Verdict::Refuted) > 0;
    html! {
        @if report.count(Verdict::Refuted) > 0 {
            section #findings {
                h2 { "Findings" }
                p.lead { "Refuted statements, each with exact values at which it fails and with the corrected statement." }
                @for paper in report.papers.iter().filter(failing) {
                    h3.paper { (set.text(&paper.title)) }
                    @for claim in paper.claims.iter().filter(|claim| claim.verdict == Verdict::Refuted) {
                        (finding(claim, set))
                    }
                }
            }
        }
    }
}

fn finding(claim: &ClaimRow, set: &mut Typesetter) -> Markup {
    set.at(&claim.id);
    html! {
        article.finding id=(link(claim)) {
            div.title {
                h4 {
                    @if !claim.equation_label.is_empty() { span.label { (claim.equation_label) } " " }
                    (set.text(&claim.title))
                }
                a.id href={ "#" (anchor(&claim.id)) } { (claim.id) }
            }
            div.verses {
                p.side { "As printed" }
                div.said.refuted { @for latex in &claim.latex { (set.formula(latex)) } }
                @if !claim.counterexample.is_empty() {
                    p.side { "Fails for" }
                    div.said { (statement::values(&claim.counterexample, set)) }
                }
                @if let Some(correction) = &claim.correction {
                    p.side { "Holds instead " (chip(correction.verdict)) }
                    div class={ "said " (correction.verdict.name()) } { (correct(claim, correction, set)) }
                } @else if let Some(difference) = &claim.difference {
                    p.side { "Left minus right" }
                    div.said { (set.formula(difference)) }
                }
            }
            (statement::remarks(claim, set))
        }
    }
}

/// The anchor of the finding on a claim.
pub(super) fn link(claim: &ClaimRow) -> String {
    format!("finding/{}", anchor(&claim.id))
}

/// The width in em beyond which a formula next to a sentence is folded.
const LONG: f64 = 75.0;

/// The corrected sentence, followed by those of its formulas that differ from the printed ones. The conditions are unfolded where the formulas
/// agree with the printed ones, so that only the conditions differ; elsewhere they are folded.
fn correct(claim: &ClaimRow, correction: &ClaimRow, set: &mut Typesetter) -> Markup {
    let same = correction.latex == claim.latex;
    let (long, short): (Vec<&String>, Vec<&String>) = correction
        .latex
        .iter()
        .filter(|latex| !claim.latex.contains(latex))
        .partition(|latex| !correction.title.is_empty() && set.width(&format!("${latex}$")) > LONG);
    html! {
        @if !correction.title.is_empty() { p.holds { (set.text(&correction.title)) } }
        @for latex in short { (set.formula(latex)) }
        @if same { (conditions::requires(&correction.requires, set)) }
        @if !long.is_empty() || !correction.evidence.is_empty() || !(same || correction.requires.is_empty()) {
            details {
                summary { "What was shown" }
                @for latex in long { (set.formula(latex)) }
                @if !same { (conditions::requires(&correction.requires, set)) }
                (statement::evidence(correction, set))
                (statement::remarks(correction, set))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_finding_tells_the_sentence_that_holds_and_where_the_printed_one_fails() {
        let correction =
            ClaimRow { title: "only where x > 0".into(), latex: vec!["x = y".into()], ..Default::default() };
        let claim = ClaimRow {
            latex: vec!["x = y".into()],
            counterexample: vec![("x".into(), "-1".into())],
            correction: Some(Box::new(correction)),
            ..Default::default()
        };
        let shown = finding(&claim, &mut Typesetter::default()).into_string();
        assert!(
            shown.contains("only where x &gt; 0") && shown.contains("Fails for") && shown.contains("−1"),
            "{shown}"
        );
        assert_eq!(shown.matches("class=\"formula\"").count(), 1);
    }
}
