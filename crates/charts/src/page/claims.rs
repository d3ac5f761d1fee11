//! The ledger: findings first, then every claim in its paper's order.

use super::{anchor, cards::chip};
use crate::{ClaimRow, PaperSection, Report, Verdict, text::Typesetter};
use maud::{Markup, html};

/// Every refuted claim beside what holds instead.
pub(super) fn findings(report: &Report, set: &mut Typesetter) -> Markup {
    let refuted = |paper: &PaperSection| paper.claims.iter().filter(|c| c.verdict == Verdict::Refuted).count();
    let total: usize = report.papers.iter().map(refuted).sum();
    html! {
        @if total > 0 {
            section #findings {
                h2 { "Findings" }
                p.lead { "Printed statements that fail, each with an exact counterexample, and what holds instead." }
                @for paper in report.papers.iter().filter(|paper| refuted(paper) > 0) {
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
        article.finding {
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
                @if let Some(correction) = &claim.correction {
                    p.side { "Holds instead " (chip(correction.verdict)) }
                    div class={ "said " (correction.verdict.name()) } {
                        @for latex in &correction.latex { (set.formula(latex)) }
                        @if correction.latex.is_empty() { p { (set.text(&correction.title)) } }
                    }
                } @else if let Some(difference) = &claim.difference {
                    p.side { "Left minus right" }
                    div.said { (set.formula(difference)) }
                }
            }
            @if !claim.note.is_empty() { p.note { (set.text(&claim.note)) } }
        }
    }
}

/// A paper's claims, with filters where scripts run.
pub(super) fn ledger(paper: &PaperSection, set: &mut Typesetter) -> Markup {
    set.at(&paper.id);
    let present = Verdict::ALL.into_iter().filter(|verdict| paper.count(*verdict) > 0);
    html! {
        section.ledger id=(anchor(&paper.id)) {
            h2 { (set.text(&paper.title)) }
            @if !paper.citation.is_empty() { p.citation { (set.text(&paper.citation)) } }
            @if !paper.summary.is_empty() { p.lead { (set.text(&paper.summary)) } }
            div.filter role="group" aria-label={ "Show claims of " (paper.id) } hidden {
                @for verdict in present {
                    button type="button" data-verdict=(verdict.name()) aria-pressed="false" class={ "chip " (verdict.name()) } {
                        span.sign aria-hidden="true" { (verdict.sign()) } " " (verdict.name()) " "
                        span.count { (paper.count(verdict)) }
                    }
                }
                label { span.visually-hidden { "Filter by text" }
                    input type="search" placeholder="filter by text" autocomplete="off" spellcheck="false"; }
                output aria-live="polite" {}
            }
            @for claim in &paper.claims { (row(claim, set)) }
        }
    }
}

fn row(claim: &ClaimRow, set: &mut Typesetter) -> Markup {
    set.at(&claim.id);
    let anchor = anchor(&claim.id);
    html! {
        article class={ "claim " (claim.verdict.name()) } id=(anchor) data-verdict=(claim.verdict.name()) {
            div.margin { (chip(claim.verdict)) span.label { (claim.equation_label) } }
            div.body {
                div.title { h3 { (set.text(&claim.title)) } a.id href={ "#" (anchor) } { (claim.id) } }
                (statement(claim, set))
                @if let Some(correction) = &claim.correction {
                    div class={ "correction " (correction.verdict.name()) } {
                        p.side { "Holds instead " (chip(correction.verdict)) }
                        @if !correction.title.is_empty() { p { (set.text(&correction.title)) } }
                        (statement(correction, set))
                    }
                }
            }
        }
    }
}

/// What a claim says and what is known of it, without its heading.
fn statement(claim: &ClaimRow, set: &mut Typesetter) -> Markup {
    html! {
        @for latex in &claim.latex { (set.formula(latex)) }
        @if !claim.requires.is_empty() {
            p.requires { b { "Requires " } @for (position, condition) in claim.requires.iter().enumerate() {
                @if position > 0 { "; " } (set.text(condition))
            } }
        }
        @if !claim.evidence.is_empty() { p.evidence { b { "Evidence " } (set.text(&claim.evidence)) } }
        @if let Some(difference) = &claim.difference {
            div.difference { p.side { "Left minus right" } (set.formula(difference)) }
        }
        @if !claim.counterexample.is_empty() {
            div.counterexample {
                p.side { "Counterexample" }
                dl { @for (name, value) in &claim.counterexample {
                    div { dt { (set.text(name)) } " " dd { (set.text(value)) } }
                } }
            }
        }
        @if !claim.note.is_empty() { p.note { (set.text(&claim.note)) } }
    }
}
