//! Legends stand below the plot, so that they cover no data.

use super::{
    drawing::{Anchor, Drawing, LINE, WIDTH, shorten},
    marker::Look,
};

/// One entry.
pub(crate) struct Entry<'a> {
    pub look: Look,
    pub name: &'a str,
}

/// Draws the entries in as many equal columns as fit, each with its line and, where asked, its marker.
pub(crate) fn draw(drawing: &mut Drawing, entries: &[Entry], markers: bool) {
    let longest = entries.iter().map(|entry| entry.name.chars().count()).max().unwrap_or(0).min(56) as f64;
    let room = WIDTH - 16.0;
    let columns = ((room / (longest * 7.4 + 56.0)) as usize).clamp(1, 4).min(entries.len().max(1));
    let rows = entries.len().div_ceil(columns);
    for (position, entry) in entries.iter().enumerate() {
        let x = 8.0 + room / columns as f64 * (position / rows) as f64;
        let y = drawing.height + LINE * ((position % rows) as f64 + 0.5);
        drawing.open(&entry.look.class());
        drawing.line((x, y), (x + 34.0, y), "line");
        if markers {
            entry.look.marker(drawing, (x + 17.0, y), 4.2, "");
        }
        drawing.close();
        drawing.text((x + 41.0, y + 4.5), Anchor::Start, "", &shorten(entry.name, 56));
    }
    drawing.height += LINE * rows as f64 + 4.0;
}
