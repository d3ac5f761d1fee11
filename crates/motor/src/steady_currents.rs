//! The steady currents at a constant speed: R_k i_k + psi_k'(g) g' + c_k(i) phi' = v_k(g).
//!
//! The rates of the currents are affine in the currents: the law itself gives these linear equations.

use super::{Machine, torque_and_current_rates};
use field::{Base, Circle, Over, Tangent};

/// The steady currents (A) at constant angle and slip (rad/s). `None` where there is none or more than one solution, as
/// without resistance.
pub fn steady_currents<P: Base, S: Over<P>>(machine: &impl Machine<P>, angle: Circle<S>, slip: S) -> Option<Vec<S>> {
    let count = machine.windings();
    let (angle, slip) = (angle.map(Tangent::fixed), Tangent::fixed(slip));
    let rates = |varied: Option<usize>| {
        let current = |k| if varied == Some(k) { Tangent::variable(S::zero()) } else { Tangent::fixed(S::zero()) };
        let currents: Vec<Tangent<S>> = (0..count).map(current).collect();
        let mut rates = vec![Tangent::fixed(S::zero()); count];
        torque_and_current_rates(machine, angle, slip, &currents, &mut rates);
        rates
    };
    let mut right: Vec<S> = rates(None).into_iter().map(|rate| -rate.value).collect();
    if right.iter().all(S::is_zero) {
        return Some(right);
    }
    let columns: Vec<Vec<S>> =
        (0..count).map(|j| rates(Some(j)).into_iter().map(|rate| rate.slope).collect()).collect();
    let mut rows: Vec<Vec<S>> = (0..count).map(|k| columns.iter().map(|column| column[k]).collect()).collect();
    for k in 0..count {
        let pivot = (k..count).find(|&row| !rows[row][k].is_zero());
        let Some(pivot) = pivot else {
            // the current of a winding without voltage and resistance stays zero
            if right[k].is_zero() && rows[k].iter().all(S::is_zero) {
                continue;
            }
            return None;
        };
        rows.swap(k, pivot);
        right.swap(k, pivot);
        let (own, known) = (rows[k].clone(), right[k]);
        for row in (0..count).filter(|&row| row != k) {
            let factor = rows[row][k] / own[k];
            if !factor.is_zero() {
                rows[row].iter_mut().zip(&own).for_each(|(entry, &own)| *entry -= factor * own);
                right[row] -= factor * known;
            }
        }
    }
    let resting = |k: usize| if right[k].is_zero() { S::zero() } else { right[k] / rows[k][k] };
    Some((0..count).map(resting).collect())
}
