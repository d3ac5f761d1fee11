//! A model: the parts of a system after resolution of all names.

mod comparisons;
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

/// The index of a frame; the first frame is the ground N.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FrameId(pub usize);

/// The index of a point; the first point is the origin O of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PointId(pub usize);

/// The index of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyId(pub usize);

impl FrameId {
    /// The frame N of the ground.
    pub const GROUND: FrameId = FrameId(0);
}

impl PointId {
    /// The origin O of the ground.
    pub const ORIGIN: PointId = PointId(0);
}

/// A constant of the system.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    pub name: String,
    pub dimension: Dimension,
    /// The coherent SI unit.
    pub unit: String,
    /// Value and unit in the notation of the file.
    pub written: String,
    /// The value in SI units; `None` for a parameter without a value.
    pub value: Option<f64>,
    /// The range of bytes of the name in the file.
    pub at: Range<usize>,
}

/// The components of a free frame's quaternion.
pub(crate) const QUATERNION: [&str; 4] = ["q0", "q1", "q2", "q3"];
/// The components of a free frame's angular velocity along its own axes.
pub(crate) const TURNING: [&str; 3] = ["wx", "wy", "wz"];

/// A frame of three orthonormal axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    pub name: String,
    /// The parent frame, and the rotation relative to it; `None` for the ground.
    pub parent: Option<(FrameId, Turn)>,
}

/// The rotation of a frame relative to its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turn {
    /// A rotation by an angle in radians about the axis 0, 1 or 2 (x, y, z), which both frames share.
    About { axis: usize, angle: ScalarId },
    /// A free rotation: the coordinates are a quaternion, the speeds the angular velocity along the frame's own axes.
    Free { number: usize },
}

/// A point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub name: String,
    /// The point from which it is defined, and the displacement; `None` for the origin.
    pub base: Option<(PointId, VectorId)>,
}

/// A point that moves with a body, or by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Material {
    /// The body that carries the point; `None` if the point moves by itself.
    pub body: Option<BodyId>,
    pub point: PointId,
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    pub name: String,
    /// The frame in which the body is fixed; `None` for a particle.
    pub frame: Option<FrameId>,
    /// The centre of mass; `None` for a body that only rotates.
    pub centre: Option<PointId>,
    /// The mass in kg; `None` for a massless body.
    pub mass: Option<ScalarId>,
    /// The inertia about the centre of mass; `None` for a particle.
    pub inertia: Option<Inertia>,
    /// The range of bytes of the name in the file.
    pub at: Range<usize>,
    /// The ranges of bytes of mass and inertia in the file; of the name if they are absent.
    pub mass_at: Range<usize>,
    pub inertia_at: Range<usize>,
}

/// The inertia tensor about the centre of mass, in kg m^2.
#[derive(Clone, Debug, PartialEq)]
pub enum Inertia {
    /// The moment of inertia about z, for a body that rotates about no other axis.
    Axial(ScalarId),
    /// The moment of inertia of a rotor about its shaft, an axis of its frame. Its inertia about perpendicular axes belongs to the carrying body.
    OfShaft { moment: ScalarId, axis: usize },
    /// The entries xx, yy, zz, xy, xz, yz of the tensor in the axes of a frame that is fixed in the body.
    Tensor { axes: FrameId, entries: [Option<ScalarId>; 6] },
}

/// A vector or a point that is named by a definition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Defined {
    Vector(VectorId),
    /// A point, or the point displaced from `base` by the vector `way`.
    Point {
        base: PointId,
        way: Option<VectorId>,
        moves: Moves,
    },
}

/// The variables on which the position of a point depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moves {
    /// Coordinates and time only, so that the point has a velocity and an acceleration.
    ByCoordinates,
    /// Also speeds: an acceleration would contain third derivatives of coordinates.
    BySpeeds,
}

/// A scalar output of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    pub name: String,
    /// The expression, with values in SI units.
    pub is: ScalarId,
    pub dimension: Dimension,
}

/// A quantity that acts from outside: a force, a voltage, a prescribed angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    pub name: String,
    pub dimension: Dimension,
    /// The coherent SI unit.
    pub unit: String,
    /// The value as a function of time and state; `None` for an input without a value.
    pub value: Option<ScalarId>,
    /// The range of bytes of the name in the file.
    pub at: Range<usize>,
}

/// A mechanical or electromechanical system as data. Everything is in SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    pub parameters: Vec<Parameter>,
    pub coordinates: Vec<Coordinate>,
    /// The names of the currents of drives, each with the index of its charge among the coordinates.
    pub currents: Vec<(String, usize)>,
    /// The quasi-velocities of the file, as many as independent speeds; empty if the file has none.
    pub quasi_velocities: Vec<QuasiVelocity>,
    /// The frames; the ground comes first.
    pub frames: Vec<Frame>,
    /// The free frames.
    pub free: Vec<FrameId>,
    /// The points; the origin comes first.
    pub points: Vec<Point>,
    pub bodies: Vec<Body>,
    /// The gravitational acceleration vector.
    pub gravity: Option<VectorId>,
    pub energies: Energies,
    pub forces: Vec<Force>,
    pub torques: Vec<Torque>,
    pub generalised: Vec<GeneralisedForce>,
    pub constraints: Vec<Constraint>,
    /// Laws without accelerations that are constraints: combinations of the laws of coordinates.
    pub(crate) laws: Vec<Combination>,
    /// Coordinates without inertia, and the indices of the constraints that determine their speeds.
    pub(crate) inertialess: Vec<usize>,
    pub(crate) determining: Vec<usize>,
    /// Coordinates without inertia whose laws depend on conditions or diodes: their speeds are algebraic unknowns in each case.
    pub algebraic_speeds: Vec<usize>,
    /// The laws of the algebraic speeds.
    pub(crate) changing_laws: Vec<Combination>,
    /// The first algebraic speed whose law cannot be solved for it, and the reason.
    pub unsolved_law: Option<(usize, UnsolvedLaw)>,
    /// Coordinates that are the impulses of reactions on which loads and events depend: their rates are these reactions.
    pub impulses: Vec<usize>,
    pub contacts: Vec<Contact>,
    /// The system with an additional coordinate for each guide that its coordinates satisfy identically: the reaction of the guide is the force along it.
    pub released: Option<Box<Model>>,
    /// Redundant equations of constraints, which follow from the others along every motion from the start. They have no reaction.
    pub implied: Vec<Implied>,
    /// Faults of quasi-velocities that may disappear when redundant constraints of positions on the branch of the start are removed.
    pub unsettled: Vec<Fault>,
    /// The outputs of a run; the quasi-velocities are among them.
    pub outputs: Vec<Output>,
    /// Vectors and points of definitions, by name.
    pub definitions: Vec<(String, Defined)>,
    pub inputs: Vec<Input>,
    pub regulator: Option<Regulator>,
    /// The expressions of conditions; the law changes where one of them passes through zero.
    pub switches: Vec<ScalarId>,
    /// The range of bytes of the first occurrence of each condition in the file.
    pub switch_places: Vec<Range<usize>>,
    /// The coherent unit of each condition.
    pub switch_units: Vec<String>,
    /// The domains of functions: roots, logarithms, powers, inverse trigonometric and exponential functions.
    pub domains: Vec<Domain>,
    pub events: Vec<Event>,
    pub start: Vec<StartValue>,
    /// Quasi-velocities at the start; the initial speeds are determined such that these hold.
    pub start_speeds: Vec<StartSpeed>,
    /// The range of bytes of the key that makes the start an equilibrium near the given values.
    pub equilibrium: Option<Range<usize>>,
    /// The indices of parameters that are permanently zero.
    pub absent: Vec<usize>,
    /// Accepted texts that may have an unintended meaning.
    pub warnings: Vec<Fault>,
    pub(crate) arena: Arena,
    /// Expressions that are evaluated before all others, since inputs depend on them. They depend on time and state only.
    pub(crate) ahead: Vec<ScalarId>,
}

/// The domain of a function, bounded by an expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// The expression that bounds the domain.
    pub margin: ScalarId,
    pub end: DomainEnd,
    /// The range of bytes of the function in the file.
    pub at: Range<usize>,
}

/// The kind of bound of a domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DomainEnd {
    /// The function is undefined where the expression is negative.
    Negative,
    /// The exponential of the expression overflows where it is large.
    Large,
}

impl Model {
    /// Elaborates a system: resolves its names and checks its dimensions.
    ///
    /// # Errors
    /// All faults of the system, each with its position.
    pub fn of(source: &Source) -> Result<Self, Vec<Fault>> {
        crate::elaboration::elaborate(source)
    }

    /// Returns the model without the constraints that determine coordinates without inertia, and these coordinates; `None` if there are none.
    pub fn with_inertia_alone(&self) -> Option<(Model, Vec<usize>)> {
        if self.determining.is_empty() {
            return None;
        }
        let mut without = self.clone();
        let kept = self.constraints.iter().enumerate().filter(|(place, _)| !self.determining.contains(place));
        without.constraints = kept.map(|(_, constraint)| constraint.clone()).collect();
        Some((without, self.inertialess.clone()))
    }

    /// Returns the model with its case-dependent laws without inertia as constraints, which are valid between changes of the conditions.
    pub fn with_changing_laws(&self) -> Cow<'_, Model> {
        crate::elaboration::with_changing_laws(self)
    }

    /// Sets every input without a value to zero.
    pub fn close_inputs(&mut self) {
        self.close((0..self.inputs.len()).collect());
    }

    /// Sets the inputs of the regulator that have no value to zero, their value along the reference motion.
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

    /// The model with every equation of its constraints, those that follow from others too.
    #[must_use]
    pub fn whole(&self) -> Self {
        let mut whole = self.clone();
        whole.implied.clear();
        whole
    }

    /// Returns whether an equation, given by its constraint and component, is redundant.
    pub fn is_implied(&self, of: [usize; 2]) -> bool {
        self.implied.iter().any(|implied| implied.of == of)
    }

    /// Returns the number of coordinates, including four for each free frame.
    pub fn positions(&self) -> usize {
        self.coordinates.len() + 4 * self.free.len()
    }

    /// Returns the number of speeds, including three for each free frame.
    pub fn speeds(&self) -> usize {
        self.coordinates.len() + 3 * self.free.len()
    }

    /// Returns the index of the first of the four coordinates of a free frame.
    pub fn free_position(&self, number: usize) -> usize {
        self.coordinates.len() + 4 * number
    }

    /// Returns the index of the first of the three speeds of a free frame.
    pub fn free_speed(&self, number: usize) -> usize {
        self.coordinates.len() + 3 * number
    }

    /// Returns (name, unit) of all coordinates and speeds, in the order of a state.
    pub fn state_names(&self) -> Vec<(String, String)> {
        let own = |rate: &str, per: &str| -> Vec<(String, String)> {
            let unit = |place: usize, of: &str| match (of, per) {
                // the rate of a charge is a current
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

    /// Returns the state at time zero: coordinates, then speeds. Omitted values are zero; free frames are aligned with their parents. A reaction without a value
    /// starts at one unit, since a norm such as |R| has no derivative at zero; iteration then determines it.
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

    /// Computes the rates of the coordinates from a state (coordinates, then speeds), over any field.
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
