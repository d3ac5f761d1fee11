//! Sketches of mechanisms: bodies, joints, springs and supports, at one instant or along a run.
//!
//! A part refers to points and directions by their indices, and an [`Instant`] gives the coordinates of these points and directions. One instant
//! gives a still picture. Several instants give an animated picture without a script: the animation moves rigid parts and replaces
//! the paths of parts that change their shape.

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

/// A mechanism: its parts, the names of its points, and its instants.
#[derive(Clone, Debug, Default)]
pub struct Sketch {
    pub title: String,
    pub parts: Vec<SketchPart>,
    /// Points by their indices with names, plain text; more important names come first.
    pub names: Vec<(usize, String)>,
    /// The instants, ordered by time; at least one.
    pub instants: Vec<Instant>,
    pub view: View,
    /// The names of the axes x, y and z of the ground.
    pub axes: [String; 3],
    /// The acceleration of free fall along the axes of the ground; only its direction is drawn. Zero without gravity.
    pub gravity: [f64; 3],
    /// Whether lengths in the sketch are those of the model, so that a scale bar is drawn.
    pub has_scale: bool,
    /// The text below the picture.
    pub note: String,
}

/// The points and directions of a mechanism at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Instant {
    /// The time in seconds.
    pub time: f64,
    /// Coordinates of the points, in metres along the axes of the ground.
    pub places: Vec<[f64; 3]>,
    /// Components of the directions along the axes of the ground; directions that are lengths are in metres.
    pub directions: Vec<[f64; 3]>,
}

/// A part of a mechanism. Numbers are indices of points (`at`, `corners`, pairs) and of directions (`along`, `axes`, `normal`).
#[derive(Clone, Debug, PartialEq)]
pub enum SketchPart {
    /// A rigid body through points fixed in it, with the index of its colour.
    Plate {
        corners: Vec<usize>,
        colour: usize,
    },
    /// A rigid rod without a mass.
    Rod([usize; 2]),
    /// A straight part of a belt.
    Strand([usize; 2]),
    /// A telescope: a line along which one point moves relative to another.
    Telescope([usize; 2]),
    Spring([usize; 2]),
    Dashpot([usize; 2]),
    /// A force between two points that comes neither from a spring nor from a dashpot.
    Actuator([usize; 2]),
    /// An attraction or a repulsion at a distance.
    Field([usize; 2]),
    /// A body that is a point mass.
    Particle {
        at: usize,
        colour: usize,
    },
    /// The centre of mass of a body.
    Centre(usize),
    /// A pin joint.
    Pin(usize),
    /// A point of the ground to which a part is attached.
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
    /// A closed curve about a point: the ellipse of two half-axes, which are directions with a length in metres.
    Ring {
        at: usize,
        axes: [usize; 2],
        colour: usize,
        spoke: bool,
    },
    /// The axes of a rotating frame.
    Triad {
        at: usize,
        axes: [usize; 3],
        colour: usize,
    },
    /// A surface in contact with a body at a point, with its normal towards the body.
    Surface {
        at: usize,
        normal: usize,
        kind: SurfaceKind,
    },
    /// A torsion spring: two directions of one frame across its axis, and the first of them as fixed in the other frame.
    TorsionSpring {
        at: usize,
        axes: [usize; 3],
    },
    /// A rotary dashpot, with directions like those of [`SketchPart::TorsionSpring`].
    RotaryDashpot {
        at: usize,
        axes: [usize; 3],
    },
    /// A torque along a direction; its magnitude is not drawn.
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

/// The kind of a surface in contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceKind {
    /// A plane fixed to the ground.
    Ground,
    /// A plane fixed to a body.
    Body,
    /// A curve, of which only the tangent at the contact is drawn.
    Curve,
}

impl Sketch {
    /// The sketch as an SVG file: still with one instant, animated with several.
    pub fn svg(&self) -> String {
        self.drawing().standalone_in(&self.title, STYLE)
    }

    /// The sketch as an SVG element for a page that contains [`STYLE`].
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
