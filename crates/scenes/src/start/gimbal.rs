//! Gimbal lock: quasi-velocities of a start that are impossible in its position.
//!
//! If the first and the last of three turns have one axis, their rates turn the body in the same way, and no rates give an angular velocity
//! in a certain direction. A quasi-velocity of the start then depends on others in this position, but is independent of them in neighbouring
//! positions.

use super::RANK;
use super::constraints::Constraints;
use super::redundancy::Rows;

/// The size of a displacement, in SI units.
const ASIDE: f64 = 0.1;

/// Displaced positions, one of which must tell.
const PROBES: usize = 3;

impl Constraints {
    /// The first quasi-velocity of the start, by its row, that depends on constraints and others of the start here, and not in positions
    /// beside.
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

    /// Another position: every coordinate displaced, by parts that are no multiples of each other, to both sides.
    fn aside(&self, state: &[f64], probe: usize) -> Vec<f64> {
        let mut moved = state.to_vec();
        for speed in 0..self.layout.speeds() {
            let part = ((probe * 17 + speed + 1) as f64 * 0.618_033_988_749_894_9).fract() * 2.0 - 1.0;
            self.layout.displace(&mut moved, (speed, 0), ASIDE * part);
        }
        moved
    }
}
