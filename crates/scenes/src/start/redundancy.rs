//! Redundant constraints: along every motion, or at one instant only.
//!
//! If the gradient of a constraint depends linearly on those of others, two cases are possible. In a chain of parallelograms one rod is
//! redundant in every configuration; at the dead point of a crank two gradients are parallel for an instant. The test displaces the state
//! along the tangent space and projects it back onto the constraints. If the rank of the Jacobian is equal there, the constraints are redundant;
//! near a dead point it is higher.

use super::constraints::Constraints;
use super::{MOST_STEPS, RANK, Unmet};
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Number of displaced states at which a redundant constraint must depend on others.
const PROBES: usize = 3;

/// Sizes of the displacement in SI units, tried in this order until the projection converges. The time is displaced by as many seconds.
const SIZES: [f64; 4] = [0.1, 0.03, 0.01, 0.003];

/// At a displaced state, a row counts as dependent if its part orthogonal to the others is below this fraction, since the projection is
/// not exact.
const LEAVES: f64 = 1e-8;

/// Least distance of the projected state from the start, as a fraction of the displacement.
const STAYS_AWAY: f64 = 0.3;

/// The rows of a matrix, in order: `dependent` are linear combinations of rows before them, `independent` are the others.
pub(super) struct Rows {
    independent: Vec<usize>,
    pub dependent: Vec<usize>,
}

impl Rows {
    pub fn of(rows: impl Iterator<Item = usize>, jacobian: &DMatrix<f64>, rank: f64) -> Self {
        let (mut independent, mut dependent, mut kept) = (Vec::new(), Vec::new(), Vec::<DVector<f64>>::new());
        // rows of rounding errors count as zero
        let least = rank * jacobian.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
        for row in rows {
            let whole: DVector<f64> = jacobian.row(row).transpose();
            // orthogonalised twice, to remove rounding errors along the other rows
            let rest =
                (0..2).fold(whole.clone(), |rest, _| kept.iter().fold(rest, |rest, one| &rest - one * one.dot(&rest)));
            let length = rest.norm();
            if length <= (rank * whole.norm()).max(least) {
                dependent.push(row);
            } else {
                independent.push(row);
                kept.push(rest / length);
            }
        }
        Rows { independent, dependent }
    }
}

impl Constraints {
    /// The indices of constraints that depend on others along every motion.
    ///
    /// # Errors
    /// [`Unmet::Idle`] for a constraint without effect, [`Unmet::Redundant`] for one that depends on others only at this position,
    /// [`Unmet::Multiple`] for one whose gradient vanishes wherever it holds.
    pub(super) fn implied(&self, state: &[f64], parameters: &[f64]) -> Result<Vec<usize>, Unmet> {
        let count = self.known.len();
        let jacobian = self.rows(&self.values(0.0, state, parameters), count);
        let largest = jacobian.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
        let started = self.kept..self.kept + self.started;
        let places = (0..count).filter(|row| !started.contains(row));
        let named = |row: usize| (self.known[row].at.clone(), self.known[row].title.clone());
        let mut idle = places.clone().filter(|&row| jacobian.row(row).norm() <= RANK * largest);
        if let Some(idle) = idle.find(|&row| self.is_idle(row, state, parameters)) {
            let (at, name) = named(idle);
            return Err(Unmet::Idle { at, name });
        }
        let rows = Rows::of(places, &jacobian, RANK);
        let Some(&first) = rows.dependent.first() else { return Ok(Vec::new()) };
        let is_led = |row: &&usize| **row >= self.kept;
        let fails = || (0..PROBES).find_map(|probe| self.fails(&rows, state, parameters, probe));
        match rows.dependent.iter().find(is_led).copied().or_else(fails) {
            None => Ok(rows.dependent),
            Some(row) => {
                let row = row.max(first);
                let (at, name) = named(row);
                let gradient = jacobian.row(row).norm();
                Err(match gradient <= RANK * largest {
                    true if row < self.kept && self.vanishes_beside(row, gradient, state, parameters) => {
                        Unmet::Multiple { at, name }
                    }
                    true => Unmet::Idle { at, name },
                    false => Unmet::Redundant { at, name },
                })
            }
        }
    }

    /// Whether the gradient of a constraint is zero at a displaced state, too, at which all constraints hold.
    fn is_idle(&self, row: usize, state: &[f64], parameters: &[f64]) -> bool {
        let displaced = SIZES.iter().find_map(|size| self.displaced(state, parameters, 0, *size));
        displaced.is_none_or(|(time, moved)| {
            let jacobian = self.rows(&self.values(time, &moved, parameters), self.known.len());
            let largest = jacobian.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
            jacobian.row(row).norm() <= LEAVES * largest
        })
    }

    /// The first dependent constraint, if the rank of the Jacobian differs at a displaced state or no displaced state is found; `None` if the ranks
    /// are equal.
    fn fails(&self, rows: &Rows, state: &[f64], parameters: &[f64], probe: usize) -> Option<usize> {
        let first = rows.dependent.first().copied();
        let displaced = SIZES.iter().find_map(|size| self.displaced(state, parameters, probe, *size));
        let Some((time, moved)) = displaced else { return first };
        let jacobian = self.rows(&self.values(time, &moved, parameters), self.known.len());
        let there = Rows::of(rows.independent.iter().chain(&rows.dependent).copied(), &jacobian, LEAVES);
        (there.independent.len() != rows.independent.len()).then_some(first).flatten()
    }

    /// A later time and a displaced state at which all constraints hold, reached along the tangent space; `None` if the projection fails.
    fn displaced(&self, state: &[f64], parameters: &[f64], probe: usize, size: f64) -> Option<(f64, Vec<f64>)> {
        let n = self.layout.speeds();
        // incommensurable amounts of both signs
        let part = |place: usize| ((probe * 17 + place + 1) as f64 * 0.618_033_988_749_894_9).fract() * 2.0 - 1.0;
        let (time, mut moved) = (size * (1.0 + probe as f64), state.to_vec());
        for order in [0, 1] {
            let is_of = |row: &usize| order == 1 || self.known[*row].level == Level::Position;
            let of_level: Vec<usize> = (0..self.kept).filter(is_of).collect();
            let columns = |values: &[f64]| {
                let all = self.rows(values, self.known.len());
                DMatrix::from_fn(of_level.len(), n, |row, column| all[(of_level[row], column)])
            };
            let aside = DVector::from_fn(n, |speed, _| size * part(speed + order * n));
            let along = match of_level.is_empty() {
                true => aside,
                false => {
                    let here = columns(&self.values(time, &moved, parameters));
                    &aside - least(&here, &(&here * &aside))?
                }
            };
            let mut gone = along.clone();
            along.iter().enumerate().for_each(|(speed, part)| self.layout.displace(&mut moved, (speed, order), *part));
            let first = order * self.known.len();
            let mut steps = 0;
            loop {
                let values = self.values(time, &moved, parameters);
                let residuals = DVector::from_iterator(of_level.len(), of_level.iter().map(|row| values[first + row]));
                let at = (residuals, columns(&values));
                if self.met(&moved, &at, order).iter().all(|is_met| *is_met) {
                    break;
                }
                let (residuals, _) = at;
                if steps == MOST_STEPS {
                    return None;
                }
                let step = least(&columns(&values), &residuals)?;
                step.iter().enumerate().for_each(|(at, part)| self.layout.displace(&mut moved, (at, order), -part));
                gone -= step;
                steps += 1;
            }
            // a projection back to the start gives no information
            if order == 0 && gone.norm() < STAYS_AWAY * along.norm() {
                return None;
            }
        }
        Some((time, moved))
    }
}

/// The least-norm solution of linear equations; `None` if a coefficient is not finite.
fn least(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if !matrix.iter().chain(right.iter()).all(|value| value.is_finite()) {
        return None;
    }
    let decomposed = matrix.clone().svd(true, true);
    let largest = decomposed.singular_values.amax();
    decomposed.solve(right, RANK * largest).ok()
}
