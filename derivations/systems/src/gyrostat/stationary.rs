//! Steady motions: rotations about the vertical with constant relative speed of the rotor.
//!
//! In the axes of A*, let w = w0 v be constant and W the relative speed of the rotor. The equations of motion then
//! require
//!
//!   F(v, w0) = (w0^2 A* v + A' W w0 l + Ge) x v = 0 .
//!
//! For a non-zero weight Ge, the directions v (except special ones, for which Ge.(A* v x v) = 0) are the points of the
//! unit sphere on the surface (Ge.t)^2 + (A' W)^2 (v.(l x Ge)) (l.t) = 0, t = A* v x v, each with one angular velocity.
//! Source: Konosevich, Konosevich 2022, (6.5), (7.10), (7.11).

use field::{Base, Over, Scalar};
use nalgebra::Vector3;

/// The data of the conditions for a gyrostat with given relative speed of the rotor, in the principal axes of A*.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stationary<P: Scalar> {
    /// The principal moments of A*, kg m^2.
    pub moments: Vector3<P>,
    /// The unit vector l of the rotor's axis.
    pub axis: Vector3<P>,
    /// The rotor's angular momentum relative to the carrier, A' W, N m s.
    pub spin: P,
    /// The vector Ge of the weight, N m.
    pub weight: Vector3<P>,
}

impl<P: Base> Stationary<P> {
    /// The residual torque F, N m, which is zero if w0 v is a steady motion.
    pub fn residual_torque<S: Over<P>>(&self, v: Vector3<S>, w0: S) -> Vector3<S> {
        let momentum = v.component_mul(&self.moments.map(S::lift)) * w0 + self.axis.map(S::lift) * S::lift(self.spin);
        (momentum * w0 + self.weight.map(S::lift)).cross(&v)
    }

    /// The vector t = A* v x v.
    fn tilt<S: Over<P>>(&self, v: Vector3<S>) -> Vector3<S> {
        v.component_mul(&self.moments.map(S::lift)).cross(&v)
    }

    /// The left-hand side of the surface's equation, (N m)^2 (kg m^2)^2: Gamma times that of (7.11).
    pub fn surface<S: Over<P>>(&self, v: Vector3<S>) -> S {
        let (axis, weight, tilt) = (self.axis.map(S::lift), self.weight.map(S::lift), self.tilt(v));
        let lean = weight.dot(&tilt);
        let spin = S::lift(self.spin);
        lean * lean + spin * spin * v.dot(&axis.cross(&weight)) * axis.dot(&tilt)
    }

    /// Numerator and denominator of w0 = A' W (v.(l x Ge)) / (Ge.t), the angular velocity that belongs to a direction
    /// on the surface.
    pub fn speed<S: Over<P>>(&self, v: Vector3<S>) -> (S, S) {
        let (axis, weight) = (self.axis.map(S::lift), self.weight.map(S::lift));
        (S::lift(self.spin) * v.dot(&axis.cross(&weight)), weight.dot(&self.tilt(v)))
    }
}
