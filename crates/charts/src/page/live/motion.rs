//! The part of the live page about a run: summary, time series and phase portraits.

use crate::{Sheet, visible};
use maud::{PreEscaped, html};

/// HTML of the charts of a sheet and of the printed summary. Each chart is a figure of its own, so that charts stand below each other on a
/// narrow screen.
pub fn motion(sheet: &Sheet, summary: &str) -> String {
    let label = |position: usize| if position == 0 { "against time" } else { "speeds over coordinates" };
    html! {
        div.pair {
            @for (position, column) in sheet.columns.iter().enumerate().filter(|(_, column)| !column.is_empty()) {
                div { @for chart in column {
                    figure { (PreEscaped(chart.drawing().embedded(&format!("{}, {}", sheet.title, label(position))))) }
                } }
            }
        }
        @if !sheet.note.is_empty() { p.note { (sheet.note) } }
        details open { summary { "Summary" } pre.told { (visible(summary)) } }
    }
    .into_string()
}
