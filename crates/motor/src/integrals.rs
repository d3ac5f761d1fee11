//! Integrals of motion that a machine preserves, found from its laws.
//!
//! With E the energy of bodies, weight and circuits and p = A' (w.l + phi') the rotor's angular momentum about its axis,
//! every machine gives
//!
//!   d/dt (E - W p) = m(g', phi') g' - sum R_k i_k^2 + sum v_k i_k - W sum c_k i_k ,    dp/dt = M :
//!
//! seen from the turning field the field does no work. A rotor of prescribed speed keeps E - W p too, whatever torque
//! is needed for it.

use super::{Machine, RotorState, electrical_power, motional_torque, torque_and_current_rates};
use field::{Base, Circle, Over};

/// The integrals that a machine preserves, beside those that no machine changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conserved {
    /// E - W p, the energy in the turning field.
    pub jacobi: bool,
    /// p, the rotor's own angular momentum.
    pub spin: bool,
}

/// (slip, phi'): unrelated points; a law that is not zero everywhere does not vanish at all of them.
const POINTS: [(f64, f64); 4] = [(1.0, 0.7), (-31.7, 12.9), (0.013, -211.0), (140.3, 3.1)];

impl Conserved {
    /// Finds the integrals that a machine preserves.
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

/// sum v_k i_k - W sum c_k i_k, W: the power that supply and sliding windings put into E - W p.
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
