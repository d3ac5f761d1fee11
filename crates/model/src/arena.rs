//! The expressions of a model: every part by its place in one list, after the parts that it is made of.

use crate::expression::Exponent;
use crate::{FrameId, Material, PointId};

/// A scalar expression of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScalarId(pub(crate) usize);

/// A vector expression of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VectorId(pub(crate) usize);

/// A decimal number with a unit: `times / per` of the coherent unit each.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    pub value: f64,
    pub times: f64,
    pub per: f64,
}

/// A part of a scalar expression.
#[derive(Clone, Debug, PartialEq)]
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
    /// The half turn.
    Pi,
    Negation(ScalarId),
    Sum(ScalarId, ScalarId),
    Difference(ScalarId, ScalarId),
    Product(ScalarId, ScalarId),
    Quotient(ScalarId, ScalarId),
    Power(ScalarId, Exponent),
    Function(Function, ScalarId),
    Dot(VectorId, VectorId),
    Norm(VectorId),
    /// The rate of a scalar along the motion.
    RateOf(ScalarId),
}

/// A function of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Sqrt,
}

impl Function {
    /// The function of a name.
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
#[derive(Clone, Debug, PartialEq)]
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
    /// From a point to another.
    Between {
        from: PointId,
        to: PointId,
    },
    /// As seen from a frame; a point of a body moves with it.
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
    /// The rate of a vector, as seen from a frame.
    RateOf {
        of: VectorId,
        seen: FrameId,
    },
}

/// A part of an expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Part {
    Scalar(Scalar),
    Vector(Vector),
}

/// All parts of a model's expressions.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Arena {
    pub parts: Vec<Part>,
}

impl Arena {
    pub fn scalar(&mut self, scalar: Scalar) -> ScalarId {
        self.parts.push(Part::Scalar(scalar));
        ScalarId(self.parts.len() - 1)
    }

    pub fn vector(&mut self, vector: Vector) -> VectorId {
        self.parts.push(Part::Vector(vector));
        VectorId(self.parts.len() - 1)
    }
}
