//! The expressions of a model: all parts in one list, each after its own parts.

use crate::expression::Exponent;
use crate::{BodyId, FrameId, Material, PointId};
use field::Elementary;
use rustc_hash::FxHashMap;
use std::hash::{Hash, Hasher};
use symbolic::Dimension;

/// A scalar expression of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScalarId(pub(crate) usize);

/// A vector expression of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VectorId(pub(crate) usize);

/// A decimal number with a unit: `times / per` of the coherent unit each.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    pub value: f64,
    pub times: f64,
    pub per: f64,
}

impl Number {
    fn bits(&self) -> [u64; 3] {
        [self.value, self.times, self.per].map(f64::to_bits)
    }
}

/// Equal as written.
impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.bits() == other.bits()
    }
}

impl Eq for Number {}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.bits().hash(state);
    }
}

/// The value of a condition where both of its sides are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AtZero {
    /// 0, of `a < b`.
    Off,
    /// 1/2, so that the sign of zero is zero.
    Half,
    /// 1, of `a <= b`.
    On,
}

/// A part of a scalar expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scalar {
    Number(Number),
    Parameter(usize),
    Coordinate(usize),
    /// The first or second rate of a coordinate.
    Rate {
        coordinate: usize,
        order: usize,
    },
    Time,
    /// 1 where the expression of the switch is positive, 0 where it is negative; the law decides at zero.
    Switch(usize, AtZero),
    /// 1 where an expression is positive, 0 where it is negative, in outputs: the law does not depend on it.
    Step(ScalarId, AtZero),
    /// An input, by its value or as a letter.
    Input(usize),
    /// The half turn.
    Pi,
    Negation(ScalarId),
    Sum(ScalarId, ScalarId),
    Difference(ScalarId, ScalarId),
    Product(ScalarId, ScalarId),
    Quotient(ScalarId, ScalarId),
    Power(ScalarId, Exponent),
    Function(Function, ScalarId),
    /// An elementary function; one of a single argument has it twice.
    Elementary(Elementary, ScalarId, ScalarId),
    Dot(VectorId, VectorId),
    Norm(VectorId),
    /// The rate of a scalar along the motion.
    RateOf(ScalarId),
    /// The multiplier of a scalar constraint, by its place in the model.
    Reaction {
        constraint: usize,
    },
    /// A letter of a contact: its normal (0) or tangential (1) reaction.
    Contact {
        contact: usize,
        component: usize,
    },
    /// T, the kinetic energy of the whole system.
    KineticEnergy,
    /// V, the potential energy of the whole system.
    PotentialEnergy,
    /// Inertia less forces of coordinates without inertia, without accelerations: by its place among the laws of the model.
    Law {
        number: usize,
    },
    /// dT/du of a speed u, by its place.
    Momentum {
        speed: usize,
    },
}

/// A function of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Sqrt,
}

impl Function {
    /// The function with this name.
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "sin" => Function::Sin,
            "cos" => Function::Cos,
            "tan" => Function::Tan,
            "sqrt" => Function::Sqrt,
            _ => return None,
        })
    }
}

/// A part of a vector expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Vector {
    Zero,
    /// A unit vector: x, y or z of a frame.
    Axis {
        frame: FrameId,
        axis: usize,
    },
    Negation(VectorId),
    Sum(VectorId, VectorId),
    Difference(VectorId, VectorId),
    Scaled(ScalarId, VectorId),
    Cross(VectorId, VectorId),
    /// The vector from a point to another.
    Between {
        from: PointId,
        to: PointId,
    },
    /// The velocity relative to a frame; a point of a body moves with it.
    Velocity {
        of: Material,
        seen: FrameId,
    },
    Acceleration {
        of: Material,
        seen: FrameId,
    },
    /// A frame's angular velocity relative to another frame.
    AngularVelocity {
        of: FrameId,
        seen: FrameId,
    },
    /// The rate of a vector relative to a frame.
    RateOf {
        of: VectorId,
        seen: FrameId,
    },
    /// The multipliers of a vector constraint along its axes, by its place in the model.
    Reaction {
        constraint: usize,
    },
    /// The force on a body at its joint.
    JointForce(BodyId),
    /// The torque on a body about its joint.
    JointTorque(BodyId),
}

/// A part of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Part {
    Scalar(Scalar),
    Vector(Vector),
}

/// All parts of a model's expressions.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Arena {
    pub parts: Vec<Part>,
    /// The place of each part: equal parts are one. Numbers have the text of their dimension beside them.
    known: FxHashMap<(Part, String), usize>,
}

impl Arena {
    fn place(&mut self, part: Part, dimension: String) -> usize {
        *self.known.entry((part, dimension)).or_insert_with(|| {
            self.parts.push(part);
            self.parts.len() - 1
        })
    }

    /// A scalar; of a number the dimension counts too.
    pub fn scalar(&mut self, scalar: Scalar, dimension: Option<Dimension>) -> ScalarId {
        let named = dimension.filter(|_| matches!(scalar, Scalar::Number(_)));
        ScalarId(self.place(Part::Scalar(scalar), named.map_or_else(String::new, |dimension| dimension.to_string())))
    }

    /// A scalar by its place.
    pub fn scalar_at(&self, id: ScalarId) -> Option<&Scalar> {
        match self.parts.get(id.0)? {
            Part::Scalar(scalar) => Some(scalar),
            Part::Vector(_) => None,
        }
    }

    /// A vector by its place.
    pub fn vector_at(&self, id: VectorId) -> Option<&Vector> {
        match self.parts.get(id.0)? {
            Part::Vector(vector) => Some(vector),
            Part::Scalar(_) => None,
        }
    }

    pub fn vector(&mut self, vector: Vector) -> VectorId {
        VectorId(self.place(Part::Vector(vector), String::new()))
    }
}
