//! Integrals of motion that a machine conserves, determined from its laws.
//!
//! Let E be the energy of bodies, weight and circuits, and p = A' (w.l + phi') the rotor's angular momentum about its
//! axis. For every machine
//!
//!   d/dt (E - W p) = m(g', phi') g' - sum R_k i_k^2 + sum v_k i_k - W sum c_k i_k ,    dp/dt = M :
//!
//! since the field does no work in its own rotating frame. A rotor of prescribed speed conserves E - W p too, whatever
//! its torque.

use super::{Machine, RotorState, electrical_power, motional_torque, torque_and_current_rates};
use field::{Base, Circle, Over};

/// The integrals of motion that a machine conserves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conserved {
    /// The Jacobi integral E - W p.
    pub jacobi: bool,
    /// The rotor's angular momentum p.
    pub spin: bool,
}

/// Test points (slip, phi'), chosen without relation: a law that vanishes at all of them is zero.
const POINTS: [(f64, f64); 4] = [(1.0, 0.7), (-31.7, 12.9), (0.013, -211.0), (140.3, 3.1)];

impl Conserved {
    /// Determines the integrals that a machine conserves.
    pub fn by(machine: &impl Machine<f64>) -> Self {
        if machine.rotor() == RotorState::Prescribed {
            return Conserved { jacobi: true, spin: false };
        }
        let torque = |(slip, speed): (f64, f64)| machine.torque_law(slip, speed);
        let lossless = (0..machine.windings()).all(|k| machine.resistance(k) == 0.0);
        let frictionless = POINTS.into_iter().all(|point| torque(point) == 0.0);
        let currents = unrelated(machine);
        let fed = |(_, angle): (f64, f64)| feed(machine, Circle::from_half_tangent(angle), &currents);
        let unfed = POINTS.into_iter().all(|point| fed(point) == 0.0);
        Conserved {
            jacobi: lossless && frictionless && unfed,
            spin: POINTS.into_iter().all(|point| idle(machine, point)),
        }
    }
}

/// The power sum v_k i_k - W sum c_k i_k (W) of supply and sliding windings on E - W p.
pub(super) fn feed<P: Base, S: Over<P>>(machine: &impl Machine<P>, angle: Circle<S>, currents: &[S]) -> S {
    electrical_power(machine, angle, currents) - S::lift(machine.frame_speed()) * motional_torque(machine, currents)
}

fn unrelated(machine: &impl Machine<f64>) -> Vec<f64> {
    (0..machine.windings()).map(|k| 1.3 + k as f64).collect()
}

/// Whether the torque of the machine vanishes at this slip and angle, with unrelated currents.
fn idle(machine: &impl Machine<f64>, (slip, angle): (f64, f64)) -> bool {
    let currents = unrelated(machine);
    let mut rates = vec![0.0; currents.len()];
    let angle = Circle::from_half_tangent(angle);
    torque_and_current_rates(machine, angle, slip - machine.frame_speed(), &currents, &mut rates) == 0.0
}
