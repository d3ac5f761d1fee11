//! The sampled states of a run, with cubic interpolation between them.

use crate::row_units::measured;
use crate::row_units::unit_of;
use crate::scene::ModelScene;
use model::Model;
use simulation::{Choice, Trajectory};

/// A state larger than this multiple of all states in the first half of a run counts as overflown.
const OVERFLOWN: f64 = 1e6;

/// A run was difficult if at least `REJECTED` steps, and at least the fraction `PART_REJECTED` of all steps, were rejected; normally the
/// step size control avoids rejections.
const REJECTED: u64 = 5;
const PART_REJECTED: f64 = 0.02;

/// A run with its sampled states.
pub(super) struct Samples<'a> {
    pub scene: &'a ModelScene,
    pub choice: &'a Choice,
    pub trajectory: &'a Trajectory,
    /// Times (s) and states (coordinates, then speeds, SI units); the last one is the last finite state.
    pub states: Vec<(f64, Vec<f64>)>,
    /// The number of states before an overflow.
    sound: usize,
}

impl<'a> Samples<'a> {
    pub fn of(scene: &'a ModelScene, choice: &'a Choice, trajectory: &'a Trajectory) -> Self {
        let n = scene.model.positions() + scene.model.speeds();
        let rows = trajectory.times.iter().copied().zip(trajectory.rows.iter().map(|row| row[..n].to_vec()));
        let last = (trajectory.outcome.time, trajectory.outcome.state[..n].to_vec());
        let mut states: Vec<(f64, Vec<f64>)> = rows.take_while(|(time, _)| *time < last.0).collect();
        states.push(last);
        states.retain(|(_, state)| state.iter().all(|part| part.is_finite()));
        let size = |(_, state): &(f64, Vec<f64>)| state.iter().fold(0.0, |size: f64, part| size.max(part.abs()));
        let first = states.iter().take(states.len().div_ceil(2)).map(size).fold(1.0, f64::max);
        let sound = states.iter().take_while(|state| size(state) <= OVERFLOWN * first).count();
        Samples { scene, choice, trajectory, states, sound }
    }

    pub fn model(&self) -> &Model {
        &self.scene.model
    }

    /// The states before an overflow, with their times.
    pub fn sound(&self) -> &[(f64, Vec<f64>)] {
        &self.states[..self.sound]
    }

    /// The time and the state at the end of the run.
    pub fn last(&self) -> (f64, &[f64]) {
        self.states.last().map_or((0.0, &[][..]), |(time, state)| (*time, state))
    }

    /// Whether the run was difficult: many steps were rejected, or the method lost an invariant.
    pub fn is_laborious(&self) -> bool {
        let work = self.trajectory.outcome.work;
        let is_lost = self.trajectory.outcome.deviations.iter().any(|one| one.lost.is_some());
        is_lost || (work.rejected >= REJECTED && work.rejected as f64 >= PART_REJECTED * work.steps as f64)
    }

    /// The step size in seconds: constant, or the mean of the steps that were made.
    pub fn step(&self) -> f64 {
        match self.choice.method.steps() {
            Some(steps) => self.scene.run.span / f64::from(steps),
            None => self.trajectory.outcome.time / self.trajectory.outcome.work.steps.max(1) as f64,
        }
    }

    /// Time and state at the fraction `part` between samples `k` and `k` + 1. Positions are interpolated by a cubic from the values and rates at
    /// both ends, speeds linearly.
    pub fn between(&self, k: usize, part: f64) -> (f64, Vec<f64>) {
        let [(from, a), (to, b)] = [&self.states[k], &self.states[k + 1]];
        let (h, n) = (to - from, self.model().positions());
        let s = part;
        // with free frames, speeds are not the rates of the coordinates
        let rate_of = |state: &[f64], place: usize| match n == self.model().speeds() {
            true => state[n + place],
            false => f64::NAN,
        };
        let state = (0..a.len()).map(|place| {
            let line = a[place] + s * (b[place] - a[place]);
            let [u, v] = [a, b].map(|state| if place < n { h * rate_of(state, place) } else { f64::NAN });
            let bend = s * (1.0 - s) * ((1.0 - s) * (u - b[place] + a[place]) - s * (v - b[place] + a[place]));
            if bend.is_finite() { line + bend } else { line }
        });
        (from + s * h, state.collect())
    }

    /// A component of the state with its name, value and unit: `theta = 1.570796 rad`.
    pub fn told(&self, place: usize, value: f64) -> String {
        let name = &self.model().state_names()[place].0;
        format!("`{name}` = {}", measured(value, &unit_of(self.model(), name)))
    }
}
