//! Values of expressions and of their parts.

use crate::{FrameId, PointId, ScalarId, VectorId};

/// The value of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Value {
    Scalar(ScalarId),
    Vector(VectorId),
    /// A point, or one a way from it.
    Point {
        base: PointId,
        way: Option<VectorId>,
    },
    Frame(FrameId),
}

impl Value {
    /// In words.
    pub fn describe(&self) -> &'static str {
        match self {
            Value::Scalar(_) => "a scalar",
            Value::Vector(_) => "a vector",
            Value::Point { .. } => "a point",
            Value::Frame(_) => "a frame",
        }
    }
}
