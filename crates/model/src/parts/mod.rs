//! A model: the parts of a system, every name resolved.

mod constraints;
mod contacts;
mod coordinates;
mod events;
mod laws;
mod loads;
mod regulator;

pub use constraints::{Constraint, Implied, Zero};
pub use contacts::{Contact, OneWay, Restitution, Sides};
pub use coordinates::{Coordinate, QuasiVelocity};
pub use events::{Assignment, Direction, Event, StartSpeed, StartValue};
pub(crate) use laws::Combination;
pub use laws::UnsolvedLaw;
pub use loads::{Along, Energies, Force, GeneralisedForce, Torque};
pub use regulator::Regulator;

use crate::arena::{Arena, Number, Scalar};
use crate::{Fault, ScalarId, Source, VectorId};
use std::borrow::Cow;
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
    /// The coherent unit.
    pub unit: String,
    /// Value and unit as the text has them.
    pub written: String,
    /// In SI units; none where it is left open.
    pub value: Option<f64>,
    /// The position of the name in the file, in bytes.
    pub at: Range<usize>,
}

/// The parts of a free frame's quaternion.
pub(crate) const QUATERNION: [&str; 4] = ["q0", "q1", "q2", "q3"];
/// The parts of its angular velocity along its own axes.
pub(crate) const TURNING: [&str; 3] = ["wx", "wy", "wz"];

/// A frame of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    pub name: String,
    /// The frame that it turns in; the ground turns in none.
    pub parent: Option<(FrameId, Turn)>,
}

/// A turn of a frame in its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turn {
    /// About an axis, x, y or z, which both frames share.
    About { axis: usize, angle: ScalarId },
    /// Any: a quaternion among the coordinates, the angular velocity in the frame's own axes among the speeds.
    Free { number: usize },
}

/// A point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub name: String,
    /// The point that it is found from, and the vector between; the origin is found from none.
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
    /// The position of the name in the file, in bytes.
    pub at: Range<usize>,
    /// The positions of the mass and the inertia in the file; where they are missing, of the name.
    pub mass_at: Range<usize>,
    pub inertia_at: Range<usize>,
}

/// Moments of inertia about the centre of mass.
#[derive(Clone, Debug, PartialEq)]
pub enum Inertia {
    /// About z, of a body that turns about no other axis.
    Axial(ScalarId),
    /// The moment of inertia of a rotor about its shaft, an axis of its frame. Its resistance across the shaft counts to the body that carries it.
    OfShaft { moment: ScalarId, axis: usize },
    /// xx, yy, zz, xy, xz, yz in the axes of a frame that is fixed in the body.
    Tensor { axes: FrameId, entries: [Option<ScalarId>; 6] },
}

/// A vector or a point that a definition names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Defined {
    Vector(VectorId),
    /// A point, or one displaced from it by a vector.
    Point {
        base: PointId,
        way: Option<VectorId>,
        moves: Moves,
    },
}

/// The variables on which the position of a point depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moves {
    /// Coordinates and the time alone: it has a velocity and an acceleration.
    ByCoordinates,
    /// Speeds: its acceleration would hold third rates.
    BySpeeds,
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
    /// The position of the name in the file, in bytes.
    pub at: Range<usize>,
}

/// A system as data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    pub parameters: Vec<Parameter>,
    pub coordinates: Vec<Coordinate>,
    /// Currents of drives, by their names, each with the place of its charge.
    pub currents: Vec<(String, usize)>,
    /// None where the file asks for none.
    pub quasi_velocities: Vec<QuasiVelocity>,
    /// The ground first.
    pub frames: Vec<Frame>,
    /// Frames that turn freely.
    pub free: Vec<FrameId>,
    /// The origin first.
    pub points: Vec<Point>,
    pub bodies: Vec<Body>,
    /// The acceleration of free fall.
    pub gravity: Option<VectorId>,
    pub energies: Energies,
    pub forces: Vec<Force>,
    pub torques: Vec<Torque>,
    pub generalised: Vec<GeneralisedForce>,
    pub constraints: Vec<Constraint>,
    /// Laws without accelerations, which are constraints: combinations of the laws of coordinates.
    pub(crate) laws: Vec<Combination>,
    /// Coordinates on whose speeds no inertia depends, and the constraints that determine such speeds.
    pub(crate) inertialess: Vec<usize>,
    pub(crate) determining: Vec<usize>,
    /// Coordinates without inertia whose laws change at conditions or with diodes: their speeds are algebraic unknowns of each mode.
    pub algebraic_speeds: Vec<usize>,
    /// The laws of the algebraic speeds.
    pub(crate) changing_laws: Vec<Combination>,
    /// The first of them whose law cannot be solved for its speed.
    pub unsolved_law: Option<(usize, UnsolvedLaw)>,
    /// Impulses of reactions that loads and events hold: coordinates whose rates are these reactions.
    pub impulses: Vec<usize>,
    pub contacts: Vec<Contact>,
    /// The system with one coordinate more for each guide that its coordinates satisfy: its reaction is the force along that one.
    pub released: Option<Box<Model>>,
    /// Equations of constraints that follow from the others along every motion from the start: they have no reaction of their own.
    pub implied: Vec<Implied>,
    /// Faults of quasi-velocities that are none where constraints of positions depend on each other: on the branch of the start alone.
    pub unsettled: Vec<Fault>,
    pub outputs: Vec<Output>,
    /// Vectors and points of definitions, by their names.
    pub definitions: Vec<(String, Defined)>,
    pub inputs: Vec<Input>,
    pub regulator: Option<Regulator>,
    /// Expressions at whose zeros something is chosen anew.
    pub switches: Vec<ScalarId>,
    /// The first position of each of them in the file.
    pub switch_places: Vec<Range<usize>>,
    /// The coherent unit of each of them.
    pub switch_units: Vec<String>,
    /// Expressions that must not be negative: of roots, logarithms, powers and inverse circular functions.
    pub domains: Vec<Domain>,
    pub events: Vec<Event>,
    pub start: Vec<StartValue>,
    /// Quasi-velocities at the start: speeds are completed so that they hold.
    pub start_speeds: Vec<StartSpeed>,
    /// The position of the key by which the start is an equilibrium near these values.
    pub equilibrium: Option<Range<usize>>,
    /// Parameters that are left out: zero for good, by their places.
    pub absent: Vec<usize>,
    /// Texts that are accepted, and perhaps mean something else.
    pub warnings: Vec<Fault>,
    pub(crate) arena: Arena,
    /// Expressions that come before all others, since inputs have them: they hold the time and the state alone.
    pub(crate) ahead: Vec<ScalarId>,
}

/// A function that has values, or values that a number holds, on one side of a value of an expression alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// The expression.
    pub margin: ScalarId,
    pub end: DomainEnd,
    /// The bytes of the file at which the function stands.
    pub at: Range<usize>,
}

/// The end of a domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DomainEnd {
    /// No value where the expression is negative.
    Negative,
    /// The exponential of the expression: beyond every number where that is large.
    Large,
}

impl Model {
    /// Resolves the names of a system and checks its dimensions.
    ///
    /// # Errors
    /// All that is wrong, each at its place.
    pub fn of(source: &Source) -> Result<Self, Vec<Fault>> {
        crate::elaboration::elaborate(source)
    }

    /// The model without the constraints that determine speeds without inertia, and the coordinates of these; none where it has none.
    pub fn with_inertia_alone(&self) -> Option<(Model, Vec<usize>)> {
        if self.determining.is_empty() {
            return None;
        }
        let mut without = self.clone();
        let kept = self.constraints.iter().enumerate().filter(|(place, _)| !self.determining.contains(place));
        without.constraints = kept.map(|(_, constraint)| constraint.clone()).collect();
        Some((without, self.inertialess.clone()))
    }

    /// The model with laws without inertia that change at conditions as constraints, which hold between the changes.
    pub fn with_changing_laws(&self) -> Cow<'_, Model> {
        crate::elaboration::with_changing_laws(self)
    }

    /// Gives every input without a value the value zero.
    pub fn close_inputs(&mut self) {
        self.close((0..self.inputs.len()).collect());
    }

    /// Gives the inputs that a regulator chooses the value zero, where they have none: the motion that it brings back to has this one.
    pub fn close_regulated_inputs(&mut self) {
        if let Some(regulator) = &self.regulator {
            self.close(regulator.inputs.clone());
        }
    }

    fn close(&mut self, mut places: Vec<usize>) {
        places.retain(|&place| self.inputs[place].value.is_none());
        for place in places {
            let zero = Scalar::Number(Number { value: 0.0, times: 1.0, per: 1.0 });
            let zero = self.arena.scalar(zero, Some(self.inputs[place].dimension));
            self.inputs[place].value = Some(zero);
        }
    }

    /// The name of the coordinate that alone decides a switch.
    pub fn coordinate_of_switch(&self, switch: usize) -> Option<&str> {
        match self.arena.scalar_at(*self.switches.get(switch)?)? {
            Scalar::Coordinate(place) => Some(&self.coordinates[*place].name),
            _ => None,
        }
    }

    /// The model with every equation of its constraints, those that follow from others too.
    #[must_use]
    pub fn whole(&self) -> Self {
        let mut whole = self.clone();
        whole.implied.clear();
        whole
    }

    /// Whether an equation of a constraint, by its constraint and its component, follows from others.
    pub fn is_implied(&self, of: [usize; 2]) -> bool {
        self.implied.iter().any(|implied| implied.of == of)
    }

    /// The number of coordinates, those of free frames among them: four each.
    pub fn positions(&self) -> usize {
        self.coordinates.len() + 4 * self.free.len()
    }

    /// The number of speeds, those of free frames among them: three each.
    pub fn speeds(&self) -> usize {
        self.coordinates.len() + 3 * self.free.len()
    }

    /// The first of the four coordinates of a free frame.
    pub fn free_position(&self, number: usize) -> usize {
        self.coordinates.len() + 4 * number
    }

    /// The first of the three speeds of a free frame.
    pub fn free_speed(&self, number: usize) -> usize {
        self.coordinates.len() + 3 * number
    }

    /// The names of coordinates and speeds with their units, in the order of a state.
    pub fn state_names(&self) -> Vec<(String, String)> {
        let own = |rate: &str, per: &str| -> Vec<(String, String)> {
            let unit = |place: usize, of: &str| match (of, per) {
                // a current
                ("C", "/s") => "A".to_owned(),
                (_, "/s") if self.impulses.contains(&place) => self.coordinates[place].unit_of_rate(),
                _ => format!("{of}{per}"),
            };
            let named = |(place, of): (usize, &Coordinate)| (format!("{}{rate}", of.name), unit(place, &of.unit));
            self.coordinates.iter().enumerate().map(named).collect()
        };
        let free = |parts: &[&str], unit: &str| -> Vec<(String, String)> {
            let frames = self.free.iter().map(|frame| &self.frames[frame.0].name);
            let named = |frame: &String| {
                parts.iter().map(|part| (format!("{frame}.{part}"), unit.to_owned())).collect::<Vec<_>>()
            };
            frames.flat_map(named).collect()
        };
        [own("", ""), free(&QUATERNION, "1"), own("'", "/s"), free(&TURNING, "rad/s")].concat()
    }

    /// The state at time zero: coordinates, then speeds; zero where nothing is said, free frames as their parents. A reaction that is not
    /// given is one unit, since a length such as |R| has no derivative at zero; it is found from there.
    pub fn start_state(&self) -> Vec<f64> {
        let positions = self.positions();
        let mut state = vec![0.0; positions + self.speeds()];
        for number in 0..self.free.len() {
            state[self.free_position(number)] = 1.0;
        }
        for &impulse in &self.impulses {
            state[positions + impulse] = 1.0;
        }
        for StartValue { coordinate, order, value, .. } in &self.start {
            state[order * positions + coordinate] = *value;
        }
        state
    }

    /// The rates of the coordinates at a state.
    pub fn position_rates<S: field::Scalar>(&self, state: &[S], rates: &mut [S]) {
        let (positions, speeds) = state.split_at(self.positions());
        let own = self.coordinates.len();
        rates[..own].copy_from_slice(&speeds[..own]);
        for number in 0..self.free.len() {
            let (from, by) = (self.free_position(number), self.free_speed(number));
            let quaternion = std::array::from_fn(|k| positions[from + k]);
            let turning = std::array::from_fn(|k| speeds[by + k]);
            rates[from..from + 4].copy_from_slice(&crate::trace::quaternion_rates(quaternion, turning));
        }
    }
}
