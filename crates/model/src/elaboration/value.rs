//! What an expression, or a part of one, stands for.

use crate::{FrameId, PointId, ScalarId, VectorId};

/// What an expression stands for.
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
