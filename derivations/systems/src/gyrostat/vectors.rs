//! Operations on vectors over any scalar type, always inlined: those of nalgebra are not inlined for batches, and a
//! function call would leave the code compiled for wide registers. Products and sums are fused (one rounding) if the
//! scalar type does this.

use field::{Over, Scalar};
use nalgebra::Vector3;

/// The scalar product a . b.
#[inline(always)]
pub(super) fn dot<S: Scalar>(a: Vector3<S>, b: Vector3<S>) -> S {
    (a[0] * b[0]).and_product(a[1], b[1]).and_product(a[2], b[2])
}

/// The difference s - a.b; summation begins at both ends, so that fewer operations depend on each other.
#[inline(always)]
pub(super) fn less_dot<S: Scalar>(s: S, a: Vector3<S>, b: Vector3<S>) -> S {
    s.less_product(a[0], b[0]) - (a[1] * b[1]).and_product(a[2], b[2])
}

/// The vector product a x b.
#[inline(always)]
pub(super) fn cross<S: Scalar>(a: Vector3<S>, b: Vector3<S>) -> Vector3<S> {
    each(|i| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        (a[j] * b[k]).less_product(a[k], b[j])
    })
}

/// The sum a x b + c x d, with the two products computed separately: the momentum a is available last, and so only few
/// operations depend on it.
#[inline(always)]
pub(super) fn two_crosses<S: Scalar>(a: Vector3<S>, b: Vector3<S>, c: Vector3<S>, d: Vector3<S>) -> Vector3<S> {
    let (first, second) = (cross(a, b), cross(c, d));
    each(|i| first[i] + second[i])
}

/// The componentwise product (a1 b1, a2 b2, a3 b3).
#[inline(always)]
pub(super) fn by_component<S: Scalar>(a: Vector3<S>, b: Vector3<S>) -> Vector3<S> {
    each(|i| a[i] * b[i])
}

/// The sum a + b s.
#[inline(always)]
pub(super) fn plus<S: Scalar>(a: Vector3<S>, b: Vector3<S>, s: S) -> Vector3<S> {
    each(|i| a[i].and_product(b[i], s))
}

/// The difference a - b s.
#[inline(always)]
pub(super) fn less<S: Scalar>(a: Vector3<S>, b: Vector3<S>, s: S) -> Vector3<S> {
    each(|i| a[i].less_product(b[i], s))
}

/// The vector converted to another scalar type.
#[inline(always)]
pub(super) fn lift<P: Scalar, S: Over<P>>(a: Vector3<P>) -> Vector3<S> {
    each(|i| S::lift(a[i]))
}

#[inline(always)]
fn each<S: Scalar>(component: impl Fn(usize) -> S) -> Vector3<S> {
    Vector3::new(component(0), component(1), component(2))
}
