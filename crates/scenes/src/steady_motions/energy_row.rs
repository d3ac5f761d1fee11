//! The equation of steady motion that is redundant by conservation of energy, for systems with constraints of speeds.
//!
//! If independent speeds have no accelerations, the power of the residuals R_k is the rate of the energy T + V. In steady motion this rate is zero: V
//! does not depend on cyclic coordinates, and T cannot change at a constant rate since it is never negative. Therefore
//!
//!   sum_k R_k u_k = 0
//!
//! over the cyclic coordinates with independent speeds u_k, and an equation whose speed is not zero follows from the others.

use super::rows::Rows;
use crate::conservation::conserves;
use crate::letters::Letters;
use model::equations::vanishes;
use model::{Model, Trace};

/// The index of the redundant equation: that with the largest speed; `speed` gives the known speeds. `None` if energy is not conserved.
pub(super) fn implied(
    model: &Model,
    trace: &Trace<'_>,
    rows: &Rows,
    speed: impl Fn(usize) -> Option<f64>,
) -> Option<usize> {
    if rows.determined.is_empty() || model.energies.kinetic.is_some() || !conserves(model) {
        return None;
    }
    let state = [&trace.coordinates[..], &trace.speeds].concat();
    let energy = Letters::with_decimals(trace.time, &state).put_into(trace, &[trace.potential_energy()])[0];
    let n = trace.speeds.len();
    let is_level = (0..n).filter(|&k| rows.is_cyclic[k]).all(|k| vanishes(energy.diff(trace.coordinates[k])));
    let is_independent = |k: &usize| rows.is_cyclic[*k] && rows.determined.iter().all(|(place, _)| place != k);
    let moving =
        (0..n).filter(is_independent).filter_map(|k| Some((k, speed(k)?.abs()))).filter(|(_, size)| *size > 0.0);
    moving.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, _)| k).filter(|_| is_level)
}
