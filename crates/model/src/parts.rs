//! A model: the parts of a system, every name resolved.

use crate::arena::Arena;
use crate::{Fault, ScalarId, Source, VectorId};
use std::ops::Range;
use symbolic::Dimension;

/// A frame; the first is the ground N.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FrameId(pub usize);

/// A point; the first is the origin O, fixed in the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PointId(pub usize);

/// A body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyId(pub usize);

impl FrameId {
    pub const GROUND: FrameId = FrameId(0);
}

impl PointId {
    pub const ORIGIN: PointId = PointId(0);
}

/// A constant of the system.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    pub name: String,
    pub dimension: Dimension,
    /// The unit as written.
    pub unit: String,
    /// In SI units; none where it is left open.
    pub value: Option<f64>,
    /// Where its name stands.
    pub at: Range<usize>,
}

/// A coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    pub name: String,
    pub dimension: Dimension,
    pub unit: String,
    /// Where its name stands.
    pub at: Range<usize>,
}

/// A frame of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    pub name: String,
    /// The frame that it turns in; the ground turns in none.
    pub parent: Option<(FrameId, Turn)>,
}

/// A turn about an axis of the parent, which both frames share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// x, y or z.
    pub axis: usize,
    pub angle: ScalarId,
}

/// A point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub name: String,
    /// The point that it is found from, and the way; the origin is found from none.
    pub base: Option<(PointId, VectorId)>,
}

/// A point, of a body or of none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Material {
    pub body: Option<BodyId>,
    pub point: PointId,
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    pub name: String,
    /// The frame that it turns with; a particle has none.
    pub frame: Option<FrameId>,
    pub centre: Option<PointId>,
    pub mass: Option<ScalarId>,
    pub inertia: Option<Inertia>,
    /// Where its name stands.
    pub at: Range<usize>,
}

/// Moments of inertia about the centre of mass.
#[derive(Clone, Debug, PartialEq)]
pub enum Inertia {
    /// About z, of a body that turns about no other axis.
    Axial(ScalarId),
    /// xx, yy, zz, xy, xz, yz in the axes of a frame that is fixed in the body.
    Tensor { axes: FrameId, entries: [Option<ScalarId>; 6] },
}

/// A force.
#[derive(Clone, Debug, PartialEq)]
pub enum Force {
    On {
        at: Material,
        is: VectorId,
    },
    /// Equal and opposite along the line of two points, positive apart.
    Between {
        points: [Material; 2],
        is: ScalarId,
    },
}

/// A torque.
#[derive(Clone, Debug, PartialEq)]
pub enum Torque {
    On {
        frame: FrameId,
        is: VectorId,
    },
    /// On the second, its opposite on the first.
    Between {
        frames: [FrameId; 2],
        is: VectorId,
    },
}

/// Energies beside those of the bodies.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Energies {
    pub kinetic: Option<ScalarId>,
    pub potential: Option<ScalarId>,
    /// Rayleigh's function: forces are minus its derivatives by the speeds.
    pub dissipation: Option<ScalarId>,
}

/// An expression f that is zero along every motion, or is led to zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    pub name: Option<String>,
    pub zero: Zero,
    /// Of one that is led to zero: f'' + g1 f' + g2 f = 0 of positions, f' + g1 f = 0 of speeds.
    pub gains: Option<Vec<ScalarId>>,
    pub at: Range<usize>,
}

/// The expression of a constraint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Zero {
    Scalar(ScalarId),
    /// Every component that does not vanish by itself.
    Vector(VectorId),
}

/// A scalar that a run shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    pub name: String,
    pub is: ScalarId,
    pub dimension: Dimension,
}

/// A quantity that acts from outside: a force, a voltage, a prescribed angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    pub name: String,
    pub dimension: Dimension,
    pub unit: String,
    /// An expression of time and state; none where it is left open.
    pub value: Option<ScalarId>,
    /// Where its name stands.
    pub at: Range<usize>,
}

/// The direction in which an expression passes zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    Up,
    Down,
    Both,
}

/// An instant at which an expression passes zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// Empty where it has none.
    pub name: String,
    pub when: ScalarId,
    pub direction: Direction,
    /// The state after it.
    pub set: Vec<Assignment>,
    /// Whether the motion ends.
    pub ends: bool,
    pub at: Range<usize>,
}

/// A coordinate, or its speed, after an event: an expression of the state before it.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    pub coordinate: usize,
    /// Zero for the coordinate, one for its speed.
    pub order: usize,
    pub is: ScalarId,
}

/// A coordinate, or its speed, at time zero.
#[derive(Clone, Debug, PartialEq)]
pub struct StartValue {
    pub coordinate: usize,
    /// Zero for the coordinate, one for its speed.
    pub order: usize,
    /// In SI units.
    pub value: f64,
    /// Whether it may be moved to meet the constraints.
    pub is_guess: bool,
}

/// A system as data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    pub parameters: Vec<Parameter>,
    pub coordinates: Vec<Coordinate>,
    /// The ground first.
    pub frames: Vec<Frame>,
    /// The origin first.
    pub points: Vec<Point>,
    pub bodies: Vec<Body>,
    /// The acceleration of free fall.
    pub gravity: Option<VectorId>,
    pub energies: Energies,
    pub forces: Vec<Force>,
    pub torques: Vec<Torque>,
    pub constraints: Vec<Constraint>,
    pub outputs: Vec<Output>,
    pub inputs: Vec<Input>,
    /// Expressions at whose zeros something is chosen anew.
    pub switches: Vec<ScalarId>,
    /// Where each of them stands first.
    pub switch_places: Vec<Range<usize>>,
    pub events: Vec<Event>,
    pub start: Vec<StartValue>,
    pub(crate) arena: Arena,
}

impl Model {
    /// Resolves the names of a system and checks its dimensions.
    ///
    /// # Errors
    /// All that is wrong, each at its place.
    pub fn of(source: &Source) -> Result<Self, Vec<Fault>> {
        crate::elaboration::elaborate(source)
    }

    /// The state at time zero: coordinates, then speeds; zero where nothing is said.
    pub fn start_state(&self) -> Vec<f64> {
        let n = self.coordinates.len();
        let mut state = vec![0.0; 2 * n];
        for StartValue { coordinate, order, value, .. } in &self.start {
            state[order * n + coordinate] = *value;
        }
        state
    }
}
