//! Lemmas on points: if the velocity of a point has the required properties, so has that of a point defined from it, and that of a point
//! fixed in a body.

use super::Equations;
use super::directions::{TestDirections, equal};
use crate::trace::{Frames, Vector};

/// A point defined from another one by a displacement along the axes of any frame.
pub(super) fn found_by_a_way() -> Equations {
    let mut any = TestDirections::any();
    let frames = Frames::turning_at(any.turning("w"));
    let way = super::directions::in_axes(["x", "y", "z"].map(|name| any.function(name)));
    let turning = frames.turning(way.frame);
    // relative to the ground
    let rate = |vector: Vector| frames.sum(vector.map(|part| any.rate(part)), frames.cross(turning, vector));
    let displaced = |vector: Vector, k: usize| {
        let turned = frames.cross(any.vector_by_speed(turning, k), vector);
        frames.sum(vector.map(|part| any.by_place(part, k)), turned)
    };
    let velocity = rate(way);
    let acceleration = rate(velocity);
    let along = |k: usize| {
        let slope = any.vector_by_speed(velocity, k);
        let turned: [_; 3] =
            std::array::from_fn(|part| any.transposed(k, |j| any.by_speed(velocity.components[part], j)));
        let led = frames.sum(rate(slope), super::directions::in_axes(turned));
        let by_acceleration = acceleration.map(|part| any.by_acceleration(part, k));
        let equations = [(displaced(way, k), slope), (by_acceleration, slope), (displaced(velocity, k), led)];
        equations.into_iter().flat_map(|(one, other)| equal(one, other))
    };
    (0..3).flat_map(along).collect()
}

/// A point fixed in a body: the derivative of its acceleration w' x r + w x (w x r) relative to the centre by an acceleration.
pub(super) fn carried_by_a_body() -> Equations {
    let mut any = TestDirections::any();
    let frames = Frames::turning_at(any.turning("w"));
    let arm = super::directions::in_axes(["x", "y", "z"].map(|name| any.function(name)));
    let turning = frames.turning(arm.frame);
    let angular = turning.map(|part| any.rate(part));
    let across = frames.cross(turning, frames.cross(turning, arm));
    let acceleration = frames.sum(frames.cross(angular, arm), across);
    let along = |k: usize| {
        let by_acceleration = acceleration.map(|part| any.by_acceleration(part, k));
        equal(by_acceleration, frames.cross(any.vector_by_speed(turning, k), arm))
    };
    (0..3).flat_map(along).collect()
}
