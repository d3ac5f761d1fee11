//! The theorem of angular momentum about a fixed point, in a moving frame.

use field::{Scalar, Tangent};
use nalgebra::Vector3;

/// The absolute rate d'x/dt + w x x of a vector given by components in a frame that rotates with the angular velocity w
/// (rad/s). For the angular momentum about a fixed point it equals the torque of the external forces.
///
/// `momentum` is x as dual numbers along the motion, with the relative derivative d'x/dt.
pub fn absolute_rate<S: Scalar>(momentum: Vector3<Tangent<S>>, angular_velocity: Vector3<S>) -> Vector3<S> {
    let relative = momentum.map(|x| x.slope);
    relative + angular_velocity.cross(&momentum.map(|x| x.value))
}
