//! Constraints whose gradient is discontinuous where they hold, such as |v| = 0: grad |v| is the direction of v, which is undefined at zero, so
//! that rounding would determine the reaction.

use super::Unmet;
use super::constraints::Constraints;
use model::equations::Level;

/// Size of the displacements in SI units: far above the residual of a completed start, far below the lengths of a mechanism.
const SIZE: f64 = 1e-9;

/// Number of displacements; each is applied with both signs.
const PROBES: usize = 3;

/// The gradient is discontinuous if it changes by more than this fraction between opposite displacements.
const JUMP: f64 = 0.1;

/// Size of the displacements at which the gradient is taken as usual, in SI units.
const USUAL: f64 = 0.1;

/// A gradient below this fraction of the usual one is zero, as at a singular position.
const SMALL: f64 = 1e-6;

impl Constraints {
    /// The first enforced constraint without a continuous gradient at a state at which it holds.
    pub(super) fn without_gradient(&self, state: &[f64], parameters: &[f64]) -> Option<Unmet> {
        let row = (0..self.kept).find(|&row| self.jumps(row, state, parameters))?;
        Some(Unmet::Jumping { at: self.known[row].at.clone(), name: self.known[row].title.clone() })
    }

    fn jumps(&self, row: usize, state: &[f64], parameters: &[f64]) -> bool {
        let order = usize::from(self.known[row].level == Level::Speed);
        let n = self.layout.speeds();
        let gradient = |state: &[f64]| self.rows(&self.values(0.0, state, parameters), self.kept).row(row).transpose();
        if !gradient(state).iter().all(|slope| slope.is_finite()) {
            return true;
        }
        let beside = |probe: usize, by: f64| {
            // incommensurable amounts of both signs
            let part = |place: usize| ((probe * 13 + place + 1) as f64 * 0.618_033_988_749_894_9).fract() * 2.0 - 1.0;
            let mut moved = state.to_vec();
            (0..n).for_each(|speed| self.layout.displace(&mut moved, (speed, order), by * part(speed)));
            gradient(&moved)
        };
        let usual = (0..PROBES).map(|probe| beside(probe, USUAL).norm()).fold(0.0, f64::max);
        (0..PROBES).any(|probe| {
            let [one, other] = [beside(probe, SIZE), beside(probe, -SIZE)];
            let size = one.norm().max(other.norm());
            size > SMALL * usual && (&one - &other).norm() > JUMP * size
        })
    }
}
