//! A prescribed motion at an instant: coordinates that are not prescribed follow from the constraints.

use super::prescription::Prescribed;
use super::{NoForces, RANK};
use crate::linearisation::{Point, VariedEquations};
use crate::row_units::{measured, rate_unit};
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Residuals of constraints below this, in SI units, are rounding.
const MET: f64 = 1e-9;
const MOST_STEPS: usize = 50;

/// Coordinates that are not prescribed, by the constraints.
pub(super) struct Completion<'a> {
    pub equations: &'a VariedEquations,
    pub model: &'a Model,
    pub prescribed: &'a Prescribed,
}

impl Completion<'_> {
    /// # Errors
    /// A constraint that does not hold, or coordinates that nothing determines.
    pub fn of(&self, mut point: Point) -> Result<Point, NoForces> {
        let (n, time) = (point.speeds.len(), point.time);
        let (positions, kept) = (self.equations.positions(), self.equations.kept());
        self.prescribed.put(&mut point);
        let open: Vec<usize> = (0..n).filter(|&speed| !self.prescribed.has(speed)).collect();
        let columns = |matrix: &DMatrix<f64>, rows: usize| {
            DMatrix::from_fn(rows, open.len(), |row, column| matrix[(row, open[column])])
        };
        let rank_of = |matrix: &DMatrix<f64>| match matrix.is_empty() {
            true => 0,
            false => {
                let singular = matrix.singular_values();
                singular.iter().filter(|value| **value > RANK * singular.amax()).count()
            }
        };
        for _ in 0..MOST_STEPS {
            let at = self.equations.at(&point);
            let residuals = at.zero.values.rows(0, positions).into_owned();
            if open.is_empty() || residuals.iter().all(|residual| residual.abs() <= 1e-14) {
                break;
            }
            let matrix = columns(&at.zero.by_coordinates, positions);
            let Some(step) = least(&matrix, &residuals) else { break };
            if !step.iter().all(|part| part.is_finite()) || step.amax() <= 1e-16 {
                break;
            }
            for (&place, part) in open.iter().zip(step.iter()) {
                self.equations.displace(&mut point, place, -part);
            }
        }
        let at = self.equations.at(&point);
        self.met(&at.zero.values, positions, 0, time)?;
        if rank_of(&columns(&at.zero.by_coordinates, positions)) < open.len() {
            let names = self.model.state_names();
            let layout = self.prescribed.layout;
            let order = |speed: usize| usize::from(layout.places(speed, 0).len() > 1);
            let name = |&speed: &usize| format!("`{}`", names[layout.places(speed, order(speed)).start].0);
            let coordinates = open.iter().map(name).collect();
            return Err(NoForces::Open { coordinates, time });
        }
        // rates are linear in speeds once more, accelerations in themselves; constraints of speeds that are not are iterated
        for _ in 0..MOST_STEPS {
            let at = self.equations.at(&point);
            let matrix = columns(&at.rate.by_speeds, kept);
            let Some(step) = least(&matrix, &at.rate.values.rows(0, kept).into_owned()) else { break };
            if step.amax() <= 1e-15 {
                break;
            }
            open.iter().zip(step.iter()).for_each(|(&place, part)| point.speeds[place] -= part);
        }
        let at = self.equations.at(&point);
        self.met(&at.rate.values, kept, 1, time)?;
        let matrix = columns(&at.acceleration.by_accelerations, at.acceleration.values.len());
        if let Some(step) = least(&matrix, &at.acceleration.values) {
            open.iter().zip(step.iter()).for_each(|(&place, part)| point.accelerations[place] -= part);
        }
        let at = self.equations.at(&point);
        self.met(&at.acceleration.values, at.acceleration.values.len(), 2, time)?;
        self.equations.choose(&mut point);
        Ok(point)
    }

    /// Whether residuals vanish: of constraints, of their rates, or of the rates of these.
    fn met(&self, residuals: &DVector<f64>, count: usize, order: usize, time: f64) -> Result<(), NoForces> {
        let unmet = |residual: &f64| residual.is_nan() || residual.abs() > MET;
        match residuals.iter().take(count).position(unmet) {
            None => Ok(()),
            Some(row) => {
                let known = &self.equations.constraints[row];
                let rates = if known.level == Level::Position { order } else { order.saturating_sub(1) };
                let unit = (0..rates).fold(known.of.clone(), |unit, _| rate_unit(&unit));
                let equation = if known.level == Level::Position { "f'' + g1 f' + g2 f" } else { "f' + g1 f" };
                let (constraint, residual) = (known.title(), measured(residuals[row], &unit));
                Err(match known.is_programmed {
                    true => NoForces::NotLed { constraint, equation, residual, time },
                    false => NoForces::Unmet { constraint, residual, time },
                })
            }
        }
    }
}

/// The least solution of a linear system; none of an empty one.
fn least(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if matrix.is_empty() || !matrix.iter().chain(right.iter()).all(|value| value.is_finite()) {
        return None;
    }
    let decomposed = matrix.clone().svd(true, true);
    let largest = decomposed.singular_values.amax();
    decomposed.solve(right, RANK * largest).ok()
}
