//! Values of expressions.

use super::{GRAVITY, TARGET, TORQUE};
use crate::{Fault, FrameId, PointId, ScalarId, VectorId};
use std::ops::Range;

/// The value of an expression or subexpression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Value {
    Scalar(ScalarId),
    Vector(VectorId),
    /// A point, or the point displaced from `base` by the vector `way`.
    Point {
        base: PointId,
        way: Option<VectorId>,
    },
    Frame(FrameId),
}

impl Value {
    /// Returns the kind of the value for messages.
    pub fn describe(&self) -> &'static str {
        match self {
            Value::Scalar(_) => "a scalar",
            Value::Vector(_) => "a vector",
            Value::Point { .. } => "a point",
            Value::Frame(_) => "a frame",
        }
    }
}

/// Returns the fault of a value of the wrong kind.
pub(super) fn mismatch(span: &Range<usize>, what: &str, needed: &str, found: &Value) -> Box<Fault> {
    let found = found.describe();
    let accepted = instead(what, needed, found);
    Box::new(Fault::at(span.clone(), format!("{what} is {needed}"), format!("this is {found}"), accepted))
}

/// Returns an example of an accepted expression.
fn instead(what: &str, needed: &str, found: &str) -> String {
    let example = match (needed, found) {
        ("a vector", "a scalar") if what == TORQUE => ", such as a*N.x; about the axis of a planar system a*N.z",
        ("a vector", "a scalar") if what == GRAVITY => ", such as -a*N.y",
        ("a vector", "a scalar") => ", such as a*N.x",
        ("a vector", "a point") => ", such as P - O",
        ("a scalar", "a vector") => ", such as the component v . N.x, or norm(v)",
        ("a scalar", "a point") => ", such as (P - O) . N.x, or distance(O, P)",
        ("a point", "a vector") => ", such as O + v",
        ("a point", "a scalar") => ", such as O + x*N.x",
        (_, "a scalar") if what == TARGET => {
            " is accepted; a force along a coordinate x has `along = \"x\"` in the place of `on`"
        }
        _ => " is accepted",
    };
    format!("{needed}{example}")
}
