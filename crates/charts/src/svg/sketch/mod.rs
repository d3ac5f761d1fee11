//! A mechanism as a mechanician sketches it: bodies, joints, springs, supports, at one instant or along a run.
//!
//! Every part refers to points ("places") and directions by their numbers, and an [`Instant`] gives their coordinates. One instant gives a still
//! picture; several give an animated one, in a page and as an image, without a script: rigid parts are moved, parts that change
//! their shape have a path for each instant.

mod bars;
mod camera;
mod compass;
mod extent;
mod ink;
mod labels;
mod marks;
mod plates;
mod pose;
mod rotary;
mod shapes;
mod surfaces;
mod timeline;

pub use camera::View;

use super::drawing::Drawing;
use camera::Camera;
use compass::compass;
use labels::Labels;
use shapes::shapes;
use timeline::Timeline;

/// A mechanism with its parts and its places.
#[derive(Clone, Debug, Default)]
pub struct Sketch {
    pub title: String,
    pub parts: Vec<SketchPart>,
    /// Names at places, plain text; those of greater weight come first.
    pub names: Vec<(usize, String)>,
    /// At least one, in the order of their times.
    pub instants: Vec<Instant>,
    pub view: View,
    /// The names of the axes x, y and z of the ground.
    pub axes: [String; 3],
    /// The acceleration of free fall, whose direction is drawn; zero without gravity.
    pub gravity: [f64; 3],
    /// Whether the sketch has the lengths of the model, so that a scale is drawn.
    pub has_scale: bool,
    /// Text below the picture.
    pub note: String,
}

/// The places and directions of a mechanism at a time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Instant {
    /// In seconds.
    pub time: f64,
    /// In metres, along the axes of the ground.
    pub places: Vec<[f64; 3]>,
    /// Vectors along the axes of the ground; those that are lengths are in metres.
    pub directions: Vec<[f64; 3]>,
}

/// A part, at places and along directions by their numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum SketchPart {
    /// A rigid body through points that are fixed in it, with the number of its colour.
    Plate {
        corners: Vec<usize>,
        colour: usize,
    },
    /// A rigid rod without a mass.
    Rod([usize; 2]),
    /// A straight part of a belt.
    Strand([usize; 2]),
    /// A line along which one point moves relative to another.
    Telescope([usize; 2]),
    Spring([usize; 2]),
    Dashpot([usize; 2]),
    /// A force between two points that is neither that of a spring nor that of a dashpot.
    Actuator([usize; 2]),
    /// An attraction or a repulsion at a distance.
    Field([usize; 2]),
    /// A body that is a point with a mass.
    Particle {
        at: usize,
        colour: usize,
    },
    /// The centre of mass of a body.
    Centre(usize),
    /// A joint.
    Pin(usize),
    /// A point fixed in the ground at which something is held.
    Support(usize),
    /// A block that slides along a line.
    Block {
        at: usize,
        along: usize,
        colour: usize,
    },
    /// The line on which a block slides, through its position at the first instant.
    Guide {
        at: usize,
        along: usize,
    },
    /// A closed curve about a point: an ellipse given by its two half axes, which are lengths among the directions.
    Ring {
        at: usize,
        axes: [usize; 2],
        colour: usize,
        spoke: bool,
    },
    /// The axes of a frame that turns.
    Triad {
        at: usize,
        axes: [usize; 3],
        colour: usize,
    },
    /// A surface that is touched at a point, with its normal towards the body.
    Surface {
        at: usize,
        normal: usize,
        kind: SurfaceKind,
    },
    /// A spring about an axis: two directions across the axis in one frame, and the first of them in the other frame.
    TorsionSpring {
        at: usize,
        axes: [usize; 3],
    },
    /// A dashpot about an axis, with directions as those of a spring.
    RotaryDashpot {
        at: usize,
        axes: [usize; 3],
    },
    /// A torque, whose size is not drawn.
    Torque {
        at: usize,
        along: usize,
    },
    /// A force on a point; its magnitude is not drawn.
    Arrow {
        at: usize,
        along: usize,
    },
}

/// The kind of a surface that is touched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceKind {
    /// A plane of the ground.
    Ground,
    /// A plane of a body.
    Body,
    /// A curve: its tangent at the place alone.
    Curve,
}

impl Sketch {
    /// The sketch as an SVG file: still with one instant, moving with several.
    pub fn svg(&self) -> String {
        self.drawing().standalone_in(&self.title, STYLE)
    }

    /// The sketch inside a page, which has the [`STYLE`] of sketches.
    pub fn embedded(&self) -> String {
        self.drawing().embedded(&self.title)
    }

    fn drawing(&self) -> Drawing {
        let mut drawing = Drawing::default();
        if self.instants.is_empty() {
            return drawing;
        }
        let camera = Camera::of(self);
        let timeline = Timeline::of(&self.instants);
        let shapes = shapes(self, &camera);
        drawing.open("sketch");
        shapes.iter().for_each(|shape| shape.draw(&mut drawing, &timeline));
        let names = Labels::of(self, &camera);
        names.draw(&mut drawing, &timeline);
        drawing.height = camera.height;
        compass(&mut drawing, &camera, (&self.axes, self.gravity), self.has_scale);
        timeline.draw(&mut drawing);
        drawing.close();
        drawing.paragraph(&self.note, "small");
        drawing
    }
}

/// The style sheet of sketches, for light and dark screens.
pub const STYLE: &str = include_str!("sketch.css");

#[cfg(test)]
mod tests;
