//! Quantities over time, in panels with a common time axis.

mod track;

use super::{
    axis::{Axis, Tick},
    drawing::{Anchor, Drawing, WIDTH, left_out, shorten},
    legend::{self, Entry},
    marker::Look,
    number::significant,
};
use track::{Stop, finite};

/// Panels, one below the other, over a common time axis.
#[derive(Clone, Debug, Default)]
pub struct Trajectory {
    pub title: String,
    /// The label of the horizontal axis, plain text with its unit: `time, s`.
    pub x: String,
    pub panels: Vec<Panel>,
    /// The text below the chart.
    pub note: String,
}

/// The panel of one quantity.
#[derive(Clone, Debug, Default)]
pub struct Panel {
    /// The label of the vertical axis, plain text with its unit: `ω₁, rad/s`.
    pub y: String,
    pub series: Vec<Track>,
}

/// The values of one quantity along one run. Tracks with equal names look alike in all panels; a value that is not finite interrupts the line.
#[derive(Clone, Debug, Default)]
pub struct Track {
    pub name: String,
    /// Points (time, value), in the units of the axes.
    pub points: Vec<(f64, f64)>,
    /// The reason for which the run stopped early, if it did; a cross marks its last point.
    pub stopped: Option<String>,
}

const LEFT: f64 = 66.0;
const RIGHT: f64 = WIDTH - 12.0;
const HEADING: f64 = 22.0;
/// The width reserved for a digit, in pixels.
const DIGIT: f64 = 9.5;

/// The height of a panel where there are many, in pixels.
const ROOM: f64 = 92.0;

impl Trajectory {
    /// The chart as an SVG file.
    pub fn svg(&self) -> String {
        self.drawing().standalone(&self.title)
    }

    pub(crate) fn drawing(&self) -> Drawing {
        let names = self.names();
        let times = self.tracks().flat_map(|track| finite(track).map(|point| point.0));
        let mut x = Axis::linear(times, LEFT, RIGHT, 62.0, 0.0);
        let below = headed(&self.x, x.share_power());
        let room = match self.panels.len() {
            0..=2 => 150.0,
            3 => 116.0,
            _ => ROOM,
        };
        let mut drawing = Drawing::default();
        let stops = self.stops();
        let shared = self.shared();
        for panel in &self.panels {
            let (top, bottom) = (drawing.height + HEADING, drawing.height + HEADING + room);
            let own = panel.names();
            let legend = if shared { &names } else { &own };
            let look = |track: &Track| Look::of(legend.iter().position(|name| *name == track.name).unwrap_or(0));
            let (y, heading) = panel.axis(bottom, top);
            self.head(&mut drawing, &heading, top - 7.0, if shared { &[] } else { &own }, &stops);
            frame(&mut drawing, &x, &y, top, bottom);
            for track in &panel.series {
                track::draw(&mut drawing, track, look(track), &x, &y);
            }
            for track in &panel.series {
                track::number(&mut drawing, track, &stops, &x, &y);
            }
            drawing.height = bottom + 2.0;
        }
        self.foot(&mut drawing, (&x, &below), if shared { &names } else { &[] }, &stops);
        drawing
    }

    /// Whether one legend serves all panels, because all show the same runs or the names do not fit above a panel.
    fn shared(&self) -> bool {
        let names = self.names();
        let same = self.panels.iter().all(|panel| panel.names() == names);
        let fits = |panel: &Panel| {
            legend::in_a_row(
                &mut Drawing::default(),
                &entries(&panel.names()),
                (beyond(&panel.axis(ROOM, 0.0).1), 0.0),
                RIGHT,
            )
        };
        (same && (self.panels.len() > 1 || names.len() < 2)) || !self.panels.iter().all(fits)
    }

    /// Draws the line above a panel: its heading, its legend, and, if only one run stopped, the reason.
    fn head(&self, drawing: &mut Drawing, heading: &str, y: f64, legend: &[&str], stops: &[Stop]) {
        drawing.text((LEFT, y), Anchor::Start, "heading", heading);
        legend::in_a_row(drawing, &entries(legend), (beyond(heading), y), RIGHT);
        if let ([stop], true) = (stops, drawing.height == 0.0) {
            let taken = heading.chars().count() + legend.iter().map(|name| name.chars().count() + 7).sum::<usize>();
            let room = ((RIGHT - LEFT) / 7.0) as usize;
            let reason = shorten(&format!("✕ {}", stop.reason), room.saturating_sub(taken + 4));
            drawing.text((RIGHT, y), Anchor::End, "small", &reason);
        }
    }

    /// Draws the part below the last panel: times, legend, reasons of runs that stopped, notes on omitted points.
    fn foot(&self, drawing: &mut Drawing, (x, below): (&Axis, &str), names: &[&str], stops: &[Stop]) {
        for Tick { at, label } in &x.ticks {
            let label = label.as_deref().unwrap_or("");
            // the last label must end inside the picture
            let middle = x.place_tick(*at).min(WIDTH - 2.0 - 0.5 * DIGIT * label.chars().count() as f64);
            drawing.text((middle, drawing.height + 17.0), Anchor::Middle, "", label);
        }
        drawing.text((0.5 * (LEFT + RIGHT), drawing.height + 38.0), Anchor::Middle, "", below);
        drawing.height += 50.0;
        if names.len() > 1 {
            legend::draw(drawing, &entries(names), false);
        }
        for (position, stop) in stops.iter().enumerate() {
            let Stop { name, reason, time } = stop;
            let sign = track::sign(stops, position);
            drawing.paragraph(&format!("{sign} {name} stopped at {}: {reason}", significant(*time, 4)), "small");
        }
        let missing = self.tracks().map(|track| track.points.len() - finite(track).count()).sum();
        drawing.paragraph(&left_out(missing, "not a finite number"), "small");
    }

    fn tracks(&self) -> impl Iterator<Item = &Track> {
        self.panels.iter().flat_map(|panel| &panel.series)
    }

    /// The runs that stopped, each listed once although it has a track in every panel.
    fn stops(&self) -> Vec<Stop<'_>> {
        let mut stops: Vec<Stop> = Vec::new();
        for track in self.tracks() {
            if let Some(stop) = Stop::of(track)
                && !stops.iter().any(|known| known.is(&stop))
            {
                stops.push(stop);
            }
        }
        stops
    }

    /// The names of all tracks, each once, in the order of their first occurrence.
    fn names(&self) -> Vec<&str> {
        once(self.tracks())
    }
}

impl Panel {
    fn names(&self) -> Vec<&str> {
        once(self.series.iter())
    }

    /// The vertical axis between two pixels, and the heading of the panel.
    fn axis(&self, from: f64, to: f64) -> (Axis, String) {
        let values = self.series.iter().flat_map(|track| finite(track).map(|point| point.1));
        let mut axis = Axis::linear(values, from, to, 26.0, 0.06);
        let power = axis.share_power();
        (axis, headed(&self.y, power))
    }
}

fn once<'a>(tracks: impl Iterator<Item = &'a Track>) -> Vec<&'a str> {
    let mut names: Vec<&str> = Vec::new();
    for track in tracks {
        if !names.contains(&track.name.as_str()) {
            names.push(&track.name);
        }
    }
    names
}

fn entries<'a>(names: &[&'a str]) -> Vec<Entry<'a>> {
    names.iter().enumerate().map(|(at, name)| Entry { look: Look::of(at), name }).collect()
}

/// The heading with the power of ten by which the labels of the ticks are multiplied.
fn headed(heading: &str, power: Option<String>) -> String {
    power.map_or_else(|| heading.to_owned(), |power| format!("{heading} ×{power}"))
}

/// The right end of a panel's heading in pixels.
fn beyond(heading: &str) -> f64 {
    LEFT + 8.0 * heading.chars().count() as f64 + 12.0
}

fn frame(drawing: &mut Drawing, x: &Axis, y: &Axis, top: f64, bottom: f64) {
    drawing.open("frame");
    let places = |axis: &Axis| axis.ticks.iter().map(|tick| axis.place_tick(tick.at)).collect::<Vec<_>>();
    drawing.grid(places(x).into_iter(), places(y).into_iter(), [LEFT, RIGHT, top, bottom], "grid");
    for Tick { at, label } in &y.ticks {
        let y = y.place_tick(*at);
        drawing.text((LEFT - 8.0, y + 5.0), Anchor::End, "", label.as_deref().unwrap_or(""));
    }
    drawing.rect((LEFT, top), RIGHT - LEFT, bottom - top, "box");
    drawing.close();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(points: Vec<(f64, f64)>, stopped: Option<String>) -> Trajectory {
        let track = Track { name: "run".into(), points, stopped };
        Trajectory { panels: vec![Panel { y: "ω".into(), series: vec![track] }], ..Default::default() }
    }

    #[test]
    fn a_run_that_stopped_says_why() {
        let svg = one(vec![(0.0, 1.0), (1.0, 2.0)], Some("det A vanishes".into())).svg();
        assert!(svg.contains("class=\"stop\"") && svg.contains(">✕ det A vanishes</text>"));
        assert!(svg.contains("✕ run stopped at 1: det A vanishes"));
    }

    #[test]
    fn a_number_that_is_not_finite_breaks_the_line_and_is_said() {
        let svg = one(vec![(0.0, 1.0), (1.0, f64::NAN), (2.0, 1.0), (3.0, 2.0)], None).svg();
        assert_eq!(svg.matches("class=\"line\"").count(), 2);
        assert!(svg.contains("1 point left out: not a finite number."));
    }

    #[test]
    fn no_data_and_a_single_point_are_charts() {
        for chart in [Trajectory::default(), one(vec![], Some("x".into())), one(vec![(1.0, 1.0)], None)] {
            assert!(chart.svg().ends_with("</svg>"));
        }
    }

    #[test]
    fn panels_with_names_of_their_own_have_their_legends_above_them() {
        let track = |name: &str| Track { name: name.into(), points: vec![(0.0, 0.0), (1.0, 1.0)], stopped: None };
        let panel = |names: [&str; 2]| Panel { y: "y".into(), series: names.map(track).into() };
        let chart = |second| Trajectory { panels: vec![panel(["a", "b"]), panel(second)], ..Default::default() };
        let (own, shared) = (chart(["c", "d"]).svg(), chart(["a", "b"]).svg());
        assert!(own.contains(">c</text>") && !own.contains("class=\"s2\""), "{own}");
        assert_eq!((own.matches(">a</text>").count(), shared.matches(">a</text>").count()), (1, 1));
    }

    #[test]
    fn the_label_of_the_last_tick_ends_on_the_paper() {
        let svg = one(vec![(0.0, 0.0), (0.00025, 1.0)], None).svg();
        let labels = svg.split("text-anchor=\"middle\">0.00025</text>").next().expect("it splits");
        let x = labels.rsplit("<text x=\"").next().and_then(|rest| rest.split('"').next()).expect("it has a place");
        assert!(svg.contains(">0.00025</text>") && x.parse::<f64>().expect("a number") <= 485.0, "{x}");
    }

    #[test]
    fn a_million_points_become_a_few_kilobytes() {
        let wave = |i| (f64::from(i), (f64::from(i) * 0.37).sin());
        assert!(one((0..1_000_000).map(wave).collect(), None).svg().len() < 30_000);
    }
}
