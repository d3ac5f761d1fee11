//! The sketch of a system: still at its start, and moving as its run does.

use crate::draw::still;
use crate::sketch::{Interval, Motion, followed, most_pictures, pictures, sketch};
use crate::{clock, watch::told::Told};
use ::scenes::geometry::Geometry;
use ::scenes::{ModelScene, SystemText};
use charts::page::live::Part;
use simulation::Trajectory;
use std::io;
use std::path::Path;

/// Pictures of the sketch: the page is told it anew for each place of a slider.
const MOST_PICTURES: usize = 250;
/// With fewer pictures a run of its own shows more of the motion.
const FEW: usize = 40;

/// Tells the sketch at the start; one without content where nothing has a place, so that none of an earlier system stays.
pub(super) fn tell_still(path: &Path, text: &str) -> io::Result<()> {
    let system = SystemText { name: path.display().to_string(), text: text.to_owned(), values: Vec::new() };
    // a fault of the text is told with its equations or with its run
    let drawn = still(path, &system, None).map_or_else(|_| String::new(), |sketch| sketch.embedded());
    Told::part(Part::Sketch, drawn).write()
}

/// The sketch as SVG along a run; none where nothing moves.
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
