//! Shulgin's equations d/dt dT*/dw - X(T*) - lost = Q du/dw, with the kinetic energy T* after substitution of the
//! constraints.

use super::QuasiVelocities;
use crate::Trace;
use crate::equations::Characteristics;
use crate::principles::{NotApplicable, Projection};
use symbolic::Sym;

pub(super) fn residual(quasi: &QuasiVelocities<'_, '_>, trace: &Trace<'_>) -> Result<Vec<Sym>, NotApplicable> {
    if !quasi.programmed.is_empty() {
        return Err(NotApplicable("a programmed constraint need not hold along a motion".to_owned()));
    }
    let characteristics = Characteristics::of(trace, &quasi.met);
    let independent: Vec<Sym> = characteristics.independent.iter().map(|&place| trace.speeds[place]).collect();
    if independent != quasi.symbols {
        return Err(NotApplicable(
            "its equations stand along independent rates of coordinates, not along [speeds]".to_owned(),
        ));
    }
    Projection::Shulgin.residual(trace, &quasi.met, &characteristics)
}
