//! Joints: a load that is carried down to a joint does the same power there.

use super::Equations;
use super::directions::in_axes;
use crate::trace::{Frames, Vector};
use symbolic::Sym;

/// A force F at a point P and a torque T, on a link that has the velocity v at its joint J and turns at w, are the force F and the torque
/// T + (P - J) x F at the joint:
///
///   F . (v + w x (P - J)) + T . w = F . v + (T + (P - J) x F) . w .
///
/// Weights of bodies, given loads, and those of the joints above are carried down so; the power of a joint's load on its parent is
/// the power of the load which the parent carries further. From the last links down nothing is left but the power of inertia and of
/// given loads on the partial velocities of the points at which they act.
pub(super) fn carried() -> Equations {
    let frames = Frames::turning_at(Vector::ZERO);
    let [force, torque, velocity, turning, arm] = ["F", "T", "v", "w", "r"]
        .map(|name| in_axes(std::array::from_fn(|part| Sym::symbol(&format!("{name} {}", part + 1)))));
    let at_point = frames.sum(velocity, frames.cross(turning, arm));
    let at_joint = frames.sum(torque, frames.cross(arm, force));
    let own = frames.dot(force, at_point) + frames.dot(torque, turning);
    vec![(own, frames.dot(force, velocity) + frames.dot(at_joint, turning))]
}
