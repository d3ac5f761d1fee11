//! Small parts of the page that sections share.

use crate::{Table, Verdict, text::Typesetter};
use maud::{Markup, PreEscaped, html};

/// The label with the name of a verdict; the style from [`signs`] adds its sign.
pub(super) fn chip(verdict: Verdict) -> Markup {
    html! { span class={ "chip " (verdict.name()) } { (verdict.name()) } }
}

/// The CSS rules that put a sign before each verdict, hidden from screen readers. They occur once in the page, not once for each claim.
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

/// A list of names with their values, one per line.
pub(super) fn facts(facts: &[(String, String)], set: &mut Typesetter) -> Markup {
    html! {
        @if !facts.is_empty() {
            dl.facts { @for (name, value) in facts { div { dt; (set.text(name)) dd; (set.text(value)) } } }
        }
    }
}

/// The least number of columns for which a table takes the full width of the page.
const BROAD: usize = 5;

/// A table of texts in a box with scroll bars of its own. End tags of cells and rows are left out, as HTML allows.
pub(super) fn table(table: &Table, set: &mut Typesetter) -> Markup {
    let columns = table.rows.iter().map(Vec::len).chain([table.head.len()]).max().unwrap_or(0);
    let cells = |column| table.rows.iter().filter_map(move |row| row.get(column));
    let numeric = numeric((0..columns).filter(|&column| cells(column).all(|cell| is_number(cell))));
    html! {
        div.scroll.broad[columns >= BROAD] {
            table class=[(!numeric.is_empty()).then_some(&numeric)] {
                @if !table.caption.is_empty() { caption { (set.text(&table.caption)) } }
                thead { tr; @for cell in &table.head { th scope="col"; (set.text(cell)) } }
                tbody { @for row in &table.rows { tr; @for cell in row { td; (set.text(cell)) } } }
            }
        }
    }
}

/// The number of columns that can be aligned as numbers; later ones are set as text.
const COLUMNS: usize = 24;

/// The CSS class of a table in which the columns with these indices (from 0) are numbers. It is set once for the table, not for each cell.
pub(super) fn numeric(columns: impl IntoIterator<Item = usize>) -> String {
    columns.into_iter().map(|column| format!("n{}", column + 1)).collect::<Vec<_>>().join(" ")
}

/// The CSS rules for the classes of [`numeric`].
pub(super) fn numbers() -> String {
    let all = |cell: &str| {
        let column = |n| format!(".n{n} {cell}:nth-child({n})");
        (1..=COLUMNS).map(column).collect::<Vec<_>>().join(",")
    };
    let (values, heads) = (all("td"), all("th"));
    format!(
        "{values}{{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}}\
         {heads}{{text-align:right;max-width:13em}}"
    )
}

/// Whether the text of a cell starts like a number: `−3.2·10⁻⁹`, `1 234`, `—`.
fn is_number(cell: &str) -> bool {
    if cell.contains(", ") {
        return false;
    }
    let digits = cell.trim_start_matches(['−', '-', '+', '<', '≤', '~', ' ']);
    matches!(cell, "" | "—" | "–" | "-") || digits.starts_with(|c: char| c.is_ascii_digit())
}
