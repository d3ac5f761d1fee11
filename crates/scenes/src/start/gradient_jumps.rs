//! Constraints whose gradient jumps where they hold, as that of the norm of a vector at zero: grad |v| is the direction of v, which the zero
//! vector does not have. Rounding would choose it, and with it the reaction.

use super::Unmet;
use super::constraints::Constraints;
use model::equations::Level;

/// The size of displacements, in SI units: well above the residual of a completed start, and below every length of a mechanism.
const SIZE: f64 = 1e-9;

/// The number of displacements, each to both sides.
const PROBES: usize = 3;

/// A gradient that changes over them by more than this part of itself jumps.
const JUMP: f64 = 0.1;

/// The size of displacements at which the gradient has its usual size, in SI units.
const USUAL: f64 = 0.1;

/// A gradient below this part of its usual size vanishes, as at a singular position.
const SMALL: f64 = 1e-6;

impl Constraints {
    /// The first constraint that is kept and has no gradient at a state at which it holds.
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
            // parts that are no multiples of each other, of both signs
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
