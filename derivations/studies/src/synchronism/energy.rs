//! A Lyapunov function that decides whether a rotor is synchronous: V never grows, and its wells are invariant.
//!
//! In the frame of the stator's field, with the potential of the drag P = load - m(0, W) that the motor has at synchronism,
//!
//!   V = 1/2 A' g'^2 + U(g) + sum 1/2 L_k i_k^2 + P g ,    dV/dt = g' (m(g', g' + W) - m(0, W)) - sum R_k i_k^2 .
//!
//! If the torque law m decreases with the speed, as friction does, V never grows. Between two neighbouring unstable equilibrium angles,
//! a motion with less V than at either of them stays between them and tends to an equilibrium: it is synchronous for ever
//! (LaSalle's invariance principle).

use super::loaded::Loaded;
use crate::stationary::motor::{MotorStates, NoMotor};
use field::{Analytic, Base, Over};
use motor::{Bench, Machine};
use std::f64::consts::TAU;

/// V at a state of a bench under a load, up to a constant, J.
pub fn height<P: Base, S: Over<P> + Analytic, M: Machine<P>>(bench: &Bench<P, M>, load: S, state: &[S]) -> S {
    let field_speed = S::lift(bench.machine.frame_speed());
    let drag = load - bench.machine.torque_law(S::zero(), field_speed);
    bench.jacobi(state) + drag * state[0]
}

/// The potential wells of a rotor under a load, each between two neighbouring unstable equilibrium angles, with V at these.
#[derive(Clone, Debug, PartialEq)]
pub struct Wells {
    /// (angle, V), in one turn, the least angle first.
    tops: Vec<(f64, f64)>,
    /// The change of V over a turn, J.
    rise: f64,
}

impl Wells {
    /// The wells under a load, N m.
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

    /// Whether V = `height` at an angle is less than at both neighbouring tops: the motion is synchronous for ever.
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
