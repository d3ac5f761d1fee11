//! A Lyapunov function V that decides whether a rotor is synchronous: V never increases, and the regions below its
//! saddles are invariant.
//!
//! In the frame of the stator's field, with the potential of the constant torque P = load - m(0, W) that acts at
//! synchronism,
//!
//!   V = 1/2 A' g'^2 + U(g) + sum 1/2 L_k i_k^2 + P g ,    dV/dt = g' (m(g', g' + W) - m(0, W)) - sum R_k i_k^2 .
//!
//! If the torque law m decreases with the speed, as that of friction does, V never increases. A motion between two
//! neighbouring unstable equilibrium angles, with V less than at either of them, remains between them and tends to an
//! equilibrium: it is synchronous from then on (LaSalle's invariance principle).

use super::loaded::Loaded;
use crate::stationary::motor::{MotorStates, NoMotor};
use field::{Analytic, Base, Over};
use motor::{Bench, Machine};
use std::f64::consts::TAU;

/// The function V, J, up to a constant, at a state of a motor on a bench under a load.
pub fn height<P: Base, S: Over<P> + Analytic, M: Machine<P>>(bench: &Bench<P, M>, load: S, state: &[S]) -> S {
    let field_speed = S::lift(bench.machine.frame_speed());
    let drag = load - bench.machine.torque_law(S::zero(), field_speed);
    bench.jacobi(state) + drag * state[0]
}

/// The potential wells of a rotor under a load: each lies between two neighbouring unstable equilibrium angles. The
/// values of V at these angles are stored.
#[derive(Clone, Debug, PartialEq)]
pub struct Wells {
    /// The unstable equilibria (angle, V) within one turn, in ascending order of the angle.
    tops: Vec<(f64, f64)>,
    /// The change of V over one turn, J.
    rise: f64,
}

impl Wells {
    /// The wells under a load, N m.
    ///
    /// # Errors
    /// [`NoMotor`] if the motor's steady states are not known.
    pub fn of(motor: &Loaded, load: f64) -> Result<Self, NoMotor> {
        let angles = match MotorStates::under(&motor.machine, load)? {
            MotorStates::InStep { angles, .. } => angles,
            _ => Vec::new(),
        };
        let at = |angle: f64| {
            let mut state = vec![0.0; motor.facts.sizes.len()];
            (state[0], *state.last_mut().unwrap_or(&mut 0.0)) = (angle, load);
            motor.own.height(&state)
        };
        let mut tops: Vec<(f64, f64)> = angles
            .iter()
            .filter(|angle| angle.slope >= 0)
            .map(|angle| (angle.radians(), at(angle.radians())))
            .collect();
        tops.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(Wells { tops, rise: at(TAU) - at(0.0) })
    }

    /// Whether a state with this angle and V = `height` lies below both neighbouring maxima: the motion is then
    /// synchronous from there on.
    pub fn hold(&self, angle: f64, height: f64) -> bool {
        let Some(first) = self.tops.first() else { return false };
        let turns = ((angle - first.0) / TAU).floor();
        let inside = angle - TAU * turns;
        let below = self.tops.iter().rev().find(|top| top.0 <= inside).unwrap_or(first);
        let above = self.tops.iter().find(|top| top.0 > inside).copied();
        let above = above.map_or(first.1 + self.rise, |top| top.1);
        height - turns * self.rise < below.1.min(above)
    }
}
