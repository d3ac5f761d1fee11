//! Equations of a model with their derivatives over any field, such as intervals and exact fractions.

use super::equations::VariedEquations;
use field::Analytic;

/// Values and derivatives of equations; each row is an equation.
#[derive(Clone, Debug)]
pub(crate) struct Slopes<S> {
    pub values: Vec<S>,
    pub by_coordinates: Vec<Vec<S>>,
    pub by_speeds: Vec<Vec<S>>,
    pub by_accelerations: Vec<Vec<S>>,
    pub by_multipliers: Vec<Vec<S>>,
}

/// Equations of motion, then constraints at the levels of positions, speeds and accelerations. Position constraints precede constraints
/// of speeds.
#[derive(Clone, Debug)]
pub(crate) struct AllSlopes<S> {
    /// M z + h - Q - J^T lambda.
    pub motion: Slopes<S>,
    /// f of every constraint.
    pub zero: Slopes<S>,
    /// df/dt of position constraints, f of constraints of speeds.
    pub rate: Slopes<S>,
    /// The next time derivative J z + c.
    pub acceleration: Slopes<S>,
}

impl<S> Slopes<S> {
    fn through<T>(self, each: &impl Fn(S) -> Option<T>) -> Option<Slopes<T>> {
        let row = |row: Vec<S>| -> Option<Vec<T>> { row.into_iter().map(each).collect() };
        let all = |rows: Vec<Vec<S>>| -> Option<Vec<Vec<T>>> { rows.into_iter().map(row).collect() };
        Some(Slopes {
            values: row(self.values)?,
            by_coordinates: all(self.by_coordinates)?,
            by_speeds: all(self.by_speeds)?,
            by_accelerations: all(self.by_accelerations)?,
            by_multipliers: all(self.by_multipliers)?,
        })
    }
}

impl<S> AllSlopes<S> {
    /// Converts all numbers to another field; `None` if one cannot be converted.
    pub fn through<T>(self, each: impl Fn(S) -> Option<T>) -> Option<AllSlopes<T>> {
        Some(AllSlopes {
            motion: self.motion.through(&each)?,
            zero: self.zero.through(&each)?,
            rate: self.rate.through(&each)?,
            acceleration: self.acceleration.through(&each)?,
        })
    }
}

impl VariedEquations {
    /// The numbers of speeds, constraints, inputs and conditions.
    pub(crate) fn counts(&self) -> [usize; 4] {
        let [n, m, k, _, s] = self.sizes;
        [n, m, k, s]
    }

    /// Evaluates the equations. `point` has coordinates, speeds, accelerations, multipliers, inputs and switches, one after another.
    pub(crate) fn over<S: Analytic>(&self, point: &[S], time: S) -> AllSlopes<S> {
        let [n, m, k, shown, _] = self.sizes;
        let width = 2 + 3 * n + m + k;
        let mut numbers = vec![S::zero(); (n + 3 * m + shown) * width];
        let inputs: Vec<S> = point.iter().copied().chain([time]).collect();
        self.program().over::<S>().evaluate(&inputs, &mut numbers);
        let slopes = |first: usize, rows: usize| {
            let own = |row: usize| &numbers[(first + row) * width..(first + row + 1) * width];
            let block = |from: usize, columns: usize| -> Vec<Vec<S>> {
                (0..rows).map(|row| own(row)[from..from + columns].to_vec()).collect()
            };
            Slopes {
                values: (0..rows).map(|row| own(row)[0]).collect(),
                by_coordinates: block(1, n),
                by_speeds: block(1 + n, n),
                by_accelerations: block(1 + 2 * n, n),
                by_multipliers: block(1 + 3 * n, m),
            }
        };
        AllSlopes {
            motion: slopes(0, n),
            zero: slopes(n, m),
            rate: slopes(n + m, m),
            acceleration: slopes(n + 2 * m, m),
        }
    }
}
