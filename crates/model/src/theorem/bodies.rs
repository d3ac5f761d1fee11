//! Lemmas on bodies: Lagrange's operator on the kinetic energy, momenta along partial velocities, and the energy of accelerations.

use super::Equations;
use super::directions::{TestDirections, in_axes};
use crate::trace::{Frames, Vector};
use field::Rational;
use symbolic::Sym;

fn half() -> Sym {
    Sym::constant(Rational::new(1, 2))
}

/// A mass at an arbitrary point: (dT/du)' - dT/dq = m a . dv/du = dS/du'.
pub(super) fn masses() -> Equations {
    let mut any = TestDirections::any();
    let (velocity, acceleration) = any.velocity("v");
    let frames = Frames::turning_at(Vector::ZERO);
    let mass = Sym::symbol("m");
    let kinetic = half() * mass * frames.dot(velocity, velocity);
    let of_accelerations = half() * mass * frames.dot(acceleration, acceleration);
    let along = |k: usize| {
        let power = mass * frames.dot(acceleration, any.vector_by_speed(velocity, k));
        [(any.lagrange(kinetic, k), power), (any.by_acceleration(of_accelerations, k), power)]
    };
    (0..3).flat_map(along).collect()
}

/// An inertia tensor that is constant in axes of the body: (dT/du)' - dT/dq = (I w)' . dw/du = dS/du'.
pub(super) fn inertias() -> Equations {
    let mut any = TestDirections::any();
    let turning = any.turning("w");
    let [xx, yy, zz, xy, xz, yz] = ["xx", "yy", "zz", "xy", "xz", "yz"].map(Sym::symbol);
    let times = |vector: Vector| {
        let [x, y, z] = vector.components;
        in_axes([xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z])
    };
    of_inertia(&any, turning, turning, times)
}

/// An inertia tensor with equal moments about two axes, in a frame relative to which the body spins about the third axis.
pub(super) fn inertias_beside_a_spin() -> Equations {
    let about = |axis: usize| {
        let mut any = TestDirections::any();
        let (axes, angle) = (any.turning("w"), any.function("angle"));
        let mut turning = axes;
        turning.components[axis] += any.rate(angle);
        let [across, along] = ["across", "along"].map(Sym::symbol);
        let times = |vector: Vector| {
            let mut scaled = vector.map(|component| across * component);
            scaled.components[axis] = along * vector.components[axis];
            scaled
        };
        of_inertia(&any, axes, turning, times)
    };
    (0..3).flat_map(about).collect()
}

/// The equations for a body with angular velocity `turning`, in axes with angular velocity `axes`.
fn of_inertia(any: &TestDirections, axes: Vector, turning: Vector, times: impl Fn(Vector) -> Vector) -> Equations {
    let frames = Frames::turning_at(axes);
    let rate = |vector: Vector| frames.sum(vector.map(|part| any.rate(part)), frames.cross(axes, vector));
    let momentum = times(turning);
    // the rate of the angular velocity is equal relative to the ground and to the body
    let angular = rate(turning);
    let kinetic = half() * frames.dot(turning, momentum);
    let gyroscopic = frames.dot(angular, frames.cross(turning, momentum));
    let of_accelerations = half() * frames.dot(angular, times(angular)) + gyroscopic;
    let along = |k: usize| {
        let power = frames.dot(rate(momentum), any.vector_by_speed(turning, k));
        [(any.lagrange(kinetic, k), power), (any.by_acceleration(of_accelerations, k), power)]
    };
    (0..3).flat_map(along).collect()
}
