//! Bifurcation diagrams: branches of steady motions over a parameter, drawn by their stability, with marks at bifurcations.

use super::axis::{Axis, Tick};
use super::drawing::{Anchor, Drawing, LINE, WIDTH};
use super::marker::Look;
use super::path::polyline;

/// The stability of a piece of a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    Stable,
    Unstable,
    Undecided,
}

/// A piece of a branch along which the stability does not change, as points (parameter, quantity).
#[derive(Clone, Debug, PartialEq)]
pub struct BranchPiece {
    pub standing: Standing,
    pub points: Vec<(f64, f64)>,
}

/// The chart of one quantity along all branches.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BranchPanel {
    /// The name of the quantity with its unit, the label of the vertical axis.
    pub y: String,
    /// The bounds of the vertical axis.
    pub range: [f64; 2],
    pub pieces: Vec<BranchPiece>,
    /// Bifurcation points: the index of the kind of bifurcation in [`Branches::kinds`], and the point.
    pub marks: Vec<(usize, (f64, f64))>,
}

/// A bifurcation diagram: charts of several quantities over one parameter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Branches {
    pub title: String,
    /// The name of the parameter with its unit, and the bounds of the horizontal axis.
    pub x: (String, [f64; 2]),
    pub panels: Vec<BranchPanel>,
    /// The names of the kinds of bifurcations.
    pub kinds: Vec<String>,
    /// The text below the charts.
    pub note: String,
}

const LEFT: f64 = 56.0;
/// The width in pixels of the label next to the axis with its gaps; [`DIGIT`] is the width of a digit.
const LABEL: f64 = 32.0;
const DIGIT: f64 = 8.5;
const RIGHT: f64 = WIDTH - 14.0;
const TOP: f64 = 10.0;
const BOTTOM: f64 = 290.0;

/// Half the width of a mark in pixels.
const MARK: f64 = 5.0;

impl Standing {
    const ALL: [Standing; 3] = [Standing::Stable, Standing::Unstable, Standing::Undecided];

    fn class(self) -> &'static str {
        match self {
            Standing::Stable => "branch stable",
            Standing::Unstable => "branch unstable",
            Standing::Undecided => "branch undecided",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Standing::Stable => "stable",
            Standing::Unstable => "unstable",
            Standing::Undecided => "stability not decided",
        }
    }
}

impl Branches {
    /// The picture as an SVG file.
    pub fn svg(&self) -> String {
        let mut sheet = Drawing::default();
        self.panels.iter().for_each(|panel| sheet.below(&[self.panel(panel)]));
        self.legend(&mut sheet);
        sheet.paragraph(&self.note, "small");
        sheet.standalone(&self.title)
    }

    fn panel(&self, panel: &BranchPanel) -> Drawing {
        let y = Axis::linear(panel.range.into_iter(), BOTTOM, TOP, 50.0, 0.04);
        let widest = y.ticks.iter().flat_map(|tick| &tick.label).map(|label| label.chars().count()).max().unwrap_or(0);
        let left = LEFT.max(LABEL + DIGIT * widest as f64);
        let x = Axis::linear(self.x.1.into_iter(), left, RIGHT, 70.0, 0.0);
        let mut drawing = Drawing::default();
        let level = y.ticks.iter().map(|tick| y.place(tick.at));
        drawing.grid(x.ticks.iter().map(|tick| x.place(tick.at)), level, [left, RIGHT, TOP, BOTTOM], "fine");
        for Tick { at, label } in &x.ticks {
            drawing.text((x.place(*at), BOTTOM + 18.0), Anchor::Middle, "", label.as_deref().unwrap_or(""));
        }
        for Tick { at, label } in &y.ticks {
            drawing.text((left - 8.0, y.place(*at) + 5.0), Anchor::End, "", label.as_deref().unwrap_or(""));
        }
        for piece in &panel.pieces {
            let points: Vec<_> = piece.points.iter().map(|(a, b)| (x.place(*a), y.place(*b))).collect();
            drawing.path(&polyline(&points), piece.standing.class());
        }
        for &(kind, (a, b)) in &panel.marks {
            self.mark(&mut drawing, kind, (x.place(a), y.place(b)));
        }
        drawing.rect((left, TOP), RIGHT - left, BOTTOM - TOP, "box");
        drawing.text((0.5 * (left + RIGHT), BOTTOM + 38.0), Anchor::Middle, "", &self.x.0);
        drawing.upward((16.0, 0.5 * (TOP + BOTTOM)), &panel.y);
        drawing.height = BOTTOM + 50.0;
        drawing
    }

    fn mark(&self, drawing: &mut Drawing, kind: usize, at: (f64, f64)) {
        let look = Look::of(0).of_kind(Some(kind), None);
        drawing.open("event");
        look.marker(drawing, at, MARK, self.kinds.get(kind).map_or("", String::as_str));
        drawing.close();
    }

    /// Draws the legend of those kinds of pieces and marks that occur.
    fn legend(&self, drawing: &mut Drawing) {
        let pieces = || self.panels.iter().flat_map(|panel| &panel.pieces);
        for standing in Standing::ALL.into_iter().filter(|own| pieces().any(|piece| piece.standing == *own)) {
            let middle = drawing.height + 8.0;
            drawing.path(&polyline(&[(LEFT, middle), (LEFT + 30.0, middle)]), standing.class());
            drawing.text((LEFT + 40.0, drawing.height + 13.0), Anchor::Start, "", standing.name());
            drawing.height += LINE;
        }
        let occurs = |kind: usize| self.panels.iter().any(|panel| panel.marks.iter().any(|(own, _)| *own == kind));
        for (kind, name) in self.kinds.iter().enumerate().filter(|(kind, _)| occurs(*kind)) {
            self.mark(drawing, kind, (LEFT + 15.0, drawing.height + 8.0));
            drawing.text((LEFT + 40.0, drawing.height + 13.0), Anchor::Start, "", name);
            drawing.height += LINE;
        }
        drawing.height += 4.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_legend_names_what_is_drawn_and_nothing_else() {
        let piece = |standing, points: [(f64, f64); 2]| BranchPiece { standing, points: points.into() };
        let panel = BranchPanel {
            y: "a, rad".into(),
            range: [-1.0, 1.0],
            pieces: vec![
                piece(Standing::Stable, [(0.0, 0.0), (0.5, 0.5)]),
                piece(Standing::Unstable, [(0.5, 0.5), (1.0, -1.0)]),
            ],
            marks: vec![(1, (0.5, 0.5))],
        };
        let svg = Branches {
            title: "t".into(),
            x: ("p, m".into(), [0.0, 1.0]),
            panels: vec![panel],
            kinds: vec!["fold".into(), "pitchfork".into()],
            note: String::new(),
        }
        .svg();
        for shown in [">stable<", ">unstable<", ">pitchfork<", ">p, m<", ">a, rad<", "branch stable", "branch unstable"]
        {
            assert!(svg.contains(shown), "{shown}: {svg}");
        }
        assert!(!svg.contains(">fold<") && !svg.contains("not decided"), "{svg}");
    }
}
