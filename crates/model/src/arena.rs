//! The expressions of a model, stored in one list in which operands precede the operations on them.

use crate::expression::Exponent;
use crate::{BodyId, FrameId, Material, PointId};
use field::Elementary;
use rustc_hash::FxHashMap;
use std::hash::{Hash, Hasher};
use symbolic::Dimension;

/// The index of a scalar expression in the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScalarId(pub(crate) usize);

/// The index of a vector expression in the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VectorId(pub(crate) usize);

/// A decimal number with a unit that equals `times / per` of the coherent SI unit.
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

/// Bitwise equality.
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

/// The value of a comparison at equality of its sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AtZero {
    /// 0, for `a < b`.
    Off,
    /// 1/2, for the function sign.
    Half,
    /// 1, for `a <= b`.
    On,
}

/// A node of a scalar expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scalar {
    Number(Number),
    Parameter(usize),
    Coordinate(usize),
    /// The first or second time derivative of a coordinate.
    Rate {
        coordinate: usize,
        order: usize,
    },
    Time,
    /// 1 if the expression of the switch is positive, 0 if it is negative. The second field gives the value at zero.
    Switch(usize, AtZero),
    /// The corresponding step function in outputs, on which the law does not depend.
    Step(ScalarId, AtZero),
    /// An input, represented by its value or by a symbol.
    Input(usize),
    /// The number pi.
    Pi,
    Negation(ScalarId),
    Sum(ScalarId, ScalarId),
    Difference(ScalarId, ScalarId),
    Product(ScalarId, ScalarId),
    Quotient(ScalarId, ScalarId),
    Power(ScalarId, Exponent),
    Function(Function, ScalarId),
    /// An elementary function. A function of one argument stores its argument twice.
    Elementary(Elementary, ScalarId, ScalarId),
    Dot(VectorId, VectorId),
    Norm(VectorId),
    /// The time derivative of a scalar along the motion.
    RateOf(ScalarId),
    /// The multiplier of a scalar constraint, given by its index in the model.
    Reaction {
        constraint: usize,
    },
    /// The normal (component 0) or tangential (component 1) reaction of a contact.
    Contact {
        contact: usize,
        component: usize,
    },
    /// The kinetic energy T of the whole system.
    KineticEnergy,
    /// The potential energy V of the whole system.
    PotentialEnergy,
    /// Inertia minus forces, without acceleration terms, of an equation of coordinates without inertia; `number` counts these equations of the model.
    Law {
        number: usize,
    },
    /// The momentum dT/du of the speed u with index `speed`.
    Momentum {
        speed: usize,
    },
}

/// An elementary function with a syntax of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Sqrt,
}

impl Function {
    /// Returns the function with this name.
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

/// A node of a vector expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Vector {
    Zero,
    /// A unit vector of a frame: axis 0, 1 or 2 for x, y or z.
    Axis {
        frame: FrameId,
        axis: usize,
    },
    Negation(VectorId),
    Sum(VectorId, VectorId),
    Difference(VectorId, VectorId),
    Scaled(ScalarId, VectorId),
    Cross(VectorId, VectorId),
    /// The vector from one point to another.
    Between {
        from: PointId,
        to: PointId,
    },
    /// The velocity of a point relative to a frame. A point of a body moves with the body.
    Velocity {
        of: Material,
        seen: FrameId,
    },
    Acceleration {
        of: Material,
        seen: FrameId,
    },
    /// The angular velocity of a frame relative to another frame.
    AngularVelocity {
        of: FrameId,
        seen: FrameId,
    },
    /// The time derivative of a vector relative to a frame.
    RateOf {
        of: VectorId,
        seen: FrameId,
    },
    /// The multipliers of a vector constraint as a vector; the constraint is given by its index in the model.
    Reaction {
        constraint: usize,
    },
    /// The force that a joint exerts on its body.
    JointForce(BodyId),
    /// The torque that a joint exerts on its body.
    JointTorque(BodyId),
}

/// A node of any expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Part {
    Scalar(Scalar),
    Vector(Vector),
}

/// All nodes of a model's expressions.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Arena {
    pub parts: Vec<Part>,
    /// The index of each node, so that equal nodes are stored once. For numbers the key contains the dimension.
    known: FxHashMap<(Part, String), usize>,
}

impl Arena {
    fn place(&mut self, part: Part, dimension: String) -> usize {
        *self.known.entry((part, dimension)).or_insert_with(|| {
            self.parts.push(part);
            self.parts.len() - 1
        })
    }

    /// Adds a scalar node, or finds an equal one. Numbers are equal only if their dimensions are.
    pub fn scalar(&mut self, scalar: Scalar, dimension: Option<Dimension>) -> ScalarId {
        let named = dimension.filter(|_| matches!(scalar, Scalar::Number(_)));
        ScalarId(self.place(Part::Scalar(scalar), named.map_or_else(String::new, |dimension| dimension.to_string())))
    }

    /// Returns the scalar node with this index; `None` if it is a vector.
    pub fn scalar_at(&self, id: ScalarId) -> Option<&Scalar> {
        match self.parts.get(id.0)? {
            Part::Scalar(scalar) => Some(scalar),
            Part::Vector(_) => None,
        }
    }

    /// Returns the vector node with this index; `None` if it is a scalar.
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
