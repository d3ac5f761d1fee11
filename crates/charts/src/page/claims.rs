//! The ledger on the page: all claims in the order of their paper, under the headings of its sections.

use super::{anchor, cards::chip, statement};
use crate::{ClaimRow, PaperSection, Verdict, text::Typesetter};
use maud::{Markup, html};

/// The ledger of a paper, with buttons that filter by verdict where scripts run.
pub(super) fn ledger(paper: &PaperSection, set: &mut Typesetter) -> Markup {
    set.at(&paper.id);
    html! {
        section.ledger id=(anchor(&paper.id)) {
            h2 { (set.text(&paper.title)) }
            @if !paper.citation.is_empty() { p.citation { (set.text(&paper.citation)) } }
            @if !paper.summary.is_empty() { p.lead { (set.text(&paper.summary)) } }
            (filter(paper))
            @for (position, group) in paper.groups().enumerate() {
                div.group {
                    @if let Some(heading) = heading(group) {
                        h3.part id=(part(paper, position)) { (set.text(heading)) " " span.count { (counts(group)) } }
                    }
                    @for claim in group { (row(claim, set)) }
                }
            }
        }
    }
}

/// The title of the section to which these claims belong; `None` where they belong to no section.
pub(super) fn heading(group: &[ClaimRow]) -> Option<&str> {
    group.first().map(|claim| claim.section.as_str()).filter(|section| !section.is_empty())
}

/// The link to a section of a paper; `position` is the index of the section, from 0.
pub(super) fn part(paper: &PaperSection, position: usize) -> String {
    format!("{}/part{}", anchor(&paper.id), position + 1)
}

/// The number of claims, followed by the number of claims for each verdict that needs a reader's attention, as text.
pub(super) fn counts(group: &[ClaimRow]) -> String {
    let noteworthy = [Verdict::Refuted, Verdict::Undefined, Verdict::Undecided, Verdict::Open];
    let counted = noteworthy.map(|verdict| (verdict, group.iter().filter(|claim| claim.verdict == verdict).count()));
    let total = group.len();
    let head = if total == 1 { "1 claim".to_owned() } else { format!("{total} claims") };
    let named = counted.iter().filter(|(_, count)| *count > 0);
    named.fold(head, |text, (verdict, count)| format!("{text}, {count} {}", verdict.name()))
}

fn filter(paper: &PaperSection) -> Markup {
    let present = Verdict::ALL.into_iter().filter(|verdict| paper.count(*verdict) > 0);
    html! {
        div.filter role="group" aria-label={ "Show claims of " (paper.id) } hidden {
            @for verdict in present {
                button type="button" data-verdict=(verdict.name()) aria-pressed="false" class={ "chip " (verdict.name()) }
                    title={ (verdict.meaning()) @if verdict == Verdict::Proved { (statement::UNTOLD) } } {
                    (verdict.name()) " "
                    span.count { (paper.count(verdict)) }
                }
            }
            label { span.visually-hidden { "Filter by text" }
                input type="search" placeholder="filter by text" autocomplete="off" spellcheck="false"; }
            output aria-live="polite" {}
        }
    }
}

fn row(claim: &ClaimRow, set: &mut Typesetter) -> Markup {
    set.at(&claim.id);
    let anchor = anchor(&claim.id);
    html! {
        article class={ "claim " (claim.verdict.name()) } id=(anchor) {
            div.margin { (chip(claim.verdict)) span.label { (claim.equation_label) } }
            div.body {
                div.title { h4 { (set.text(&claim.title)) } a.id href={ "#" (anchor) } { (claim.id) } }
                (statement::whole(claim, set))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim(section: &str, verdict: Verdict) -> ClaimRow {
        ClaimRow { section: section.into(), verdict, ..Default::default() }
    }

    #[test]
    fn claims_stand_under_the_headings_of_their_paper() {
        let claims =
            vec![claim("1. A", Verdict::Proved), claim("1. A", Verdict::Refuted), claim("2. B", Verdict::Proved)];
        let paper = PaperSection { id: "doe".into(), claims, ..Default::default() };
        let html = ledger(&paper, &mut Typesetter::default()).into_string();
        assert!(html.contains("id=\"doe/part1\">1. A <span class=\"count\">2 claims, 1 refuted</span>"), "{html}");
        assert!(html.contains("id=\"doe/part2\">2. B <span class=\"count\">1 claim</span>"), "{html}");
    }

    #[test]
    fn claims_without_sections_have_no_headings() {
        let paper = PaperSection { claims: vec![claim("", Verdict::Proved)], ..Default::default() };
        assert!(!ledger(&paper, &mut Typesetter::default()).into_string().contains("<h3"));
    }
}
