//! The sketch of a system on the page: still at its start, and animated along its run.

use crate::draw::still;
use crate::sketch::{Interval, Motion, followed, most_pictures, pictures, sketch};
use crate::{clock, watch::told::Told};
use ::scenes::geometry::Geometry;
use ::scenes::{ModelScene, SystemText};
use charts::page::live::Part;
use simulation::Trajectory;
use std::io;
use std::path::Path;

/// The largest number of figures, since the page receives the sketch again for each position of a slider.
const MOST_PICTURES: usize = 250;
/// If the run has fewer usable figures than this, a separate run with closer instants is made.
const FEW: usize = 40;

/// Reports the sketch at the start. Where nothing can be drawn, an empty sketch replaces that of an earlier text.
pub(super) fn tell_still(path: &Path, text: &str) -> io::Result<()> {
    let system = SystemText { name: path.display().to_string(), text: text.to_owned(), values: Vec::new() };
    // faults of the text are reported with its equations or its run
    let drawn = still(path, &system, None).map_or_else(|_| String::new(), |sketch| sketch.embedded());
    Told::part(Part::Sketch, drawn).write()
}

/// The animated sketch along a run, as SVG; `None` where nothing moves.
pub(super) fn along(scene: &ModelScene, run: &Trajectory) -> Option<String> {
    let geometry = Geometry::of(&scene.model, &scene.start).ok().filter(Geometry::is_seen)?;
    let span = scene.run.span;
    let interval = Interval { from: 0.0, to: span };
    let still = sketch("", &geometry, &[geometry.figure(0.0, &scene.start)], None);
    let most = most_pictures(&still).min(MOST_PICTURES);
    let mut motion = pictures(scene, &geometry, (run.clone(), span), (interval, most));
    if geometry.has_switched_loads || (motion.part.is_some() && motion.figures.len() < FEW) {
        motion = followed(scene, &geometry, (interval, most), |_| clock::goes_on()).unwrap_or(motion);
    }
    let Motion { figures, part, .. } = motion;
    if figures.is_empty() {
        return None;
    }
    let mut drawn = sketch(&scene.title, &geometry, &figures, None);
    if let Some([from, to]) = part {
        let [from, to, span] = [from, to, span].map(|time| charts::significant(time, 4));
        drawn.note += &format!(" Shown is the part from {from} s to {to} s of a run of {span} s.");
    }
    Some(drawn.embedded())
}
