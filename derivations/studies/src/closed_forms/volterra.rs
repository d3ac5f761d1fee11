//! The gyrostat of Zhukovskii and Volterra, with its rotor along the principal axis k.
//!
//! With the principal moments A of the first form and the constant rotor momentum p, the momentum x = A w + p e_k has
//! constant length, x.x = g, and the energy A w.w = h is constant. Hence with u = w_k
//!
//!   A_i (A_i - A_j) w_i^2 = g - (A_k u + p)^2 - A_j (h - A_k u^2) =: n_i ,
//!   A_j (A_i - A_j) w_j^2 = A_i (h - A_k u^2) - g + (A_k u + p)^2 =: n_j ,    A_k u' = (A_i - A_j) w_i w_j :
//!
//!   u'^2 = n_i n_j / (A_i A_j A_k^2) .

use super::{ClosedForm, Quadrature, Start};
use integrators::Real;

/// The closed form of w along the rotor; `None` with weight, or for a body with symmetry about the rotor's axis, where
/// this component is constant.
pub fn solution<S: Real>(start: &Start<S>) -> Option<ClosedForm<S>> {
    let [i, j, k] = start.indices();
    let (a, w, p) = (start.moments, start.w, start.spin());
    if start.weight.iter().any(|weight| *weight != S::zero()) || a[i] == a[j] {
        return None;
    }
    let x = w.component_mul(&a);
    let along = x[k] + p;
    let g = x[i] * x[i] + x[j] * x[j] + along * along;
    let h = w.dot(&x);
    // polynomials in u, the lowest power first
    let square = [p * p, S::int(2) * a[k] * p, a[k] * a[k]];
    let rest = [h, S::zero(), -a[k]];
    let one: [S; 3] = std::array::from_fn(|n| if n == 0 { g } else { S::zero() } - square[n] - a[j] * rest[n]);
    let other: [S; 3] = std::array::from_fn(|n| a[i] * rest[n] - if n == 0 { g } else { S::zero() } + square[n]);
    let mut f = [S::zero(); 5];
    for (n, one) in one.iter().enumerate() {
        for (m, other) in other.iter().enumerate() {
            f[n + m] += *one * *other / (a[i] * a[j] * a[k] * a[k]);
        }
    }
    let speed = (a[i] - a[j]) * w[i] * w[j] / a[k];
    Some(ClosedForm {
        name: "Zhukovskii and Volterra's, of w along the rotor",
        shown: start.component(0),
        motion: Quadrature::new(f, w[k], speed),
    })
}
