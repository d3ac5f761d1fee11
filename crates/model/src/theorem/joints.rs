//! Lemma on joints: a load that is referred to a joint has equal power there.

use super::Equations;
use super::directions::in_axes;
use crate::trace::{Frames, Vector};
use symbolic::Sym;

/// A force F at a point P and a torque T, on a link with velocity v at its joint J and angular velocity w, are equivalent to the force F and the torque
/// T + (P - J) x F at the joint:
///
///   F . (v + w x (P - J)) + T . w = F . v + (T + (P - J) x F) . w .
///
/// Weights, given loads and the loads of outer joints are referred to the joint in this way. The power of a joint's load on the parent is
/// the power of the load that the parent passes on. After summation over all links, only the power of inertia and of
/// given loads on the partial velocities of their points remains.
pub(super) fn carried() -> Equations {
    let frames = Frames::turning_at(Vector::ZERO);
    let [force, torque, velocity, turning, arm] = ["F", "T", "v", "w", "r"]
        .map(|name| in_axes(std::array::from_fn(|part| Sym::symbol(&format!("{name} {}", part + 1)))));
    let at_point = frames.sum(velocity, frames.cross(turning, arm));
    let at_joint = frames.sum(torque, frames.cross(arm, force));
    let own = frames.dot(force, at_point) + frames.dot(torque, turning);
    vec![(own, frames.dot(force, velocity) + frames.dot(at_joint, turning))]
}
