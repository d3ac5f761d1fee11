//! Bodies as clouds of mass points, integrated exactly.
//!
//! Every velocity and acceleration in a rigid body is affine in the place r of the mass point: integrals of products
//! need only the mass, the first moments and the matrix of second moments, neither Koenig's theorem nor an inertia
//! tensor.

use field::Scalar;
use nalgebra::{Matrix3, Vector3};

/// The moments up to second order of a distribution of mass about a point: integrals of dm, r dm and r r^T dm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassMoments<S: Scalar> {
    /// kg
    pub mass: S,
    /// kg m
    pub first: Vector3<S>,
    /// kg m^2
    pub second: Matrix3<S>,
}

/// A vector field affine in the place: u(r) = origin + gradient r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AffineField<S: Scalar> {
    pub origin: Vector3<S>,
    pub gradient: Matrix3<S>,
}

impl<S: Scalar> AffineField<S> {
    /// The place itself: u(r) = offset + r.
    pub fn place(offset: Vector3<S>) -> Self {
        AffineField { origin: offset, gradient: Matrix3::identity() }
    }

    /// w x u.
    pub fn turned(self, w: Vector3<S>) -> Self {
        let turn = cross_matrix(w);
        AffineField { origin: turn * self.origin, gradient: turn * self.gradient }
    }

    /// The part that depends on the place.
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
    /// A body from its inertia tensor about the point of reference: the second moments are tr(J)/2 - J.
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

    /// The inertia tensor about the point of reference, integral of (r.r 1 - r r^T) dm.
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

/// The matrix of w x (.).
pub fn cross_matrix<S: Scalar>(w: Vector3<S>) -> Matrix3<S> {
    let o = S::zero();
    Matrix3::new(o, -w.z, w.y, w.z, o, -w.x, -w.y, w.x, o)
}
