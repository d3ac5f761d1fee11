//! The head of the page: title, summary, numbers of claims by verdict, contents.

use super::{
    anchor,
    cards::{chip, numeric},
    claims,
};
use crate::{Report, Verdict, text::Typesetter};
use maud::{Markup, html};

/// The title, the summary and the table of the numbers of claims.
pub(super) fn heading(report: &Report, set: &mut Typesetter) -> Markup {
    html! {
        header.masthead {
            h1 { (set.text(&report.title)) }
            p.summary { (set.text(&report.summary)) }
            @if !report.papers.is_empty() { (counts(report, set)) }
        }
    }
}

/// The table of the numbers of claims: one row per paper, one column per verdict that occurs, with the meaning of each verdict.
fn counts(report: &Report, set: &mut Typesetter) -> Markup {
    let number = |count: usize| html! { td { @if count > 0 { (count) } @else { span.none { "·" } } } };
    let verdicts: Vec<Verdict> = Verdict::ALL.into_iter().filter(|verdict| report.count(*verdict) > 0).collect();
    html! {
        div.scroll tabindex="0" role="region" aria-label="Claims by verdict" {
            table class={ "counts " (numeric(1..verdicts.len() + 2)) } {
                thead { tr {
                    th scope="col" { "Claims" }
                    @for verdict in &verdicts { th scope="col" {
                        (chip(*verdict)) " " span.meaning { (verdict.meaning()) }
                    } }
                    th scope="col" { "all" }
                } }
                tbody { @for paper in &report.papers { tr {
                    th scope="row" { a href={ "#" (anchor(&paper.id)) } { (set.text(&paper.title)) } }
                    @for verdict in &verdicts { (number(paper.count(*verdict))) }
                    (number(paper.claims.len()))
                } } }
                @if report.papers.len() > 1 { tfoot { tr {
                    th scope="row" { "together" }
                    @for verdict in &verdicts { (number(report.count(*verdict))) }
                    (number(report.papers.iter().map(|paper| paper.claims.len()).sum()))
                } } }
            }
        }
    }
}

/// The table of contents, next to the page or above it.
pub(super) fn contents(report: &Report, set: &mut Typesetter) -> Markup {
    let refuted = report.count(Verdict::Refuted);
    html! {
        nav.contents aria-label="Contents" {
            div.search role="search" hidden {
                label { span.visually-hidden { "Search the whole page" }
                    input type="search" placeholder="search the whole page" autocomplete="off" spellcheck="false"; }
                output aria-live="polite" {}
                ol {}
            }
            h2 { "Contents" }
            ol {
                @if refuted > 0 { li { a href="#findings" { "Findings" } span.count { (refuted) " refuted" } } }
                @for paper in &report.papers {
                    li { a href={ "#" (anchor(&paper.id)) } { (set.text(&paper.title)) }
                        span.count { (claims::counts(&paper.claims)) }
                        ol { @for (position, group) in paper.groups().enumerate() {
                            @if let Some(heading) = claims::heading(group) { li {
                                a href={ "#" (claims::part(paper, position)) } { (set.text(heading)) } " "
                                span.count { (group.len()) }
                            } }
                        } }
                    }
                }
                @if !report.scenes.is_empty() {
                    li { a href="#scenes" { "Scenes" }
                        ol { @for scene in &report.scenes {
                            li { a href={ "#" (anchor(&scene.id)) } { (set.text(&scene.title)) } }
                        } }
                    }
                }
                @if !report.spheres.is_empty() { li { a href="#spheres" { "Directions on the sphere" } } }
                @if !report.stability.is_empty() || !report.approximations.is_empty() {
                    li { a href="#governors" { "Stability and series" } }
                }
                @if !report.friction.is_empty() || !report.rough.is_empty() {
                    li { a href="#friction" { "Friction" }
                        ol { @for scene in &report.rough {
                            li { a href={ "#" (anchor(&scene.id)) } { (set.text(&scene.title)) } }
                        } }
                    }
                }
                @for study in &report.studies { li { a href={ "#" (study.id) } { (set.text(&study.title)) } } }
                @if !report.timings.is_empty() || !report.timings_missing.is_empty() { li { a href="#timings" { "Timings" } } }
            }
        }
    }
}
