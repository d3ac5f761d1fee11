//! A sketch of a system: its geometry as drawn parts, seen from a direction that shows the mechanism well.

mod bodies;
mod gears;
mod joints;
mod motion;
mod names;
mod parts;
mod pictures;
mod view;

pub use motion::{Interval, Motion, followed, most_pictures, pictures};

use ::scenes::geometry::{Figure, Geometry};
use charts::{Instant, Sketch};
use parts::Parts;

/// The sketch of a system at one time or several, seen from a given direction or from the usual one for its kind.
pub fn sketch(title: &str, geometry: &Geometry, figures: &[Figure], towards: Option<[f64; 3]>) -> Sketch {
    let mut parts = Parts::of(geometry, figures);
    let bodies = bodies::draw(&mut parts);
    joints::draw(&mut parts);
    names::name(&mut parts);
    let view = view::view(geometry, figures, towards);
    let Parts { parts, names, instants, .. } = parts;
    let axes = ["x", "y", "z"].map(str::to_owned);
    Sketch {
        title: title.to_owned(),
        parts,
        names,
        instants,
        view,
        axes,
        gravity: figures.first().map_or([0.0; 3], |figure| figure.gravity.into()),
        has_scale: bodies.is_to_scale,
        note: [&[bodies.note.to_owned()], &geometry.told_gears[..]].concat().join(" ").trim().to_owned(),
    }
}

/// The places and directions of all figures, to which parts add their own.
fn instants(figures: &[Figure]) -> Vec<Instant> {
    let one = |figure: &Figure| Instant {
        time: figure.time,
        places: figure.places.iter().map(|place| (*place).into()).collect(),
        directions: Vec::new(),
    };
    figures.iter().map(one).collect()
}
