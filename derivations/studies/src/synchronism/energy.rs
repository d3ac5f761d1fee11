//! The energy that decides whether the field has the rotor: it never grows, and wells of it hold whoever is in one.
//!
//! Seen from the stator's field, with the potential of the drag P = load - m(0, W) that the motor has at synchronism,
//!
//!   V = 1/2 A' g'^2 + U(g) + sum 1/2 L_k i_k^2 + P g ,    dV/dt = g' (m(g', g' + W) - m(0, W)) - sum R_k i_k^2 .
//!
//! Where the law m falls with the speed, as friction does, V never grows. Between two neighbouring angles at which the
//! rotor could balance, a motion with less V than at either of them stays between them for ever and comes to rest there:
//! it is in step, whatever it does meanwhile (LaSalle).

use super::loaded::Loaded;
use crate::stationary::motor::{MotorStates, NoMotor};
use field::{Analytic, Base, Over};
use motor::{Bench, Machine};
use std::f64::consts::TAU;

/// V at a state of a bench under a load, but for a constant, J.
pub fn height<P: Base, S: Over<P> + Analytic, M: Machine<P>>(bench: &Bench<P, M>, load: S, state: &[S]) -> S {
    let field_speed = S::lift(bench.machine.frame_speed());
    let drag = load - bench.machine.moment_law(S::zero(), field_speed);
    bench.jacobi(state) + drag * state[0]
}

/// The angles at which a rotor under a load balances on the field, with V at each: from one to the next a well.
#[derive(Clone, Debug, PartialEq)]
pub struct Wells {
    /// (angle, V), in one turn, the least angle first.
    tops: Vec<(f64, f64)>,
    /// By how much V rises in a turn.
    rise: f64,
}

impl Wells {
    /// Under a load, N m.
    ///
    /// # Errors
    /// [`NoMotor`].
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

    /// Whether V = `height` at an angle is less than at both neighbouring tops: the motion is in step for ever.
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
