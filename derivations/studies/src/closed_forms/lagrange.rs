//! Lagrange's top with a rotor along its axis k.
//!
//! With the transverse moment of inertia A, the weight G along the axis (positive where it points along e_k), and the integrals
//! X = A_k w_k + p (momentum along the axis), c = A (w_i v_i + w_j v_j) + X u, h = A (w_i^2 + w_j^2)/2 - G u and n = v.v,
//! u = v_k obeys
//!
//!   A^2 u'^2 = 2 A (h + G u)(n - u^2) - (c - X u)^2 .

use super::{ClosedForm, Quadrature, Start};
use integrators::Real;

/// The closed form of v along the axis; `None` without symmetry, without weight, or with weight off the axis.
pub fn solution<S: Real>(start: &Start<S>) -> Option<ClosedForm<S>> {
    let [i, j, k] = start.indices();
    let (w, v, zero) = (start.w, start.v, S::zero());
    let (a, weight) = (start.moments[i], start.weight[k]);
    let symmetric = a == start.moments[j] && start.weight[i] == zero && start.weight[j] == zero;
    if !symmetric || weight == zero {
        return None;
    }
    let (u, two) = (v[k], S::int(2));
    let spin = start.moments[k] * w[k] + start.spin();
    let c = a * (w[i] * v[i] + w[j] * v[j]) + spin * u;
    let h = a * (w[i] * w[i] + w[j] * w[j]).half() - weight * u;
    let n = v.dot(&v);
    let times_a_squared = [
        two * a * h * n - c * c,
        two * a * weight * n + two * c * spin,
        -(two * a * h) - spin * spin,
        -(two * a * weight),
        zero,
    ];
    Some(ClosedForm {
        name: "Lagrange's, of v along the axis",
        shown: start.component(3),
        motion: Quadrature::new(times_a_squared.map(|f| f / (a * a)), u, v[i] * w[j] - v[j] * w[i]),
    })
}
