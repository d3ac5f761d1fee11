//! Maggi's equations, Lagrange's equations projected onto du/dw: sum (d/dt dT/du_i - dT/dq_i - Q_i) du_i/dw_r = 0.

use super::QuasiVelocities;
use crate::Trace;
use crate::principles::{NotApplicable, Principle};
use symbolic::Sym;

pub(super) fn residual(quasi: &QuasiVelocities<'_, '_>, trace: &Trace<'_>) -> Result<Vec<Sym>, NotApplicable> {
    let lagrange = Principle::Lagrange.residual(trace)?;
    Ok(quasi.along(&quasi.by_quasi_velocities(&lagrange)))
}
