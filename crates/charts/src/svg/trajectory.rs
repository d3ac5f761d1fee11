//! Quantities against time, in panels that share the time.

use super::{
    axis::{Axis, Tick},
    decimate::decimate,
    drawing::{Anchor, Drawing, WIDTH, left_out, shorten},
    legend::{self, Entry},
    marker::Look,
    number::significant,
    path,
};

/// Stacked panels over one axis of time.
#[derive(Clone, Debug, Default)]
pub struct Trajectory {
    pub title: String,
    /// The horizontal axis, plain text with its unit: `time, s`.
    pub x: String,
    pub panels: Vec<Panel>,
    /// Text below the chart.
    pub note: String,
}

/// One quantity.
#[derive(Clone, Debug, Default)]
pub struct Panel {
    /// Plain text with its unit: `ω₁, rad/s`.
    pub y: String,
    pub series: Vec<Track>,
}

/// One run of one quantity. Tracks of one name look alike in all panels; a number that is not finite breaks the line.
#[derive(Clone, Debug, Default)]
pub struct Track {
    pub name: String,
    pub points: Vec<(f64, f64)>,
    /// Why the run ended before its time, where it did: marked at its last point.
    pub stopped: Option<String>,
}

const LEFT: f64 = 66.0;
const RIGHT: f64 = WIDTH - 12.0;
const HEADING: f64 = 22.0;
const COLUMNS: usize = 400;

impl Trajectory {
    /// The chart as an SVG file.
    pub fn svg(&self) -> String {
        self.drawing().standalone(&self.title)
    }

    pub(crate) fn drawing(&self) -> Drawing {
        let names = self.names();
        let times = self.tracks().flat_map(|track| finite(track).map(|point| point.0));
        let x = Axis::linear(times, LEFT, RIGHT, 62.0, 0.0);
        let room = match self.panels.len() {
            0..=2 => 150.0,
            3 => 116.0,
            _ => 92.0,
        };
        let mut drawing = Drawing::default();
        let stops = self.stops();
        for panel in &self.panels {
            let (top, bottom) = (drawing.height + HEADING, drawing.height + HEADING + room);
            drawing.text((LEFT, top - 7.0), Anchor::Start, "heading", &panel.y);
            let values = panel.series.iter().flat_map(|track| finite(track).map(|point| point.1));
            let y = Axis::linear(values, bottom, top, 26.0, 0.06);
            frame(&mut drawing, &x, &y, top, bottom);
            for track in &panel.series {
                let look = Look::of(names.iter().position(|name| *name == track.name).unwrap_or(0));
                draw_track(&mut drawing, track, look, &x, &y);
            }
            for track in &panel.series {
                label_stop(&mut drawing, track, &stops, &x, &y);
            }
            drawing.height = bottom + 2.0;
        }
        self.foot(&mut drawing, &x, &names, &stops);
        drawing
    }

    /// What stands below the last panel: times, legend, who stopped and why, what was left out.
    fn foot(&self, drawing: &mut Drawing, x: &Axis, names: &[&str], stops: &[Stop]) {
        for Tick { at, label } in &x.ticks {
            drawing.text(
                (x.place_tick(*at), drawing.height + 17.0),
                Anchor::Middle,
                "",
                label.as_deref().unwrap_or(""),
            );
        }
        drawing.text((0.5 * (LEFT + RIGHT), drawing.height + 38.0), Anchor::Middle, "", &self.x);
        drawing.height += 50.0;
        if names.len() > 1 {
            let entries: Vec<_> =
                names.iter().enumerate().map(|(at, name)| Entry { look: Look::of(at), name }).collect();
            legend::draw(drawing, &entries, false);
        }
        for (position, stop) in stops.iter().enumerate() {
            let Stop { name, reason, time } = stop;
            let sign = sign(stops, position);
            drawing.paragraph(&format!("{sign} {name} stopped at {}: {reason}", significant(*time, 4)), "small");
        }
        let missing = self.tracks().map(|track| track.points.len() - finite(track).count()).sum();
        drawing.paragraph(&left_out(missing, "not a finite number"), "small");
    }

    fn tracks(&self) -> impl Iterator<Item = &Track> {
        self.panels.iter().flat_map(|panel| &panel.series)
    }

    /// Which runs stopped, each once for all its panels.
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

    /// The names of all tracks, each once.
    fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for track in self.tracks() {
            if !names.contains(&track.name.as_str()) {
                names.push(&track.name);
            }
        }
        names
    }
}

/// Where and why a run stopped.
struct Stop<'a> {
    name: &'a str,
    reason: &'a str,
    time: f64,
}

impl<'a> Stop<'a> {
    fn of(track: &'a Track) -> Option<Self> {
        let (reason, end) = (track.stopped.as_deref()?, finite(track).last()?);
        Some(Stop { name: &track.name, reason, time: end.0 })
    }

    fn is(&self, other: &Stop) -> bool {
        self.name == other.name && self.reason == other.reason
    }
}

/// The cross, with a number where several runs stopped.
fn sign(stops: &[Stop], position: usize) -> String {
    if stops.len() > 1 { format!("✕{}", position + 1) } else { "✕".to_owned() }
}

fn is_finite(point: &(f64, f64)) -> bool {
    point.0.is_finite() && point.1.is_finite()
}

fn finite(track: &Track) -> impl Iterator<Item = (f64, f64)> {
    track.points.iter().copied().filter(is_finite)
}

fn draw_track(drawing: &mut Drawing, track: &Track, look: Look, x: &Axis, y: &Axis) {
    drawing.open(&look.class());
    for run in track.points.chunk_by(|a, b| is_finite(a) == is_finite(b)).filter(|run| is_finite(&run[0])) {
        let places: Vec<_> = decimate(run, COLUMNS).into_iter().map(|(t, v)| (x.place(t), y.place(v))).collect();
        drawing.path(&path::polyline(&places), "line");
    }
    if let (Some(reason), Some(end)) = (&track.stopped, finite(track).last()) {
        let d = format!("M{:.1} {:.1}m-5-5l10 10m-10 0l10-10", x.place(end.0), y.place(end.1));
        drawing.path_with_tooltip(&d, "stop", &format!("{} stopped: {reason}", track.name));
    }
    drawing.close();
}

/// Says beside the cross why the run stopped: in words where one run did, by its number where several did.
fn label_stop(drawing: &mut Drawing, track: &Track, stops: &[Stop], x: &Axis, y: &Axis) {
    let (Some(stop), Some(end)) = (Stop::of(track), finite(track).last()) else { return };
    let (at, height) = (x.place(end.0), y.place(end.1));
    let leftward = at > 0.5 * (LEFT + RIGHT);
    let room = if leftward { at - LEFT } else { RIGHT - at } - 16.0;
    let text = match stops.iter().position(|known| known.is(&stop)) {
        Some(position) if stops.len() > 1 => (position + 1).to_string(),
        _ => shorten(stop.reason, (room / 7.4) as usize),
    };
    let (anchor, start) = if leftward { (Anchor::End, at - 9.0) } else { (Anchor::Start, at + 9.0) };
    drawing.text((start, height + 5.0), anchor, "heading said", &text);
}

fn frame(drawing: &mut Drawing, x: &Axis, y: &Axis, top: f64, bottom: f64) {
    drawing.open("frame");
    for tick in &x.ticks {
        let x = x.place_tick(tick.at);
        drawing.line((x, top), (x, bottom), "grid");
    }
    for Tick { at, label } in &y.ticks {
        let y = y.place_tick(*at);
        drawing.line((LEFT, y), (RIGHT, y), "grid");
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
        assert!(svg.contains("class=\"stop\"") && svg.contains(">det A vanishes</text>"));
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
    fn a_million_points_become_a_few_kilobytes() {
        let wave = |i| (f64::from(i), (f64::from(i) * 0.37).sin());
        assert!(one((0..1_000_000).map(wave).collect(), None).svg().len() < 30_000);
    }
}
