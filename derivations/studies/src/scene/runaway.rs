//! Warnings on a run: torque laws that brake in one direction and accelerate in the other.

use super::Scene;
use super::state::ROTOR_SPEED;
use motor::{Driven, runaway};
use simulation::Trajectory;

impl Scene {
    /// Warnings for torque laws that accelerate the rotor increasingly in a direction; each states whether the run
    /// reaches these speeds.
    pub(super) fn runs_away(&self, trajectory: &Trajectory) -> impl Iterator<Item = String> + use<> {
        let column = trajectory.column(ROTOR_SPEED);
        let rows: Vec<f64> =
            trajectory.rows.iter().chain([&trajectory.last]).filter_map(|row| Some(row[column?])).collect();
        let names = [("backwards", f64::min as fn(f64, f64) -> f64), ("forwards", f64::max)];
        let found = runaway(&self.machine).into_iter().zip(names);
        found.filter_map(move |(driven, (direction, farthest))| {
            let Driven { beyond, power, at } = driven?;
            let reached = rows.iter().copied().fold(0.0, farthest);
            let run = match reached.abs() > beyond.abs() {
                false => "this run does not turn so".to_owned(),
                true => format!("this run does, at up to {:.4} rad/s", reached.abs()),
            };
            let faster = if beyond == 0.0 { String::new() } else { format!(" faster than {:.4} rad/s", beyond.abs()) };
            Some(format!(
                "the torque law drives a rotor that turns {direction}{faster}, ever harder: {power:.4} W at phi' = {at:.4} rad/s; {run}. \
                 A law that brakes in both directions is odd in phi', as -c*phi'^3 is"
            ))
        })
    }
}
