//! The claims of a paper on the live page, while they are judged: the LaTeX source of each formula next to the typeset formula.

use super::super::cards::chip;
use super::super::{conditions, statement};
use crate::{ClaimRow, text::Typesetter};
use maud::{Markup, html};

/// A claim with the LaTeX source of its formula.
#[derive(Clone, Debug, Default)]
pub struct LiveClaim {
    /// The LaTeX as it stands in the file.
    pub source: String,
    /// The judged claim; `None` before it is judged.
    pub row: Option<ClaimRow>,
    /// The number of the formula in the paper, and its line in the file.
    pub label: String,
}

/// HTML of all claims in the order of the file, including claims that are not judged yet.
pub fn claims(all: &[LiveClaim]) -> String {
    let mut set = Typesetter::default();
    let set = &mut set;
    let decided = all.iter().filter(|claim| claim.row.is_some()).count();
    html! {
        p.note { (decided) " of " (all.len()) " decided" }
        @for claim in all { (article(claim, set)) }
    }
    .into_string()
}

fn article(LiveClaim { source, row, label }: &LiveClaim, set: &mut Typesetter) -> Markup {
    let verdict = row.as_ref().map_or("open", |row| row.verdict.name());
    html! {
        article class={ "claim " (verdict) } {
            div.margin {
                @match row { Some(row) => (chip(row.verdict)), None => span.chip.open { "at work" } }
                span.label { (label) }
            }
            div.body {
                @if let Some(row) = row { @if !row.title.is_empty() { h4 { (set.text(&row.title)) } } }
                div.beside {
                    pre.source { (source) }
                    div { @if let Some(row) = row { (read(row, set)) } @else { (set.formula(source)) } }
                }
                @if let Some(row) = row { (known(row, set)) }
            }
        }
    }
}

/// The typeset formula as the program understood it, and its correction.
fn read(row: &ClaimRow, set: &mut Typesetter) -> Markup {
    html! {
        @for latex in &row.latex { (set.formula(latex)) }
        @if let Some(correction) = &row.correction {
            p.side { "Correction, " (correction.verdict.name()) ": " (set.text(&correction.title)) }
            @for latex in &correction.latex { (set.formula(latex)) }
            (statement::remarks(correction, set))
        }
    }
}

/// The grounds of the verdict: conditions, evidence, counterexample, difference and remarks.
fn known(row: &ClaimRow, set: &mut Typesetter) -> Markup {
    html! {
        div.known { (conditions::requires(&row.requires, set)) (statement::evidence(row, set)) }
        @if !row.counterexample.is_empty() {
            div.counterexample { p.side { "Exact values" } (statement::values(&row.counterexample, set)) }
        }
        @if let Some(difference) = &row.difference {
            div.difference { p.side { "Left minus right" } (set.formula(difference)) }
        }
        (statement::remarks(row, set))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Verdict;

    #[test]
    fn a_claim_shows_its_source_its_verdict_and_its_correction() {
        let correction = ClaimRow { latex: vec!["x = 2".into()], verdict: Verdict::Proved, ..ClaimRow::default() };
        let row = ClaimRow {
            latex: vec!["x < 1".into()],
            verdict: Verdict::Refuted,
            correction: Some(Box::new(correction)),
            ..ClaimRow::default()
        };
        let open = LiveClaim { source: "y < 1".into(), ..LiveClaim::default() };
        let shown = claims(&[LiveClaim { source: "x < 1".into(), row: Some(row), label: "(1)".into() }, open]);
        assert!(shown.contains("1 of 2 decided") && shown.contains("<pre class=\"source\">x &lt; 1</pre>"), "{shown}");
        assert!(shown.contains("chip refuted") && shown.contains("Correction, proved") && shown.contains("at work"));
    }
}
