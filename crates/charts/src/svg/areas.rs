//! Maps over a plane of two quantities: cells coloured by kind, curves over them, marked points.

use super::{
    axis::{Axis, Tick},
    drawing::{Anchor, Drawing, LINE, WIDTH},
    path::polyline,
};

/// A map of cells, each of one kind, with curves and points. A map may have no cells.
#[derive(Clone, Debug, Default)]
pub struct Areas {
    pub title: String,
    /// The label and the bounds of the horizontal axis.
    pub x: (String, [f64; 2]),
    /// The label and the bounds of the vertical axis.
    pub y: (String, [f64; 2]),
    /// The names of the rows of cells, from the lowest, where rows are not values of a quantity; empty otherwise.
    pub names: Vec<String>,
    /// The names of the kinds of cells, in the order of the legend.
    pub kinds: Vec<String>,
    /// The kind of each cell as an index into `kinds`: rows from the lowest, cells from the left. All rows have one length.
    pub rows: Vec<Vec<usize>>,
    pub curves: Vec<AreaCurve>,
    /// Sets of single points; the points of one set share a name.
    pub dots: Vec<AreaCurve>,
    /// Marked points (x, y) with their labels.
    pub marks: Vec<(f64, f64, String)>,
    /// The text below the map.
    pub note: String,
}

/// A curve over the plane.
#[derive(Clone, Debug, Default)]
pub struct AreaCurve {
    pub name: String,
    /// Points (x, y) in the units of the axes.
    pub points: Vec<(f64, f64)>,
}

/// The left edge of the map in pixels, where the labels of the ticks are short numbers; [`LEFT_OF_NAMES`] where they are names.
const LEFT: f64 = 56.0;
const LEFT_OF_NAMES: f64 = 160.0;
/// The width in pixels of the label next to the axis with its gaps; [`DIGIT`] is the width of a digit.
const LABEL: f64 = 32.0;
const DIGIT: f64 = 8.5;
const RIGHT: f64 = WIDTH - 14.0;
const TOP: f64 = 10.0;
const BOTTOM: f64 = 330.0;

/// The number of colours of cells; further kinds repeat the colours.
const COLOURS: usize = 12;
/// The largest number of points of a dashed curve; dashes would hide a longer one.
const DENSE: usize = 300;

impl Areas {
    /// The picture as an SVG file.
    pub fn svg(&self) -> String {
        self.drawing().standalone(&self.title)
    }

    /// Several maps as one SVG file, two in a row, each under its title. The legend of the first map and the note stand below all of them.
    pub fn sheet(pictures: &[Areas], title: &str, note: &str) -> String {
        let mut sheet = Drawing::default();
        for row in pictures.chunks(2) {
            let titled = |picture: &Areas| {
                let mut panel = Drawing::default();
                panel.height += LINE;
                panel.text((8.0, LINE - 4.0), Anchor::Start, "", &picture.title);
                panel.below(&[picture.plane()]);
                panel
            };
            sheet.below(&row.iter().map(titled).collect::<Vec<_>>());
        }
        if let Some(first) = pictures.first() {
            first.legend(&mut sheet);
        }
        sheet.paragraph(note, "");
        sheet.standalone(title)
    }

    pub(crate) fn drawing(&self) -> Drawing {
        let mut drawing = self.plane();
        self.legend(&mut drawing);
        drawing
    }

    /// The drawing of the map without its legend.
    fn plane(&self) -> Drawing {
        let mut y = Axis::linear(self.y.1.into_iter(), BOTTOM, TOP, 50.0, 0.0);
        if !self.names.is_empty() {
            let [low, high] = self.y.1;
            let height = (high - low) / self.names.len() as f64;
            let tick = |(number, name): (usize, &String)| Tick {
                at: low + (number as f64 + 0.5) * height,
                label: Some(name.clone()),
            };
            y.ticks = self.names.iter().enumerate().map(tick).collect();
        }
        let left = self.left(&y);
        let x = Axis::linear(self.x.1.into_iter(), left, RIGHT, 70.0, 0.0);
        let mut drawing = Drawing::default();
        self.cells(&mut drawing, left);
        let level = y.ticks.iter().filter(|_| self.names.is_empty()).map(|tick| y.place(tick.at));
        drawing.grid(x.ticks.iter().map(|tick| x.place(tick.at)), level, [left, RIGHT, TOP, BOTTOM], "fine");
        for Tick { at, label } in &x.ticks {
            drawing.text((x.place(*at), BOTTOM + 18.0), Anchor::Middle, "", label.as_deref().unwrap_or(""));
        }
        for Tick { at, label } in &y.ticks {
            drawing.text((left - 8.0, y.place(*at) + 5.0), Anchor::End, "", label.as_deref().unwrap_or(""));
        }
        for (number, curve) in self.curves.iter().enumerate() {
            let [low, high] = self.y.1;
            for piece in curve.points.split(|(_, value)| !(low..=high).contains(value)) {
                let points: Vec<_> = piece.iter().map(|(a, b)| (x.place(*a), y.place(*b))).collect();
                self.stroke(&mut drawing, number, &polyline(&points), points.len(), &curve.name);
            }
        }
        for (number, dots) in self.dots.iter().enumerate() {
            dots.points.iter().for_each(|(a, b)| dot(&mut drawing, number, (x.place(*a), y.place(*b))));
        }
        for (a, b, label) in &self.marks {
            let at = (x.place(*a), y.place(*b));
            drawing.circle(at, 4.0, "dot");
            drawing.text((at.0 + 8.0, at.1 + 18.0), Anchor::Start, "mark-name", label);
        }
        drawing.rect((left, TOP), RIGHT - left, BOTTOM - TOP, "box");
        drawing.text((0.5 * (left + RIGHT), BOTTOM + 38.0), Anchor::Middle, "", &self.x.0);
        drawing.upward((16.0, 0.5 * (TOP + BOTTOM)), &self.y.0);
        drawing.height = BOTTOM + 50.0;
        drawing
    }

    /// The left edge of the map in pixels, to the right of the label and numbers of the axis.
    fn left(&self, y: &Axis) -> f64 {
        let widest = y.ticks.iter().flat_map(|tick| &tick.label).map(|label| label.chars().count()).max().unwrap_or(0);
        if self.names.is_empty() { LEFT.max(LABEL + DIGIT * widest as f64) } else { LEFT_OF_NAMES }
    }

    /// Draws a curve: dark over coloured cells, in a colour of its own on a map without cells.
    fn stroke(&self, drawing: &mut Drawing, number: usize, d: &str, points: usize, tooltip: &str) {
        if d.is_empty() {
            return;
        }
        if !self.rows.is_empty() {
            return drawing.path_with_tooltip(d, &format!("over o{}", number % 3), tooltip);
        }
        drawing.open(&format!("s{}", number % 12));
        drawing.path_with_tooltip(d, if points > DENSE { "line dense" } else { "line" }, tooltip);
        drawing.close();
    }

    /// Draws the cells. Adjacent cells of one kind in a row are one box, slightly enlarged to avoid visible seams.
    fn cells(&self, drawing: &mut Drawing, left: f64) {
        let height = (BOTTOM - TOP) / self.rows.len().max(1) as f64;
        let mut boxes = vec![Vec::new(); COLOURS];
        for (number, row) in self.rows.iter().enumerate() {
            let width = (RIGHT - left) / row.len().max(1) as f64;
            let mut from = 0;
            for run in row.chunk_by(|a, b| a == b) {
                let (x, y) = (left + from as f64 * width, BOTTOM - (number + 1) as f64 * height);
                boxes[run[0] % COLOURS].push([x, y, run.len() as f64 * width + 0.3, height + 0.3]);
                from += run.len();
            }
        }
        for (kind, boxes) in boxes.iter().enumerate() {
            drawing.boxes(boxes, &format!("area a{kind}"));
        }
    }

    fn legend(&self, drawing: &mut Drawing) {
        for (number, kind) in self.kinds.iter().enumerate() {
            drawing.rect((LEFT, drawing.height + 2.0), 22.0, 12.0, &format!("area a{}", number % COLOURS));
            drawing.text((LEFT + 30.0, drawing.height + 13.0), Anchor::Start, "", kind);
            drawing.height += LINE;
        }
        for (number, curve) in self.curves.iter().enumerate() {
            let middle = drawing.height + 8.0;
            self.stroke(drawing, number, &polyline(&[(LEFT, middle), (LEFT + 22.0, middle)]), curve.points.len(), "");
            drawing.text((LEFT + 30.0, drawing.height + 13.0), Anchor::Start, "", &curve.name);
            drawing.height += LINE;
        }
        for (number, dots) in self.dots.iter().enumerate() {
            let middle = drawing.height + 8.0;
            (0..4).for_each(|k| dot(drawing, number, (LEFT + 2.0 + 6.0 * f64::from(k), middle)));
            drawing.text((LEFT + 30.0, drawing.height + 13.0), Anchor::Start, "", &dots.name);
            drawing.height += LINE;
        }
        drawing.height += 4.0;
    }
}

/// Draws a dot at a position in pixels: filled for an even index of its set, hollow for an odd one.
fn dot(drawing: &mut Drawing, number: usize, at: (f64, f64)) {
    drawing.circle(at, 1.4, if number.is_multiple_of(2) { "spot" } else { "spot hollow" });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_are_no_values_have_names_and_no_numbers() {
        let rows = vec![vec![0], vec![0], vec![0]];
        let names = ["first", "second", "third"].map(String::from).into();
        let areas =
            Areas { x: ("x".into(), [0.0, 1.0]), y: ("methods".into(), [0.0, 3.0]), rows, names, ..Areas::default() };
        let svg = areas.svg();
        assert!(["first", "second", "third"].iter().all(|name| svg.contains(&format!(">{name}<"))), "{svg}");
        assert!(!svg.contains(">2<") && !svg.contains(">3<"), "{svg}");
    }

    #[test]
    fn a_sheet_has_every_picture_once_and_its_dots() {
        let dots = vec![AreaCurve { name: "between".into(), points: vec![(0.5, 0.5)] }];
        let one = |title: &str| Areas {
            title: title.into(),
            x: ("x".into(), [0.0, 1.0]),
            y: ("y".into(), [0.0, 1.0]),
            dots: dots.clone(),
            ..Areas::default()
        };
        let svg = Areas::sheet(&[one("first"), one("second")], "both", "a note");
        assert!(
            ["first", "second", "both", "a note"].iter().all(|text| svg.matches(&format!(">{text}<")).count() == 1),
            "{svg}"
        );
        // one in each plane and four in the legend
        assert_eq!(svg.matches("class=\"spot\"").count(), 6, "{svg}");
    }

    #[test]
    fn neighbours_of_one_kind_are_one_rectangle_and_curves_end_at_the_frame() {
        let areas = Areas {
            x: ("x".into(), [0.0, 1.0]),
            y: ("y".into(), [0.0, 1.0]),
            kinds: vec!["a & b".into()],
            rows: vec![vec![0, 0, 0], vec![0, 1, 1]],
            curves: vec![AreaCurve { name: "c".into(), points: vec![(0.0, 0.5), (0.5, 0.6), (1.0, 7.0)] }],
            ..Default::default()
        };
        let svg = areas.svg();
        // two runs of the first kind and one of the second, and the swatch of the legend
        let boxes =
            |kind: &str| svg.split(&format!("<path class=\"area {kind}\" d=\"")).nth(1).map(|d| d.split('"').next());
        let count = |kind: &str| boxes(kind).flatten().map_or(0, |d| d.matches('z').count());
        assert_eq!((count("a0"), count("a1"), svg.matches("<rect class=\"area").count()), (2, 1, 1), "{svg}");
        assert!(svg.contains("a &amp; b") && !svg.contains("-1"), "{svg}");
    }
}
