//! Completion of a prescribed motion at an instant: the other coordinates follow from the constraints, currents from the forces that they
//! must exert.

use super::currents::Currents;
use super::prescription::Prescribed;
use super::{NoForces, RANK};
use crate::linearisation::{Point, VariedEquations};
use crate::row_units::{measured, rate_unit};
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Residuals of constraints below this value, in SI units, are rounding errors.
const MET: f64 = 1e-9;
const MOST_STEPS: usize = 50;

/// The solver for coordinates that are not prescribed.
pub(super) struct Completion<'a> {
    pub equations: &'a VariedEquations,
    pub model: &'a Model,
    pub prescribed: &'a Prescribed,
    pub currents: &'a Currents<'a>,
}

impl Completion<'_> {
    /// The point with all coordinates, speeds, accelerations and currents at its time, from the prescribed ones.
    ///
    /// # Errors
    /// [`NoForces`] if a constraint does not hold, or coordinates are not determined.
    pub fn of(&self, mut point: Point) -> Result<Point, NoForces> {
        let time = point.time;
        let positions = self.equations.positions();
        let third = self.prescribed.put(&mut point);
        let Currents { open, held, rates, .. } = self.currents;
        let columns = |matrix: &DMatrix<f64>, rows: &[usize]| matrix.select_rows(rows).select_columns(open);
        let of_positions: Vec<usize> = (0..positions).collect();
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
            let matrix = columns(&at.zero.by_coordinates, &of_positions);
            let Some(step) = least(&matrix, &residuals) else { break };
            if !step.iter().all(|part| part.is_finite()) || step.amax() <= 1e-16 {
                break;
            }
            for (&place, part) in open.iter().zip(step.iter()) {
                self.equations.displace(&mut point, place, -part);
            }
        }
        let at = self.equations.at(&point);
        self.met(&at.zero.values, &of_positions, 0, time)?;
        if self.currents.count() + rank_of(&columns(&at.zero.by_coordinates, &of_positions)) < open.len() {
            let names = self.model.state_names();
            let layout = self.prescribed.layout;
            let order = |speed: usize| usize::from(layout.places(speed, 0).len() > 1);
            let name = |&speed: &usize| names[layout.places(speed, order(speed)).start].0.clone();
            let coordinates = open.iter().filter(|place| !self.currents.has(**place)).map(name).collect();
            return Err(NoForces::Open { coordinates, time });
        }
        // velocity and acceleration constraints are linear; nonlinear velocity constraints need the iteration
        for _ in 0..MOST_STEPS {
            let at = self.equations.at(&point);
            let matrix = columns(&at.rate.by_speeds, rates);
            let Some(step) = least(&matrix, &at.rate.values.select_rows(rates)) else { break };
            if step.amax() <= 1e-15 {
                break;
            }
            open.iter().zip(step.iter()).for_each(|(&place, part)| point.speeds[place] -= part);
        }
        let at = self.equations.at(&point);
        self.met(&at.rate.values, rates, 1, time)?;
        let matrix = columns(&at.acceleration.by_accelerations, held);
        if let Some(step) = least(&matrix, &at.acceleration.values.select_rows(held)) {
            open.iter().zip(step.iter()).for_each(|(&place, part)| point.accelerations[place] -= part);
        }
        let at = self.equations.at(&point);
        self.met(&at.acceleration.values, held, 2, time)?;
        self.equations.choose(&mut point);
        self.currents.flow(self.equations, point, &third)
    }

    /// Checks that the constraints in `rows` hold; `residuals` are values of their derivatives of this `order` by time.
    ///
    /// # Errors
    /// [`NoForces::Unmet`] or [`NoForces::NotLed`] for the first that does not hold.
    fn met(&self, residuals: &DVector<f64>, rows: &[usize], order: usize, time: f64) -> Result<(), NoForces> {
        let unmet = |row: &&usize| residuals[**row].is_nan() || residuals[**row].abs() > MET;
        match rows.iter().find(unmet) {
            None => Ok(()),
            Some(&row) => {
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

/// The solution of least norm of a linear system by singular values; `None` if the matrix is empty or not finite.
fn least(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if matrix.is_empty() || !matrix.iter().chain(right.iter()).all(|value| value.is_finite()) {
        return None;
    }
    let decomposed = matrix.clone().svd(true, true);
    let largest = decomposed.singular_values.amax();
    decomposed.solve(right, RANK * largest).ok()
}
