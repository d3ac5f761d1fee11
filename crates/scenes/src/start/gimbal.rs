//! Gimbal lock: quasi-velocities of a start that are impossible at its position.
//!
//! If the first and the last axis of three successive rotations coincide, their rates cause the same rotation, and some angular velocities
//! are impossible. A quasi-velocity of the start then depends on others at this position but is independent of them at neighbouring ones.

use super::RANK;
use super::constraints::Constraints;
use super::redundancy::Rows;

/// Size of the displacements in SI units.
const ASIDE: f64 = 0.1;

/// Number of displaced positions; independence at one of them is sufficient.
const PROBES: usize = 3;

impl Constraints {
    /// The row of the first quasi-velocity of the start that depends on constraints and other quasi-velocities at this state, but not at
    /// displaced ones.
    pub(super) fn locked(&self, state: &[f64], parameters: &[f64]) -> Option<usize> {
        let count = self.kept + self.started;
        let dependent = |state: &[f64]| {
            let jacobian = self.rows(&self.values(0.0, state, parameters), count);
            let is_finite = jacobian.iter().all(|entry| entry.is_finite());
            is_finite.then(|| Rows::of(0..count, &jacobian, RANK).dependent)
        };
        let here = dependent(state)?;
        let beside: Vec<Vec<usize>> = (0..PROBES).filter_map(|probe| dependent(&self.aside(state, probe))).collect();
        let is_locked = |row: &usize| *row >= self.kept && beside.iter().any(|dependent| !dependent.contains(row));
        here.into_iter().find(is_locked)
    }

    /// The state with every coordinate displaced by amounts of both signs and incommensurable ratios.
    fn aside(&self, state: &[f64], probe: usize) -> Vec<f64> {
        let mut moved = state.to_vec();
        for speed in 0..self.layout.speeds() {
            let part = ((probe * 17 + speed + 1) as f64 * 0.618_033_988_749_894_9).fract() * 2.0 - 1.0;
            self.layout.displace(&mut moved, (speed, 0), ASIDE * part);
        }
        moved
    }
}
