//! Sketches of systems: the geometry of a model as drawn parts, in a view that shows the mechanism well.

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

/// The sketch of a system at one or several instants, in the given view or in the default view of the system.
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

/// The instants of a sketch with the points of all figures; parts add further points and directions.
fn instants(figures: &[Figure]) -> Vec<Instant> {
    let one = |figure: &Figure| Instant {
        time: figure.time,
        places: figure.places.iter().map(|place| (*place).into()).collect(),
        directions: Vec::new(),
    };
    figures.iter().map(one).collect()
}
