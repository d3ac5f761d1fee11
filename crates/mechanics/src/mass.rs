//! Mass distributions, integrated exactly.
//!
//! Every velocity and acceleration of a rigid body is affine in the position r of the mass point. Integrals of products
//! therefore need only the mass, the first moments and the matrix of second moments.

use field::Scalar;
use nalgebra::{Matrix3, Vector3};

/// The moments of a mass distribution about a point up to second order: the integrals of dm, r dm and r r^T dm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassMoments<S: Scalar> {
    /// The mass, kg.
    pub mass: S,
    /// The first moments, kg m.
    pub first: Vector3<S>,
    /// The second moments, kg m^2.
    pub second: Matrix3<S>,
}

/// A vector field affine in the position: u(r) = origin + gradient r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AffineField<S: Scalar> {
    pub origin: Vector3<S>,
    pub gradient: Matrix3<S>,
}

impl<S: Scalar> AffineField<S> {
    /// The position field u(r) = offset + r.
    pub fn place(offset: Vector3<S>) -> Self {
        AffineField { origin: offset, gradient: Matrix3::identity() }
    }

    /// The field w x u.
    pub fn turned(self, w: Vector3<S>) -> Self {
        let turn = cross_matrix(w);
        AffineField { origin: turn * self.origin, gradient: turn * self.gradient }
    }

    /// The field without its constant part.
    pub fn relative(self) -> Self {
        AffineField { origin: Vector3::zeros(), gradient: self.gradient }
    }
}

impl<S: Scalar> std::ops::Add for AffineField<S> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        AffineField { origin: self.origin + b.origin, gradient: self.gradient + b.gradient }
    }
}

impl<S: Scalar> MassMoments<S> {
    /// A body from its mass, centre of mass and inertia tensor J about the reference point: the second moments are
    /// tr(J)/2 - J.
    pub fn from_inertia(mass: S, centre: Vector3<S>, inertia: Matrix3<S>) -> Self {
        let second = Matrix3::identity() * inertia.trace().half() - inertia;
        MassMoments { mass, first: centre * mass, second }
    }

    /// The integral of u.v dm.
    pub fn dot(&self, u: &AffineField<S>, v: &AffineField<S>) -> S {
        self.dyad(u, v).trace()
    }

    /// The integral of u x v dm.
    pub fn cross(&self, u: &AffineField<S>, v: &AffineField<S>) -> Vector3<S> {
        let d = self.dyad(u, v);
        Vector3::new(d[(1, 2)] - d[(2, 1)], d[(2, 0)] - d[(0, 2)], d[(0, 1)] - d[(1, 0)])
    }

    /// The inertia tensor about the reference point, integral of (r.r 1 - r r^T) dm, kg m^2.
    pub fn inertia(&self) -> Matrix3<S> {
        Matrix3::identity() * self.second.trace() - self.second
    }

    /// The integral of u v^T dm.
    fn dyad(&self, u: &AffineField<S>, v: &AffineField<S>) -> Matrix3<S> {
        u.origin * v.origin.transpose() * self.mass
            + u.origin * (v.gradient * self.first).transpose()
            + u.gradient * self.first * v.origin.transpose()
            + u.gradient * self.second * v.gradient.transpose()
    }
}

/// The matrix of the map u -> w x u.
pub fn cross_matrix<S: Scalar>(w: Vector3<S>) -> Matrix3<S> {
    let o = S::zero();
    Matrix3::new(o, -w.z, w.y, w.z, o, -w.x, -w.y, w.x, o)
}
