//! The theorem of angular momentum about a fixed point, in a moving frame.

use field::{Scalar, Tangent};
use nalgebra::Vector3;

/// d'x/dt + w x x: the absolute rate of a vector given by components in a frame that turns with angular velocity w.
/// By the theorem, the rate of the angular momentum is the torque of the external forces about the fixed point.
///
/// `momentum` is x along the motion: its tangent holds the relative derivative d'x/dt.
pub fn absolute_rate<S: Scalar>(momentum: Vector3<Tangent<S>>, angular_velocity: Vector3<S>) -> Vector3<S> {
    let relative = momentum.map(|x| x.slope);
    relative + angular_velocity.cross(&momentum.map(|x| x.value))
}
