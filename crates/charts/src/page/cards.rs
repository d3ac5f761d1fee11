//! The small parts that sections share.

use crate::{Table, Verdict, text::Typesetter};
use maud::{Markup, PreEscaped, html};

/// A verdict as a word; its sign comes by [`signs`].
pub(super) fn chip(verdict: Verdict) -> Markup {
    html! { span class={ "chip " (verdict.name()) } { (verdict.name()) } }
}

/// The style that sets its sign before each verdict, not to be read aloud: once for the page, not once for each claim.
pub(super) fn signs() -> String {
    let rule = |verdict: Verdict| {
        let (name, sign) = (verdict.name(), verdict.sign());
        format!(".chip.{name}::before{{content:\"{sign}\";content:\"{sign}\"/\"\"}}")
    };
    Verdict::ALL.map(rule).concat()
}

/// A picture with its title above and its note below.
pub(super) fn figure(title: &str, svg: String, note: &str, set: &mut Typesetter) -> Markup {
    html! {
        figure {
            figcaption { (set.text(title)) }
            (PreEscaped(svg))
            @if !note.is_empty() { p.note { (set.text(note)) } }
        }
    }
}

/// Names with their values, line by line.
pub(super) fn facts(facts: &[(String, String)], set: &mut Typesetter) -> Markup {
    html! {
        @if !facts.is_empty() {
            dl.facts { @for (name, value) in facts { div { dt; (set.text(name)) dd; (set.text(value)) } } }
        }
    }
}

/// Tables of so many columns stand alone in their row.
const BROAD: usize = 5;

/// A table of texts that scrolls in its own box. Its cells and rows end where the next begin, as HTML allows.
pub(super) fn table(table: &Table, set: &mut Typesetter) -> Markup {
    let columns = table.rows.iter().map(Vec::len).chain([table.head.len()]).max().unwrap_or(0);
    let numeric: Vec<bool> = (0..columns)
        .map(|column| table.rows.iter().filter_map(|row| row.get(column)).all(|cell| is_number(cell)))
        .collect();
    let class = |column: usize| numeric.get(column).copied().unwrap_or(false).then_some("number");
    html! {
        div.scroll.broad[columns >= BROAD] {
            table {
                @if !table.caption.is_empty() { caption { (set.text(&table.caption)) } }
                thead { tr; @for (column, cell) in table.head.iter().enumerate() {
                    th scope="col" class=[class(column)]; (set.text(cell))
                } }
                tbody { @for row in &table.rows { tr; @for (column, cell) in row.iter().enumerate() {
                    td class=[class(column)]; (set.text(cell))
                } } }
            }
        }
    }
}

/// Whether a cell starts like a number: `−3.2·10⁻⁹`, `1 234`, `—`.
fn is_number(cell: &str) -> bool {
    if cell.contains(", ") {
        return false;
    }
    let digits = cell.trim_start_matches(['−', '-', '+', '<', '≤', '~', ' ']);
    matches!(cell, "" | "—" | "–" | "-") || digits.starts_with(|c: char| c.is_ascii_digit())
}
