//! A run in a panel: its line, and the mark at an early stop.

use super::{
    super::{
        axis::Axis,
        decimate::decimate,
        drawing::{Anchor, Drawing},
        marker::Look,
        path,
    },
    LEFT, RIGHT, Track,
};

const COLUMNS: usize = 400;
/// The largest number of turning points with which a line has its usual width and dashes.
const DENSE: usize = 30;

/// The early stop of a run, with its reason and its time.
pub(super) struct Stop<'a> {
    pub name: &'a str,
    pub reason: &'a str,
    /// The time of the last finite point, in the unit of the time axis.
    pub time: f64,
}

impl<'a> Stop<'a> {
    pub fn of(track: &'a Track) -> Option<Self> {
        let (reason, end) = (track.stopped.as_deref()?, finite(track).last()?);
        Some(Stop { name: &track.name, reason, time: end.0 })
    }

    pub fn is(&self, other: &Stop) -> bool {
        self.name == other.name && self.reason == other.reason
    }
}

/// The cross of a stopped run, with a number where several runs stopped.
pub(super) fn sign(stops: &[Stop], position: usize) -> String {
    if stops.len() > 1 { format!("✕{}", position + 1) } else { "✕".to_owned() }
}

fn is_finite(point: &(f64, f64)) -> bool {
    point.0.is_finite() && point.1.is_finite()
}

pub(super) fn finite(track: &Track) -> impl Iterator<Item = (f64, f64)> {
    track.points.iter().copied().filter(is_finite)
}

pub(super) fn draw(drawing: &mut Drawing, track: &Track, look: Look, x: &Axis, y: &Axis) {
    drawing.open(&look.class());
    for run in track.points.chunk_by(|a, b| is_finite(a) == is_finite(b)).filter(|run| is_finite(&run[0])) {
        let places: Vec<_> = decimate(run, COLUMNS).into_iter().map(|(t, v)| (x.place(t), y.place(v))).collect();
        drawing.path(&path::polyline(&places), if turns(&places) > DENSE { "line dense" } else { "line" });
    }
    if let (Some(reason), Some(end)) = (&track.stopped, finite(track).last()) {
        let d = format!("M{:.1} {:.1}m-5-5l10 10m-10 0l10-10", x.place(end.0), y.place(end.1));
        drawing.path_with_tooltip(&d, "stop", &format!("{} stopped: {reason}", track.name));
    }
    drawing.close();
}

/// The number of turning points of a line.
fn turns(places: &[(f64, f64)]) -> usize {
    let slopes: Vec<f64> = places.windows(2).map(|pair| pair[1].1 - pair[0].1).filter(|slope| *slope != 0.0).collect();
    slopes.windows(2).filter(|pair| pair[0].signum() != pair[1].signum()).count()
}

/// Draws the number next to the cross where several runs stopped. A single stop needs none, since its reason stands above the first panel.
pub(super) fn number(drawing: &mut Drawing, track: &Track, stops: &[Stop], x: &Axis, y: &Axis) {
    let (Some(stop), Some(end), [_, _, ..]) = (Stop::of(track), finite(track).last(), stops) else { return };
    let number = stops.iter().position(|known| known.is(&stop)).map_or(0, |position| position + 1);
    let at = x.place(end.0);
    let (anchor, start) = if at > 0.5 * (LEFT + RIGHT) { (Anchor::End, at - 9.0) } else { (Anchor::Start, at + 9.0) };
    drawing.text((start, y.place(end.1) + 5.0), anchor, "heading said", &number.to_string());
}
