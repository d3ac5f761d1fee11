//! Rotations of a rigid body: rotation matrices, coordinates of SO(3), and angular velocity.

use crate::differentiate::{along, unit};
use field::{Analytic, Circle, Scalar, Tangent};
use nalgebra::{Matrix3, Vector3};

/// The rotation matrix of Euler angles in rad (precession, nutation, spin; axes 3-1-3). Its columns are the body's axes
/// in space.
pub fn euler<S: Analytic>([precession, nutation, spin]: [S; 3]) -> Matrix3<S> {
    about_third(precession.circle()) * about_first(nutation.circle()) * about_third(spin.circle())
}

/// The rotation matrix of a quaternion, which need not be normalised: a rational map onto SO(3).
pub fn quaternion<S: Scalar>([a, b, c, d]: [S; 4]) -> Matrix3<S> {
    let norm = a * a + b * b + c * c + d * d;
    let two = S::int(2);
    Matrix3::new(
        a * a + b * b - c * c - d * d,
        two * (b * c - a * d),
        two * (b * d + a * c),
        two * (b * c + a * d),
        a * a - b * b + c * c - d * d,
        two * (c * d - a * b),
        two * (b * d - a * c),
        two * (c * d + a * b),
        a * a - b * b - c * c + d * d,
    ) / norm
}

/// The angular velocity w in body components, from the rotation matrix R along the motion: `[w]` = R^T R'.
pub fn angular_velocity<S: Scalar>(rotation: Matrix3<Tangent<S>>) -> Vector3<S> {
    let turn = rotation.map(|x| x.value).transpose() * rotation.map(|x| x.slope);
    Vector3::new(turn[(2, 1)], turn[(0, 2)], turn[(1, 0)])
}

/// The matrix W(q) of Euler angles with w = W q' in body components. Singular where the sine of the nutation is zero.
pub fn euler_forms<S: Analytic>(angles: [S; 3]) -> Matrix3<S> {
    let columns: [Vector3<S>; 3] = std::array::from_fn(|i| angular_velocity(euler(along(angles, unit(i)))));
    Matrix3::from_columns(&columns)
}

/// The vertical of space (third axis) in body components.
pub fn vertical<S: Scalar>(rotation: &Matrix3<S>) -> Vector3<S> {
    rotation.row(2).transpose()
}

/// The components of a space-fixed vector in axes rotated about their k-th axis (0, 1, 2) by twice the given angle.
///
/// By half the angle: a rounding error c^2 + s^2 = 1 + d then changes the length relatively by 2 s^2 d only, which
/// decreases with the angle (Vilmart 2008 on rounding in rigid body integrators).
#[inline]
pub fn turned_about<S: Scalar>(mut v: Vector3<S>, k: usize, half: Circle<S>) -> Vector3<S> {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let twice = half.sin + half.sin;
    let (a, b) = (v[i], v[j]);
    v[i] = a + twice * (half.cos * b - half.sin * a);
    v[j] = b - twice * (half.cos * a + half.sin * b);
    v
}

/// As [`turned_about`], for rotation about any unit vector.
#[inline]
pub fn turned_along<S: Scalar>(v: Vector3<S>, unit: Vector3<S>, half: Circle<S>) -> Vector3<S> {
    let across = unit.cross(&v);
    v + (unit.cross(&across) * half.sin - across * half.cos) * (half.sin + half.sin)
}

/// The inverse, by the adjugate and the determinant, without pivoting.
pub fn inverse<S: Scalar>(m: &Matrix3<S>) -> Matrix3<S> {
    adjugate(m) / determinant(m)
}

/// The adjugate: m adj(m) = det(m).
pub fn adjugate<S: Scalar>(m: &Matrix3<S>) -> Matrix3<S> {
    let (a, b, c) = (m.row(0).transpose(), m.row(1).transpose(), m.row(2).transpose());
    Matrix3::from_columns(&[b.cross(&c), c.cross(&a), a.cross(&b)])
}

/// The determinant as a triple product.
pub fn determinant<S: Scalar>(m: &Matrix3<S>) -> S {
    m.column(0).dot(&m.column(1).cross(&m.column(2)))
}

fn about_third<S: Scalar>(p: Circle<S>) -> Matrix3<S> {
    let (o, l) = (S::zero(), S::one());
    Matrix3::new(p.cos, -p.sin, o, p.sin, p.cos, o, o, o, l)
}

fn about_first<S: Scalar>(p: Circle<S>) -> Matrix3<S> {
    let (o, l) = (S::zero(), S::one());
    Matrix3::new(l, o, o, o, p.cos, -p.sin, o, p.sin, p.cos)
}
