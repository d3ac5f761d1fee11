//! The text of a system: keys with texts, each with its position in the file.

use crate::OneWay;
use std::ops::Range;

/// A text, and the byte of the file at which it begins.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    pub text: String,
    pub start: usize,
}

impl Text {
    /// Creates a text at a position.
    pub fn at(text: impl Into<String>, start: usize) -> Self {
        Text { text: text.into(), start }
    }

    /// Returns the range of bytes of the whole text.
    pub fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    /// Returns the range of bytes in the file of a part of the text.
    pub fn part(&self, part: &Range<usize>) -> Range<usize> {
        self.start + part.start..self.start + part.end
    }

    /// Returns a part of the text, with its position.
    pub fn slice(&self, part: Range<usize>) -> Text {
        Text { start: self.start + part.start, text: self.text[part].to_owned() }
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Self {
        Text::at(text, 0)
    }
}

/// A name with its text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Entry {
    pub name: Text,
    pub value: Text,
}

impl From<(&str, &str)> for Entry {
    fn from((name, value): (&str, &str)) -> Self {
        Entry { name: name.into(), value: value.into() }
    }
}

/// A system as text. Each field corresponds to a table or key of a file, and is empty if the file lacks it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Source {
    /// `m = "2 kg"`; without a number the parameter has no value.
    pub parameters: Vec<Entry>,
    /// `theta = "rad"`: the unit of each coordinate.
    pub coordinates: Vec<Entry>,
    /// `v = "velocity(G) . A.x"`: quasi-velocities, linear in the rates of coordinates.
    pub speeds: Vec<Entry>,
    /// Named scalars, vectors, points or frames.
    pub definitions: Vec<Entry>,
    /// `A = "N turned theta about z"`.
    pub frames: Vec<Entry>,
    /// `P = "O + l*A.x"`.
    pub points: Vec<Entry>,
    pub bodies: Vec<BodySource>,
    /// The gravitational acceleration, a vector. It gives a weight to every body with a mass.
    pub gravity: Option<Text>,
    /// `kinetic`, `potential`, `dissipation`, `coenergy`: scalars, in addition to those of the bodies.
    pub energies: Vec<Entry>,
    pub forces: Vec<LoadSource>,
    pub torques: Vec<LoadSource>,
    pub constraints: Vec<ConstraintSource>,
    pub contacts: Vec<ContactSource>,
    pub one_ways: Vec<OneWaySource>,
    pub drives: Vec<DriveSource>,
    /// Scalars that a run shows.
    pub outputs: Vec<Entry>,
    pub inputs: Vec<InputSource>,
    pub events: Vec<EventSource>,
    pub regulator: Option<RegulatorSource>,
    /// `theta = "30 deg"`, `theta' = "2 rad/s"`; omitted values are zero.
    pub start: Vec<Entry>,
    /// The range of bytes of the key that makes the start an equilibrium near the given values.
    pub equilibrium: Option<Range<usize>>,
    /// Parameters that a reduced model sets to zero permanently, with all terms that vanish.
    pub absent: Vec<String>,
    /// Parameters of stiff elements that a reduced model treats as rigid.
    pub rigid: Vec<String>,
    /// Angles in place of free rotations, for the free frames in the order of the file; the remaining frames stay free.
    pub angles: Vec<FrameAngles>,
}

/// Three angles that describe the orientation of a frame: successive rotations, each about the axis 0, 1 or 2 (x, y, z) of the previous frame.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameAngles {
    /// The axis of each rotation.
    pub axes: [usize; 3],
    /// The names of the angles, which follow that of the frame: `F.nutation`.
    pub names: [String; 3],
}

/// A body: a particle with a mass and a centre, or a rigid body with an inertia, fixed in a frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodySource {
    pub name: Text,
    /// The angle about N.z in a planar system.
    pub turns: Option<Text>,
    /// The frame in which the body is fixed.
    pub frame: Option<Text>,
    /// The centre of mass.
    pub centre: Option<Text>,
    pub mass: Option<Text>,
    pub inertia: Option<InertiaSource>,
}

impl BodySource {
    /// Returns a particle.
    pub fn particle(name: &str, centre: &str, mass: &str) -> Self {
        BodySource { name: name.into(), centre: Some(centre.into()), mass: Some(mass.into()), ..BodySource::default() }
    }
}

/// The inertia tensor about the centre of mass.
#[derive(Clone, Debug, PartialEq)]
pub enum InertiaSource {
    /// The moment of inertia about z, for a body that rotates about no other axis.
    Axial(Text),
    /// The entries xx, yy, zz, xy, xz, yz in the axes of a frame fixed in the body (by default the body's own frame), with
    /// xy = - integral of x y dm.
    Tensor { axes: Option<Text>, entries: Box<[Option<Text>; 6]> },
}

/// A force or a torque.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadSource {
    pub name: Option<Text>,
    /// `"disc at G"`, or a body for its centre of mass.
    pub on: Option<Text>,
    /// The coordinate `"theta"`, angular velocity `"F.wx"` of a free frame, or quasi-velocity along which a generalised force
    /// acts.
    pub along: Option<Text>,
    /// Two ends with opposite loads: a force along the line between two points, repulsive if positive; or a torque on the second frame, its reaction on
    /// the first.
    pub between: Option<[Text; 2]>,
    /// The value: a vector for `on`, otherwise a scalar; for a torque between two frames a vector.
    pub is: Text,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// A constraint: expressions that vanish along every motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConstraintSource {
    pub name: Option<Text>,
    /// Scalars, or vectors whose components all vanish.
    pub zero: Vec<Text>,
    /// The gains of a stabilised constraint f, which may be violated: f'' + g1 f' + g2 f = 0 for positions, f' + g1 f =
    /// 0 for speeds.
    pub gains: Option<Vec<Text>>,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// A contact of a point with a plane, a curve or a guide.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactSource {
    pub name: Option<Text>,
    /// The touching point, such as `"ladder at B"`.
    pub of: Option<Text>,
    /// The other body; by default the ground.
    pub with: Option<Text>,
    /// A body in a guide, such as `"slider, N along x"`.
    pub between: Option<Text>,
    /// A point of the plane.
    pub through: Option<Text>,
    /// A vector along which the gap increases.
    pub normal: Option<Text>,
    /// The gap as an expression, in place of a point of the plane.
    pub gap: Option<Text>,
    /// `one` or `both`: unilateral or bilateral.
    pub sides: Option<Text>,
    pub friction: Option<Text>,
    pub restitution: Option<Text>,
    /// The law of restitution: `newton`, `poisson` or `moreau`.
    pub impact: Option<Text>,
    /// Whether the contact is closed at the start.
    pub touching: bool,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// A diode or a freewheel: a speed that does not become negative.
#[derive(Clone, Debug, PartialEq)]
pub struct OneWaySource {
    pub is: OneWay,
    pub name: Option<Text>,
    /// The current, a sum of rates of charges, or the speed.
    pub speed: Text,
    /// The voltage drop, torque or force while the speed is positive; zero if omitted.
    pub drop: Option<Text>,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// A motor between two bodies, or between the ground and a body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DriveSource {
    pub name: Option<Text>,
    /// The angle of the shaft relative to the ground.
    pub turns: Option<Text>,
    /// Two bodies or frames: the first carries the motor, which turns the second.
    pub between: Option<[Text; 2]>,
    /// The gear ratio: rotations of the motor per rotation of the shaft; 1 if omitted.
    pub ratio: Option<Text>,
    /// The moment of inertia of the motor's rotor.
    pub inertia: Option<Text>,
    /// A torque on the motor in addition to those of its windings.
    pub torque: Option<Text>,
    pub windings: Vec<WindingSource>,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// A winding with the law (L i)' = v - R i - k w, where w is the motor's speed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WindingSource {
    /// The name of the current; `i` if omitted.
    pub current: Option<Text>,
    /// The inductance L, a function of positions.
    pub inductance: Text,
    /// The resistance R; zero if omitted.
    pub resistance: Option<Text>,
    /// The supply voltage v; zero if omitted.
    pub supply: Option<Text>,
    /// The motional constant k: the counter voltage per speed of the motor, and the torque per current.
    pub motional: Option<Text>,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// An input: a quantity that acts from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InputSource {
    pub name: Text,
    pub unit: Text,
    /// The value as a function of time and state; `None` for an input without a value, as in a linearisation.
    pub value: Option<Text>,
}

/// The cost function of an optimal regulator.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RegulatorSource {
    /// The names of the inputs that the regulator sets; all inputs if the list is empty.
    pub inputs: Vec<Text>,
    /// The cost per unit time, a quadratic form of deviations.
    pub cost: Text,
    /// The cost of the deviation at the end.
    pub last: Option<Text>,
    /// The horizon, a time; infinite if omitted.
    pub horizon: Option<Text>,
    /// Deviations at the start.
    pub displaced: Vec<Entry>,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// An instant at which the expression `when` passes through zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventSource {
    pub name: Option<Text>,
    /// The expression, or a comparison of two.
    pub when: Text,
    /// `up`, `down` or `both`.
    pub direction: Option<Text>,
    /// Values of coordinates and speeds after the event.
    pub set: Vec<Entry>,
    /// Whether the event ends the motion.
    pub ends: bool,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}
