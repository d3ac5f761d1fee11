//! Constraints that follow from others: along every motion, or at one instant.
//!
//! Where the gradient of a constraint depends on those before it, two cases are possible. In a chain of parallelograms one rod holds
//! what the others hold already, wherever the mechanism stands; at the dead point of a crank two constraints are parallel for an
//! instant. The state is displaced along what the independent constraints leave and brought back to these; if the others hold there
//! too, and depend there too, they follow from them.

use super::constraints::Constraints;
use super::{MET, MOST_STEPS, RANK, Unmet};
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Displaced states at which a constraint must follow from others.
const PROBES: usize = 3;

/// Sizes of a displacement, in SI units, the next where the one before leads out of reach; and of the time beside it, in seconds.
const SIZES: [f64; 4] = [0.1, 0.03, 0.01, 0.003];

/// A constraint that follows from others leaves at most this at a displaced state: rounding of its completion.
const LEAVES: f64 = 1e-8;

/// Rows of a matrix in order: those that depend on others before them, and the others.
pub(super) struct Rows {
    independent: Vec<usize>,
    pub dependent: Vec<usize>,
}

impl Rows {
    pub fn of(rows: impl Iterator<Item = usize>, jacobian: &DMatrix<f64>, rank: f64) -> Self {
        let (mut independent, mut dependent, mut kept) = (Vec::new(), Vec::new(), Vec::<DVector<f64>>::new());
        for row in rows {
            let whole: DVector<f64> = jacobian.row(row).transpose();
            // twice, so that rounding leaves nothing along the others
            let rest =
                (0..2).fold(whole.clone(), |rest, _| kept.iter().fold(rest, |rest, one| &rest - one * one.dot(&rest)));
            let length = rest.norm();
            if length <= rank * whole.norm() {
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
        if let Some(idle) = places.clone().find(|&row| jacobian.row(row).norm() <= RANK * largest) {
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

    /// The first dependent constraint that does not follow from the independent ones at a displaced state; the first of all where none
    /// is reached.
    fn fails(&self, rows: &Rows, state: &[f64], parameters: &[f64], probe: usize) -> Option<usize> {
        let displaced = SIZES.iter().find_map(|size| self.displaced(rows, state, parameters, probe, *size));
        let Some((time, moved)) = displaced else { return rows.dependent.first().copied() };
        let values = self.values(time, &moved, parameters);
        let count = self.known.len();
        let leaves = |row: usize| {
            let size = moved.iter().fold(1.0, |size: f64, part| size.max(part.abs()));
            let all = [values[row], values[count + row]];
            all.iter().any(|value| value.is_nan() || value.abs() > LEAVES * size)
        };
        let jacobian = self.rows(&values, count);
        let there = Rows::of(rows.independent.iter().chain(&rows.dependent).copied(), &jacobian, LEAVES);
        rows.dependent.iter().copied().find(|&row| leaves(row) || !there.dependent.contains(&row))
    }

    /// A time and a state at which the independent constraints hold, a way from the start; none where they do not come to hold.
    fn displaced(
        &self,
        rows: &Rows,
        state: &[f64],
        parameters: &[f64],
        probe: usize,
        size: f64,
    ) -> Option<(f64, Vec<f64>)> {
        let held: Vec<usize> = rows.independent.iter().copied().filter(|row| *row < self.kept).collect();
        let n = self.layout.speeds();
        // parts that are no multiples of each other, of both signs
        let part = |place: usize| ((probe * 17 + place + 1) as f64 * 0.618_033_988_749_894_9).fract() * 2.0 - 1.0;
        let (time, mut moved) = (size * (1.0 + probe as f64), state.to_vec());
        for order in [0, 1] {
            (0..n).for_each(|speed| self.layout.displace(&mut moved, (speed, order), size * part(speed + order * n)));
            let of_level: Vec<usize> = match order {
                0 => held.iter().copied().filter(|row| self.known[*row].level == Level::Position).collect(),
                _ => held.clone(),
            };
            let first = order * self.known.len();
            let mut steps = 0;
            loop {
                let values = self.values(time, &moved, parameters);
                let residuals = DVector::from_iterator(of_level.len(), of_level.iter().map(|row| values[first + row]));
                if of_level.is_empty() || residuals.amax() <= MET {
                    break;
                }
                if steps == MOST_STEPS || !residuals.iter().all(|value| value.is_finite()) {
                    return None;
                }
                let all = self.rows(&values, self.known.len());
                let columns = DMatrix::from_fn(of_level.len(), n, |row, column| all[(of_level[row], column)]);
                if !columns.iter().all(|value| value.is_finite()) {
                    return None;
                }
                let decomposed = columns.svd(true, true);
                let largest = decomposed.singular_values.amax();
                let step = decomposed.solve(&residuals, RANK * largest).ok()?;
                step.iter().enumerate().for_each(|(at, part)| self.layout.displace(&mut moved, (at, order), -part));
                steps += 1;
            }
        }
        Some((time, moved))
    }
}
