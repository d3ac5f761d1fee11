//! Constraints with multiple roots: the gradient vanishes where they hold, as 2 g grad g of f = g^2, and no reaction can enforce them.
//!
//! A start satisfies f up to rounding, so the gradient there is of the order of the root of a rounding error: small, but not zero. To
//! distinguish such a constraint from one at a singular position, Newton's method is applied to f alone, from displaced states. It halves g in
//! each step, and
//!
//!   |grad f| / |grad f0| = (f / f0)^(1/2)    of a double root, and less of a higher one,
//!
//! where the gradient at a simple root stays.

use super::constraints::Constraints;
use super::{MOST_STEPS, RANK, Unmet};
use model::equations::Level;
use nalgebra::DVector;

/// A gradient at the start above this part of the largest beside it is none that vanishes.
const SMALL: f64 = 3e-2;

/// States beside the start from which zeros are sought.
const PROBES: usize = 5;

/// A state whose gradient is below this part of the largest one lies by chance where f is small, and tells nothing.
const TELLING: f64 = 0.1;

/// The size of a displacement, in SI units.
const SIZE: f64 = 0.1;

/// A zero is found where f is below this part of its value at the displaced state; a zero at all, below the root of this.
const FOUND: f64 = 1e-12;

/// A gradient may be so many times what the law of a double root gives: f is no pure square.
const SLACK: f64 = 10.0;

/// A constraint with its gradient at a state.
struct Beside {
    state: Vec<f64>,
    value: f64,
    gradient: DVector<f64>,
}

impl Constraints {
    /// The first constraint that is kept and whose gradient vanishes at all its zeros beside a state.
    pub(super) fn with_multiple_root(&self, state: &[f64], parameters: &[f64]) -> Option<Unmet> {
        let rows = self.rows(&self.values(0.0, state, parameters), self.kept);
        let norms: Vec<f64> = rows.row_iter().map(|row| row.norm()).collect();
        let largest = norms.iter().copied().fold(0.0, f64::max);
        // one that is zero in every digit restrains nothing here, and that is told
        let row = (0..self.kept)
            .filter(|&row| norms[row] > RANK * largest)
            .find(|&row| self.vanishes_beside(row, norms[row], state, parameters))?;
        Some(Unmet::Multiple { at: self.known[row].at.clone(), name: self.known[row].title.clone() })
    }

    /// Whether the gradient of a constraint, which has a norm at a state, vanishes at every zero that is found from states beside it.
    fn vanishes_beside(&self, row: usize, norm: f64, state: &[f64], parameters: &[f64]) -> bool {
        let order = usize::from(self.known[row].level == Level::Speed);
        let n = self.layout.speeds();
        let at = |state: Vec<f64>| {
            let values = self.values(0.0, &state, parameters);
            let gradient = self.rows(&values, self.kept).row(row).transpose();
            Beside { state, value: values[row], gradient }
        };
        let displaced = |probe: usize| {
            // parts that are no multiples of each other, of both signs
            let part = |place: usize| ((probe * 13 + place + 1) as f64 * 0.618_033_988_749_894_9).fract() * 2.0 - 1.0;
            let mut moved = state.to_vec();
            (0..n).for_each(|speed| self.layout.displace(&mut moved, (speed, order), SIZE * part(speed)));
            at(moved)
        };
        let all: Vec<Beside> = (0..PROBES).map(displaced).collect();
        let largest = all.iter().map(|beside| beside.gradient.norm()).fold(0.0, f64::max);
        if !largest.is_finite() || norm > SMALL * largest {
            return false;
        }
        let zero_of = |first: &Beside| {
            let mut nearest = (first.value.abs(), first.gradient.norm());
            let mut here = Beside { state: first.state.clone(), value: first.value, gradient: first.gradient.clone() };
            for _ in 0..MOST_STEPS {
                let step = here.gradient.scale(here.value / here.gradient.norm_squared());
                if nearest.0 <= FOUND * first.value.abs() || !step.iter().all(|part| part.is_finite()) {
                    break;
                }
                let mut moved = here.state;
                step.iter().enumerate().for_each(|(speed, part)| {
                    self.layout.displace(&mut moved, (speed, order), -part);
                });
                here = at(moved);
                if here.value.abs() < nearest.0 {
                    nearest = (here.value.abs(), here.gradient.norm());
                }
            }
            nearest
        };
        let vanishes = |first: &Beside| {
            let (left, gradient) = zero_of(first);
            let part = (left / first.value.abs()).max(FOUND);
            part <= FOUND.sqrt() && gradient <= SLACK * part.sqrt() * first.gradient.norm()
        };
        all.iter().filter(|beside| beside.gradient.norm() >= TELLING * largest).all(vanishes)
    }
}
