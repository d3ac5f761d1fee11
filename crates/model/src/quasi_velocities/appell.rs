//! The Gibbs-Appell equations dS/dw' = Q; the energy of accelerations S is a function of q, w and w'.

use super::QuasiVelocities;
use super::virtual_power::active;
use crate::Trace;
use crate::principles::appell::energy_of_accelerations;
use symbolic::Sym;

pub(super) fn residual(quasi: &QuasiVelocities<'_, '_>, trace: &Trace<'_>) -> Vec<Sym> {
    let energy = quasi.moved(energy_of_accelerations(trace));
    let inertia = quasi.accelerations.iter().map(|&acceleration| energy.diff(acceleration));
    inertia.zip(active(quasi, trace)).map(|(inertia, active)| inertia - active).collect()
}
