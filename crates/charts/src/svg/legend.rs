//! Legends. They stand below the plot, where they cover no data.

use super::{
    drawing::{Anchor, Drawing, LINE, WIDTH, shorten},
    marker::Look,
};

/// A series in a legend.
pub(crate) struct Entry<'a> {
    pub look: Look,
    pub name: &'a str,
}

/// Draws the entries in as many columns as fit, at most four. Each has its line and, with `markers`, its marker.
pub(crate) fn draw(drawing: &mut Drawing, entries: &[Entry], markers: bool) {
    let (rows, widths) =
        (1..=4).rev().map(|columns| layout(entries, columns)).find(fits).unwrap_or((entries.len(), vec![]));
    for (position, entry) in entries.iter().enumerate() {
        let x = 8.0 + widths.iter().take(position / rows.max(1)).sum::<f64>();
        let y = drawing.height + LINE * ((position % rows.max(1)) as f64 + 0.5);
        drawing.open(&entry.look.class());
        drawing.line((x, y), (x + 34.0, y), "line");
        if markers {
            entry.look.marker(drawing, (x + 17.0, y), 4.2, "");
        }
        drawing.close();
        drawing.text((x + 41.0, y + 4.5), Anchor::Start, "small", &shorten(entry.name, LONGEST));
    }
    drawing.height += LINE * rows as f64 + 4.0;
}

/// Draws the entries in one row from the position `(left, y)`, without markers. Where the row does not fit, draws nothing and returns false.
pub(crate) fn in_a_row(drawing: &mut Drawing, entries: &[Entry], (left, y): (f64, f64), right: f64) -> bool {
    let width = |entry: &Entry| 7.6 * entry.name.chars().count().min(LONGEST) as f64 + 37.0;
    if left + entries.iter().map(width).sum::<f64>() > right {
        return false;
    }
    let mut x = left;
    for entry in entries {
        drawing.open(&entry.look.class());
        drawing.line((x, y - 4.5), (x + 22.0, y - 4.5), "line");
        drawing.close();
        drawing.text((x + 26.0, y), Anchor::Start, "small", &shorten(entry.name, LONGEST));
        x += width(entry);
    }
    true
}

const LONGEST: usize = 66;

/// The number of rows for a given number of columns, and the width of each column in pixels.
fn layout(entries: &[Entry], columns: usize) -> (usize, Vec<f64>) {
    let rows = entries.len().div_ceil(columns).max(1);
    let width = |name: &str| 7.1 * name.chars().count().min(LONGEST) as f64 + 57.0;
    let widest = |column: &[Entry]| column.iter().map(|entry| width(entry.name)).fold(0.0, f64::max);
    (rows, entries.chunks(rows).map(widest).collect())
}

fn fits((_, widths): &(usize, Vec<f64>)) -> bool {
    widths.iter().sum::<f64>() <= WIDTH - 4.0
}
