//! The sampled states of a run, with cubic interpolation between them.

use crate::row_units::measured;
use crate::row_units::unit_of;
use crate::scene::ModelScene;
use model::Model;
use simulation::{Choice, Trajectory};

/// A state that is larger than all in the first half of a run by this factor is none to look at coordinates in.
const OVERFLOWN: f64 = 1e6;

/// From so many rejected steps on, and from this part of all steps on, a run was held up by something: the control of the step foresees most of
/// what would be rejected.
const REJECTED: u64 = 5;
const PART_REJECTED: f64 = 0.02;

/// A run with its states alone.
pub(super) struct Samples<'a> {
    pub scene: &'a ModelScene,
    pub choice: &'a Choice,
    pub trajectory: &'a Trajectory,
    /// Times and states, the last good one at the end.
    pub states: Vec<(f64, Vec<f64>)>,
    /// The number of these, from the first on, whose size is no overflow.
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

    /// The states before an overflow.
    pub fn sound(&self) -> &[(f64, Vec<f64>)] {
        &self.states[..self.sound]
    }

    /// The last good state with its time.
    pub fn last(&self) -> (f64, &[f64]) {
        self.states.last().map_or((0.0, &[][..]), |(time, state)| (*time, state))
    }

    /// Whether many steps were rejected, or the energy was lost: something on the way was hard.
    pub fn is_laborious(&self) -> bool {
        let work = self.trajectory.outcome.work;
        let is_lost = self.trajectory.outcome.deviations.iter().any(|one| one.lost.is_some());
        is_lost || (work.rejected >= REJECTED && work.rejected as f64 >= PART_REJECTED * work.steps as f64)
    }

    /// The length of a step: of all, or the mean of those that were made.
    pub fn step(&self) -> f64 {
        match self.choice.method.steps() {
            Some(steps) => self.scene.run.span / f64::from(steps),
            None => self.trajectory.outcome.time / self.trajectory.outcome.work.steps.max(1) as f64,
        }
    }

    /// A state between sample `k` and the next, at a part of the way from 0 to 1: positions on the cubic by their rates at both ends.
    pub fn between(&self, k: usize, part: f64) -> (f64, Vec<f64>) {
        let [(from, a), (to, b)] = [&self.states[k], &self.states[k + 1]];
        let (h, n) = (to - from, self.model().positions());
        let s = part;
        // a free frame has more coordinates than speeds: its rates are not those of the state
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

    /// `theta = 1.570796 rad`, of a coordinate or a speed by its place in the state.
    pub fn told(&self, place: usize, value: f64) -> String {
        let name = &self.model().state_names()[place].0;
        format!("`{name}` = {}", measured(value, &unit_of(self.model(), name)))
    }
}
