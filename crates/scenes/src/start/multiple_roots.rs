//! Constraints with multiple roots: for f = g^2 the gradient 2 g grad g is zero where f = 0, and no reaction can enforce the constraint.
//!
//! A start satisfies f up to a rounding error e, so that the gradient there is of the order sqrt(e): small, but not zero. To distinguish such a
//! constraint from one at a singular position, Newton's method is applied to f alone from displaced states. At a double root it halves g in
//! each step, and
//!
//!   |grad f| / |grad f0| = (f / f0)^(1/2) ;
//!
//! the ratio is less for roots of higher order, and stays near 1 for a simple root.

use super::constraints::Constraints;
use super::{MOST_STEPS, RANK, Unmet};
use model::equations::Level;
use nalgebra::DVector;

/// The gradient at the start does not vanish if it is above this fraction of the largest one at displaced states.
const SMALL: f64 = 3e-2;

/// Number of displaced states from which Newton's method starts.
const PROBES: usize = 5;

/// Displaced states with a gradient below this fraction of the largest one are ignored: they are too close to a root by chance.
const TELLING: f64 = 0.1;

/// Size of the displacements in SI units.
const SIZE: f64 = 0.1;

/// The iteration ends where f is below this fraction of its first value. It has converged if the fraction is below the square root of this
/// value.
const FOUND: f64 = 1e-12;

/// Factor by which the gradient may exceed the law of a double root, since f is not an exact square.
const SLACK: f64 = 10.0;

/// A constraint's value and gradient at a displaced state.
struct Beside {
    state: Vec<f64>,
    value: f64,
    gradient: DVector<f64>,
}

impl Constraints {
    /// The first enforced constraint whose gradient vanishes at all roots found near a state.
    pub(super) fn with_multiple_root(&self, state: &[f64], parameters: &[f64]) -> Option<Unmet> {
        let rows = self.rows(&self.values(0.0, state, parameters), self.kept);
        let norms: Vec<f64> = rows.row_iter().map(|row| row.norm()).collect();
        let largest = norms.iter().copied().fold(0.0, f64::max);
        // an exactly zero gradient is reported elsewhere, as a constraint without effect
        let row = (0..self.kept)
            .filter(|&row| norms[row] > RANK * largest)
            .find(|&row| self.vanishes_beside(row, norms[row], state, parameters))?;
        Some(Unmet::Multiple { at: self.known[row].at.clone(), name: self.known[row].title.clone() })
    }

    /// Whether the gradient of a constraint, of the given norm at the state, vanishes at every root found from displaced states.
    pub(super) fn vanishes_beside(&self, row: usize, norm: f64, state: &[f64], parameters: &[f64]) -> bool {
        let order = usize::from(self.known[row].level == Level::Speed);
        let n = self.layout.speeds();
        let at = |state: Vec<f64>| {
            let values = self.values(0.0, &state, parameters);
            let gradient = self.rows(&values, self.kept).row(row).transpose();
            Beside { state, value: values[row], gradient }
        };
        let displaced = |probe: usize| {
            // incommensurable amounts of both signs
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
