//! A system as it is written: keys with texts, each text with its place.

use crate::OneWay;
use std::ops::Range;

/// A text and the byte of its file at which it begins.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    pub text: String,
    pub start: usize,
}

impl Text {
    /// A text at a place.
    pub fn at(text: impl Into<String>, start: usize) -> Self {
        Text { text: text.into(), start }
    }

    /// The bytes of the whole text.
    pub fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    /// The bytes of a part of it.
    pub fn part(&self, part: &Range<usize>) -> Range<usize> {
        self.start + part.start..self.start + part.end
    }

    /// A part as a text of its own.
    pub fn slice(&self, part: Range<usize>) -> Text {
        Text { start: self.start + part.start, text: self.text[part].to_owned() }
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Self {
        Text::at(text, 0)
    }
}

/// A name and its text.
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

/// A system: each field is a table of the same name in a file, and is empty where that is left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Source {
    /// `m = "2 kg"`; a unit alone leaves the parameter without a value.
    pub parameters: Vec<Entry>,
    /// `theta = "rad"`: the unit of each.
    pub coordinates: Vec<Entry>,
    /// `v = "velocity(G) . A.x"`: quasi-velocities, linear in the rates of coordinates.
    pub speeds: Vec<Entry>,
    /// Scalars, vectors, points or frames by names.
    pub definitions: Vec<Entry>,
    /// `A = "N turned theta about z"`.
    pub frames: Vec<Entry>,
    /// `P = "O + l*A.x"`.
    pub points: Vec<Entry>,
    pub bodies: Vec<BodySource>,
    /// The acceleration of free fall, a vector: a force on every body with a mass.
    pub gravity: Option<Text>,
    /// `kinetic`, `potential`, `dissipation`: scalars, beside those of the bodies.
    pub energies: Vec<Entry>,
    pub forces: Vec<LoadSource>,
    pub torques: Vec<LoadSource>,
    pub constraints: Vec<ConstraintSource>,
    pub contacts: Vec<ContactSource>,
    pub one_ways: Vec<OneWaySource>,
    pub drives: Vec<DriveSource>,
    /// Scalars and vectors that a run shows.
    pub outputs: Vec<Entry>,
    pub inputs: Vec<InputSource>,
    pub events: Vec<EventSource>,
    pub regulator: Option<RegulatorSource>,
    /// `theta = "30 deg"`, `theta' = "2 rad/s"`; zero where left out.
    pub start: Vec<Entry>,
    /// The place where the start is declared an equilibrium near these values.
    pub equilibrium: Option<Range<usize>>,
    /// Parameters that a smaller model leaves out: zero for good, with all that vanishes with them; no text names them.
    pub absent: Vec<String>,
    /// Parameters of springs and viscous forces that it takes for rigid.
    pub rigid: Vec<String>,
    /// Angles in the place of free turns, for each free frame in the order of the file; where this is shorter, frames turn freely.
    pub angles: Vec<FrameAngles>,
}

/// Three angles that place a frame in its parent: turns one after the other, each about an axis, x, y or z, of the frame before.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameAngles {
    pub axes: [usize; 3],
    /// The names of the angles behind that of the frame: `F.nutation`.
    pub names: [String; 3],
}

/// A body: with a mass and a centre a particle, with an inertia it turns with its frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodySource {
    pub name: Text,
    /// An angle about N.z, for a body of a planar system.
    pub turns: Option<Text>,
    /// The frame that it is fixed in.
    pub frame: Option<Text>,
    /// The centre of mass.
    pub centre: Option<Text>,
    pub mass: Option<Text>,
    pub inertia: Option<InertiaSource>,
}

impl BodySource {
    /// A point with a mass.
    pub fn particle(name: &str, centre: &str, mass: &str) -> Self {
        BodySource { name: name.into(), centre: Some(centre.into()), mass: Some(mass.into()), ..BodySource::default() }
    }
}

/// Moments of inertia about the centre of mass.
#[derive(Clone, Debug, PartialEq)]
pub enum InertiaSource {
    /// About the axis z, for a body that turns about no other.
    Axial(Text),
    /// In the axes of a frame that is fixed in the body (its own where none is named): xx, yy, zz, xy, xz, yz, where
    /// xy = - integral of x y dm.
    Tensor { axes: Option<Text>, entries: Box<[Option<Text>; 6]> },
}

/// A force or a torque.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadSource {
    pub name: Option<Text>,
    /// `"disc at G"`, or a body: then at its centre of mass.
    pub on: Option<Text>,
    /// The name along which a force has power: a coordinate, `"theta"`, an angular velocity of a free frame, `"F.wx"`, or a
    /// quasi-velocity.
    pub along: Option<Text>,
    /// Two ends with equal and opposite loads: a force along the line of the points, positive apart; a torque on the second, its opposite on
    /// the first.
    pub between: Option<[Text; 2]>,
    pub is: Text,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

/// Expressions that are zero along every motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConstraintSource {
    pub name: Option<Text>,
    /// Scalars, or vectors: of these each component.
    pub zero: Vec<Text>,
    /// The gains of a constraint f that is led to zero instead of kept at zero: f'' + g1 f' + g2 f = 0 of positions, f' + g1 f =
    /// 0 of speeds.
    pub gains: Option<Vec<Text>>,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

/// A contact of a point of a body with a plane, a curve or a guide.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactSource {
    pub name: Option<Text>,
    /// `"ladder at B"`: the point that touches.
    pub of: Option<Text>,
    /// The body that it touches; the ground where left out.
    pub with: Option<Text>,
    /// `"slider, N along x"`: a body in a guide.
    pub between: Option<Text>,
    /// A point of the plane.
    pub through: Option<Text>,
    /// The direction in which the gap grows, a vector.
    pub normal: Option<Text>,
    /// The gap, in the place of a point of the plane.
    pub gap: Option<Text>,
    /// `one` or `both`.
    pub sides: Option<Text>,
    pub friction: Option<Text>,
    pub restitution: Option<Text>,
    /// `newton`, `poisson` or `moreau`: the law of restitution.
    pub impact: Option<Text>,
    /// Whether the start is completed so that the gap is zero.
    pub touching: bool,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

/// A diode or a freewheel: a speed that does not fall below zero.
#[derive(Clone, Debug, PartialEq)]
pub struct OneWaySource {
    pub is: OneWay,
    pub name: Option<Text>,
    /// A current of charges, or a speed.
    pub speed: Text,
    /// The voltage, or the torque or force, that it takes while the speed is positive; zero where left out.
    pub drop: Option<Text>,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

/// A motor between two bodies, or on one that turns beside the ground.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DriveSource {
    pub name: Option<Text>,
    /// The angle of the shaft relative to the ground.
    pub turns: Option<Text>,
    /// Two bodies or frames: the motor sits on the first and turns the second.
    pub between: Option<[Text; 2]>,
    /// Turns of the motor for one of the shaft; 1 where left out.
    pub ratio: Option<Text>,
    /// The moment of inertia of the motor's rotor.
    pub inertia: Option<Text>,
    /// A torque on the motor beside those of its windings.
    pub torque: Option<Text>,
    pub windings: Vec<WindingSource>,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

/// A winding: (L i)' = v - R i - k w.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WindingSource {
    /// The name of its current; `i` where left out.
    pub current: Option<Text>,
    /// L, of positions.
    pub inductance: Text,
    /// R; zero where left out.
    pub resistance: Option<Text>,
    /// v; zero where left out.
    pub supply: Option<Text>,
    /// k, the voltage per speed of the motor against the supply, and the torque per current.
    pub motional: Option<Text>,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

/// A quantity that acts from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InputSource {
    pub name: Text,
    pub unit: Text,
    /// A scalar of time and state; none: a letter, for linearisation.
    pub value: Option<Text>,
}

/// The criterion of an optimal regulator.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RegulatorSource {
    /// Names of inputs; all where there are none.
    pub inputs: Vec<Text>,
    /// A quadratic form of deviations.
    pub cost: Text,
    /// The cost of the end.
    pub last: Option<Text>,
    pub horizon: Option<Text>,
    /// Deviations at the start.
    pub displaced: Vec<Entry>,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

/// An instant at which an expression passes zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventSource {
    pub name: Option<Text>,
    pub when: Text,
    /// `up`, `down` or `both`.
    pub direction: Option<Text>,
    /// Coordinates and speeds after it.
    pub set: Vec<Entry>,
    /// Whether the motion ends.
    pub ends: bool,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}
