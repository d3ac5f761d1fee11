//! The equation that is redundant by conservation of energy, for systems with constraints of speeds.
//!
//! Without accelerations of independent speeds the power of the residuals is the rate of the energy T + V, which steady motion does not change:
//! V does not depend on cyclic coordinates, and T, which is never negative, would change at a constant rate forever. So
//!
//!   sum_k R_k u_k = 0
//!
//! over cyclic coordinates whose speeds are independent, and one equation whose speed is not zero follows from all others.

use super::rows::Rows;
use crate::conservation::conserves;
use crate::letters::Letters;
use model::equations::vanishes;
use model::{Model, Trace};

/// The place of that equation; some of the speeds are known.
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
