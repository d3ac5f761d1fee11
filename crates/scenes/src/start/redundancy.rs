//! Redundant constraints: those that follow from others along every motion, or at one instant only.
//!
//! Where the gradient of a constraint depends on those before it, two cases are possible. In a chain of parallelograms one rod is
//! redundant in every configuration; at the dead point of a crank two constraints have parallel gradients for an instant. To tell
//! them apart the state is displaced along the tangent space and projected back onto the constraints. Where the rank there equals
//! the rank here, the dependent constraints are redundant; near a dead point the rank is higher.

use super::constraints::Constraints;
use super::{MOST_STEPS, RANK, Unmet};
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Displaced states at which a constraint must follow from others.
const PROBES: usize = 3;

/// Sizes of a displacement, in SI units, the next where the one before leads out of reach; and of the time beside it, in seconds.
const SIZES: [f64; 4] = [0.1, 0.03, 0.01, 0.003];

/// A row that follows from others leaves at most this part at a displaced state: rounding of its completion.
const LEAVES: f64 = 1e-8;

/// A displaced state is at least this part of the displacement away.
const STAYS_AWAY: f64 = 0.3;

/// Rows of a matrix in order: those that depend on others before them, and the others.
pub(super) struct Rows {
    independent: Vec<usize>,
    pub dependent: Vec<usize>,
}

impl Rows {
    pub fn of(rows: impl Iterator<Item = usize>, jacobian: &DMatrix<f64>, rank: f64) -> Self {
        let (mut independent, mut dependent, mut kept) = (Vec::new(), Vec::new(), Vec::<DVector<f64>>::new());
        // a row of roundings has no direction
        let least = rank * jacobian.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
        for row in rows {
            let whole: DVector<f64> = jacobian.row(row).transpose();
            // twice, so that rounding leaves nothing along the others
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
    /// The constraints, by their places, that follow from others along every motion.
    ///
    /// # Errors
    /// One that no speed moves, or one that depends on others here alone.
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
                let (at, name) = named(row.max(first));
                Err(Unmet::Redundant { at, name })
            }
        }
    }

    /// Whether a constraint restrains nothing at displaced states at which all constraints hold, as it does here.
    fn is_idle(&self, row: usize, state: &[f64], parameters: &[f64]) -> bool {
        let displaced = SIZES.iter().find_map(|size| self.displaced(state, parameters, 0, *size));
        displaced.is_none_or(|(time, moved)| {
            let jacobian = self.rows(&self.values(time, &moved, parameters), self.known.len());
            let largest = jacobian.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
            jacobian.row(row).norm() <= LEAVES * largest
        })
    }

    /// The first dependent constraint, where the rank of the constraints is another at a displaced state at which all hold, or where no
    /// such state is reached; `None` where the ranks agree.
    fn fails(&self, rows: &Rows, state: &[f64], parameters: &[f64], probe: usize) -> Option<usize> {
        let first = rows.dependent.first().copied();
        let displaced = SIZES.iter().find_map(|size| self.displaced(state, parameters, probe, *size));
        let Some((time, moved)) = displaced else { return first };
        let jacobian = self.rows(&self.values(time, &moved, parameters), self.known.len());
        let there = Rows::of(rows.independent.iter().chain(&rows.dependent).copied(), &jacobian, LEAVES);
        (there.independent.len() != rows.independent.len()).then_some(first).flatten()
    }

    /// A time and a state at which all constraints hold, a way from the start along what they leave; none where none is reached.
    fn displaced(&self, state: &[f64], parameters: &[f64], probe: usize, size: f64) -> Option<(f64, Vec<f64>)> {
        let n = self.layout.speeds();
        // parts that are no multiples of each other, of both signs
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
            // a way that leads back says nothing of other states
            if order == 0 && gone.norm() < STAYS_AWAY * along.norm() {
                return None;
            }
        }
        Some((time, moved))
    }
}

/// The least solution of linear equations; none of those without numbers.
fn least(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if !matrix.iter().chain(right.iter()).all(|value| value.is_finite()) {
        return None;
    }
    let decomposed = matrix.clone().svd(true, true);
    let largest = decomposed.singular_values.amax();
    decomposed.solve(right, RANK * largest).ok()
}
