//! The figure of the crates by layers in ARCHITECTURE.md, generated from the workspace's manifests.

use super::rules::{layer, packages, read, root};
use std::fmt::Write;

/// Sizes in pixels: the whole figure, a box with its margin, a line of text.
const WIDTH: usize = 1080;
const LEFT: usize = 70;
const COLUMNS: usize = 4;
const BOX: (usize, usize) = (246, 82);
const MARGIN: usize = 6;
const LINE: usize = 14;
/// The characters per line in a box, and the lines below its name.
const LETTERS: usize = 35;
const LINES: usize = 4;

const STYLE: &str = "svg{color:#1a1d21;--paper:#fff;--row:#f3f5f7;--own:#0066aa}text{font:11.5px system-ui,-apple-system,\"Segoe UI\",Roboto,sans-serif;\
fill:currentColor}.name{font-size:14px;font-weight:600;fill:var(--own)}.layer{font-size:14px;font-weight:600}.row{fill:var(--row)}\
.box{fill:var(--paper);stroke:currentColor;stroke-opacity:.35}\
@media screen and (prefers-color-scheme:dark){svg{color:#e4e7eb;--paper:#15181c;--row:#20252b;--own:#6cb6ff;background:#15181c}}";

/// A crate: its short name and its description.
struct Crate {
    layer: i32,
    name: String,
    line: String,
}

/// The crates, those that use all others first.
fn crates() -> Vec<Crate> {
    let one = |package: &serde_json::Value| {
        let [name, line] = ["name", "description"].map(|key| package[key].as_str().unwrap_or_default().to_owned());
        assert!(!line.is_empty(), "{name} has no description in its manifest");
        let layer = layer(&name).unwrap_or_else(|| panic!("{name} has no layer"));
        let name = name.strip_prefix("dalembert-").unwrap_or(&name).to_owned();
        Crate { layer, name, line }
    };
    let mut crates: Vec<Crate> = packages().iter().map(one).collect();
    crates.sort_by(|a, b| b.layer.cmp(&a.layer).then_with(|| a.name.cmp(&b.name)));
    crates
}

/// The text in lines of at most this number of characters.
fn wrapped(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= LETTERS => *line += &format!(" {word}"),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The figure: one row for each layer, the highest layer on top.
fn drawing(crates: &[Crate]) -> String {
    let (mut body, mut top) = (String::new(), MARGIN);
    for row in crates.chunk_by(|a, b| a.layer == b.layer) {
        let height = row.len().div_ceil(COLUMNS) * (BOX.1 + MARGIN) + MARGIN;
        let (middle, layer) = (top + height / 2 + 5, row[0].layer);
        // writing to a string cannot fail
        let _ = write!(
            body,
            "<rect class=\"row\" y=\"{top}\" width=\"{WIDTH}\" height=\"{height}\" rx=\"4\"/>\n<text class=\"layer\" x=\"14\" y=\"{middle}\">{layer}</text>\n"
        );
        for (number, Crate { name, line, .. }) in row.iter().enumerate() {
            let x = LEFT + number % COLUMNS * (BOX.0 + MARGIN);
            let y = top + MARGIN + number / COLUMNS * (BOX.1 + MARGIN);
            let (width, height, text) = (BOX.0, BOX.1, x + 9);
            let _ = write!(
                body,
                "<rect class=\"box\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"4\"/><text class=\"name\" x=\"{text}\" y=\"{}\">{}</text>",
                y + 19,
                escaped(name)
            );
            let lines = wrapped(line);
            assert!(lines.len() <= LINES, "{name}: its description does not fit {LINES} lines of {LETTERS} characters");
            for (below, line) in lines.iter().enumerate() {
                let _ = write!(body, "<text x=\"{text}\" y=\"{}\">{}</text>", y + 35 + LINE * below, escaped(line));
            }
            body.push('\n');
        }
        top += height + MARGIN;
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"The crates by layers\" viewBox=\"0 0 {WIDTH} {top}\">\
         <style>{STYLE}</style>\n{body}</svg>\n"
    )
}

#[test]
fn the_drawing_of_the_crates_is_made_of_their_manifests() {
    let path = root().join("book/src/crates.svg");
    let made = drawing(&crates());
    if std::env::var_os("UPDATE_BOOK").is_some() {
        std::fs::write(&path, &made).expect("it is written");
    }
    let stored = if path.exists() { read(&path) } else { String::new() };
    assert!(stored == made, "UPDATE_BOOK=1 writes {} anew", path.display());
    assert!(read(&root().join("ARCHITECTURE.md")).contains("](book/src/crates.svg)"), "ARCHITECTURE.md shows it");
}
