//! The drawing to which charts add lines, shapes and texts.

use super::{
    STYLE,
    number::{coordinate, counted},
};
use maud::html;
use std::fmt::Write;

/// The width of every chart in user units of SVG. Since all charts have this width, text has one size across the page.
pub(crate) const WIDTH: f64 = 520.0;
/// The height of a line of text in pixels.
pub(crate) const LINE: f64 = 18.0;

/// The alignment of a text at its point.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// The SVG elements drawn so far. Texts and tooltips are escaped here and nowhere else.
#[derive(Clone, Debug, Default)]
pub(crate) struct Drawing {
    body: String,
    /// The height in pixels.
    pub height: f64,
    /// The width as a multiple of `WIDTH`; both 0 and 1 mean one column.
    columns: usize,
}

impl Drawing {
    /// Starts a group with this CSS class; [`Drawing::close`] ends it.
    pub fn open(&mut self, class: &str) {
        let _ = write!(self.body, "<g class=\"{class}\">");
    }

    pub fn close(&mut self) {
        self.body += "</g>";
    }

    pub fn line(&mut self, (x1, y1): (f64, f64), (x2, y2): (f64, f64), class: &str) {
        let [x1, y1, x2, y2] = [x1, y1, x2, y2].map(coordinate);
        let _ = write!(self.body, "<path class=\"{class}\" d=\"M{x1} {y1}L{x2} {y2}\"/>");
    }

    /// Draws vertical and horizontal grid lines across a frame, as one path.
    pub fn grid(
        &mut self,
        upright: impl Iterator<Item = f64>,
        level: impl Iterator<Item = f64>,
        [left, right, top, bottom]: [f64; 4],
        class: &str,
    ) {
        let [left, right, top, bottom] = [left, right, top, bottom].map(coordinate);
        let upright = upright.map(|x| format!("M{} {top}V{bottom}", coordinate(x)));
        let level = level.map(|y| format!("M{left} {}H{right}", coordinate(y)));
        self.path(&upright.chain(level).collect::<String>(), class);
    }

    /// Draws boxes of one class as one path; a box is given by its corner x, y, its width and its height.
    pub fn boxes(&mut self, boxes: &[[f64; 4]], class: &str) {
        let one = |each: &[f64; 4]| {
            let [x, y, width, height] = each.map(coordinate);
            format!("M{x} {y}h{width}v{height}H{x}z")
        };
        self.path(&boxes.iter().map(one).collect::<String>(), class);
    }

    pub fn rect(&mut self, (x, y): (f64, f64), width: f64, height: f64, class: &str) {
        let [x, y, width, height] = [x, y, width, height].map(coordinate);
        let _ =
            write!(self.body, "<rect class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/>");
    }

    pub fn circle(&mut self, (x, y): (f64, f64), radius: f64, class: &str) {
        let [x, y, radius] = [x, y, radius].map(coordinate);
        let _ = write!(self.body, "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>");
    }

    pub fn path(&mut self, d: &str, class: &str) {
        // the space before a minus sign is superfluous, since the sign separates numbers
        let d = d.replace(" -", "-");
        if !d.is_empty() {
            let _ = write!(self.body, "<path class=\"{class}\" d=\"{d}\"/>");
        }
    }

    /// Draws a path with further attributes; `moved` contains the elements of its animation.
    pub fn path_with(&mut self, d: &str, class: &str, attributes: &str, moved: &str) {
        let d = d.replace(" -", "-");
        let _ = write!(self.body, "<path class=\"{class}\" d=\"{d}\"{attributes}>{moved}</path>");
    }

    /// Draws a text with further attributes; `moved` contains the elements of its animation.
    pub fn text_with(&mut self, (x, y): (f64, f64), class: &str, text: &str, attributes: &str, moved: &str) {
        let (x, y, text) = (coordinate(x), coordinate(y), html!((text)).0);
        let _ = write!(self.body, "<text class=\"{class}\" x=\"{x}\" y=\"{y}\"{attributes}>{text}{moved}</text>");
    }

    pub fn path_with_tooltip(&mut self, d: &str, class: &str, tooltip: &str) {
        if d.is_empty() {
            return;
        }
        let d = d.replace(" -", "-");
        let tooltip = html! { @if !tooltip.is_empty() { title { (tooltip) } } }.0;
        let _ = write!(self.body, "<path class=\"{class}\" d=\"{d}\">{tooltip}</path>");
    }

    pub fn text(&mut self, (x, y): (f64, f64), anchor: Anchor, class: &str, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let (x, y) = (coordinate(x), coordinate(y));
        let text = html!((text)).0;
        let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
        let _ = write!(self.body, "<text{class} x=\"{x}\" y=\"{y}\"{anchor}>{text}</text>");
    }

    /// Draws a vertical text that reads from bottom to top, centred on the point.
    pub fn upward(&mut self, (x, y): (f64, f64), text: &str) {
        let (x, y) = (coordinate(x), coordinate(y));
        let text = html!((text)).0;
        let _ =
            write!(self.body, "<text text-anchor=\"middle\" transform=\"translate({x} {y})rotate(-90)\">{text}</text>");
    }

    /// Puts these drawings side by side below everything drawn so far.
    pub fn below(&mut self, others: &[Drawing]) {
        for (column, other) in others.iter().enumerate() {
            let (x, y) = (coordinate(column as f64 * WIDTH), coordinate(self.height));
            let _ = write!(self.body, "<g transform=\"translate({x} {y})\">{}</g>", other.body);
        }
        self.columns = self.columns.max(others.len());
        self.height += others.iter().map(|other| other.height).fold(0.0, f64::max);
    }

    /// Writes a paragraph below everything drawn so far.
    pub fn paragraph(&mut self, text: &str, class: &str) {
        for line in wrap(text, 74 * self.columns.max(1)) {
            self.height += LINE - 1.0;
            self.text((8.0, self.height - 5.0), Anchor::Start, class, &line);
        }
    }

    /// The SVG element for a page that contains the style sheet; `label` is the text for screen readers.
    pub fn embedded(&self, label: &str) -> String {
        self.element(label, "", "")
    }

    /// The SVG file, with its title as a heading.
    pub fn standalone(&self, title: &str) -> String {
        self.standalone_in(title, STYLE)
    }

    /// The SVG file with another style sheet.
    pub fn standalone_in(&self, title: &str, style: &str) -> String {
        let style = format!("<style>{style}</style>");
        self.element(title, " xmlns=\"http://www.w3.org/2000/svg\"", &style)
    }

    fn element(&self, title: &str, namespace: &str, style: &str) -> String {
        let label = html! { i title=(title) {} }.0;
        let label = label.trim_start_matches("<i title=").trim_end_matches("></i>");
        let columns = self.columns.max(1);
        let lines = if style.is_empty() { Vec::new() } else { wrap(title, 52 * columns) };
        let heading = if lines.is_empty() { 0.0 } else { 24.0 + LINE * (lines.len() - 1) as f64 };
        let width = coordinate(columns as f64 * WIDTH);
        let (top, height) = (coordinate(-heading), coordinate(self.height.ceil() + heading));
        let title: String = lines
            .iter()
            .rev()
            .enumerate()
            .map(|(above, line)| {
                let (y, line) = (coordinate(-6.0 - LINE * above as f64), html!((line)).0);
                format!("<text class=\"title\" x=\"8\" y=\"{y}\">{line}</text>")
            })
            .collect();
        let body = &self.body;
        let svg = format!(
            "<svg{namespace} class=\"picture\" role=\"img\" aria-label={label} viewBox=\"0 {top} {width} {height}\">\
             {style}{title}{body}</svg>"
        );
        crate::visible(&svg).into_owned()
    }
}

/// The words of a text in lines of at most `limit` characters; a longer word has a line of its own.
pub(crate) fn wrap(text: &str, limit: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= limit => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The text if it has at most `limit` characters; otherwise its beginning with an ellipsis.
pub(crate) fn shorten(text: &str, limit: usize) -> String {
    if text.chars().count() <= limit {
        return text.to_owned();
    }
    text.chars().take(limit.saturating_sub(1)).collect::<String>().trim_end().to_owned() + "…"
}

/// The sentence that states the number of points left out of a chart, and the reason; empty for zero.
pub(crate) fn left_out(count: usize, why: &str) -> String {
    match count {
        0 => String::new(),
        1 => format!("1 point left out: {why}."),
        _ => format!("{} points left out: {why}.", counted(count as f64)),
    }
}
