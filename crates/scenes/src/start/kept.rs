//! Constraints at events of a run: if an event sets coordinates, those without inertia are adjusted so that constraints hold, and a violated
//! constraint is reported.

use super::constraints::{Constraints, Known};
use super::start_speeds;
use crate::row_units::measured;
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Largest number of Newton's iterations; most constraints are linear in coordinates without inertia.
const STEPS: usize = 20;

/// Residuals below this size are rounding errors.
const ROUNDED: f64 = 1e-14;

/// Largest residual that can result from integration errors, relative to the state.
const LOOSE: f64 = 1e-6;

/// Singular values below this multiple of the largest one count as zero.
const RANK: f64 = 1e-10;

/// Constraints are named if their coefficient in the dependent combination is at least this fraction of the largest coefficient.
const TOLD: f64 = 0.1;

/// The combination of constraints that is closest to linear dependence at a state.
pub(crate) struct Dependence {
    /// The names of the constraints in it, for messages.
    pub titles: Vec<String>,
    /// Indices of the speeds that some constraint involves.
    pub moved: Vec<usize>,
    /// The least singular value of J, divided by the norm of its longest row.
    pub least: f64,
}

/// The compiled constraints of a model.
#[derive(Debug)]
pub(crate) struct KeptConstraints {
    /// `None` for a model without constraints.
    constraints: Option<Constraints>,
    /// The values of parameters, then of the quasi-velocities given at the start.
    parameters: Vec<f64>,
    /// Indices of coordinates without inertia that constraints determine.
    inertialess: Vec<usize>,
}

impl KeptConstraints {
    pub fn of(model: &Model) -> Self {
        let parameters = model.parameters.iter().filter_map(|parameter| parameter.value);
        KeptConstraints {
            constraints: Constraints::of(model).ok().flatten(),
            parameters: parameters.chain(start_speeds(model)).collect(),
            inertialess: model.with_inertia_alone().map_or_else(Vec::new, |(_, own)| own),
        }
    }

    /// The largest absolute residual at a time and a state, each in the SI unit of its constraint.
    pub fn residual(&self, time: f64, state: &[f64]) -> f64 {
        let Some(constraints) = &self.constraints else { return 0.0 };
        let values = constraints.values(time, state, &self.parameters);
        values[..constraints.kept].iter().fold(0.0, |largest: f64, residual| largest.max(residual.abs()))
    }

    /// Adjusts coordinates without inertia and their speeds until constraints hold; other components are unchanged.
    pub fn follow(&self, time: f64, state: &mut [f64]) {
        let (Some(constraints), own) = (&self.constraints, &self.inertialess) else { return };
        if own.is_empty() {
            return;
        }
        for (order, level) in [(0, Some(Level::Position)), (1, None)] {
            for _ in 0..STEPS {
                let (residuals, rows) = at(constraints, time, state, &self.parameters, level);
                let columns = DMatrix::from_fn(residuals.len(), own.len(), |row, at| rows[(row, own[at])]);
                let finite = residuals.iter().chain(columns.iter()).all(|number| number.is_finite());
                if !finite || residuals.is_empty() || residuals.amax() <= ROUNDED {
                    break;
                }
                let decomposed = columns.svd(true, true);
                let largest = decomposed.singular_values.amax();
                let Ok(step) = decomposed.solve(&residuals, RANK * largest) else { break };
                if step.iter().any(|part| !part.is_finite()) || step.amax() == 0.0 {
                    break;
                }
                for (&at, part) in own.iter().zip(step.iter()) {
                    constraints.layout.displace(state, (at, order), -part);
                }
            }
        }
    }

    /// The combination of constraints closest to linear dependence at a state; `None` for a model without enforced constraints, or where J is
    /// not finite.
    pub fn dependence(&self, time: f64, state: &[f64]) -> Option<Dependence> {
        let constraints = self.constraints.as_ref().filter(|constraints| constraints.kept > 0)?;
        let values = constraints.values(time, state, &self.parameters);
        let rows = constraints.rows(&values, constraints.kept);
        if !rows.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let largest = rows.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
        let decomposed = (&rows / largest).svd(true, true);
        let (place, least) = decomposed.singular_values.argmin();
        let combination = decomposed.u?.column(place).abs();
        let named = (0..constraints.kept).filter(|&row| combination[row] >= TOLD * combination.amax());
        let moved = (0..constraints.layout.speeds()).filter(|&speed| rows.column(speed).amax() > RANK * largest);
        Some(Dependence {
            titles: named.map(|row| constraints.known[row].title.clone()).collect(),
            moved: moved.collect(),
            least,
        })
    }

    /// The first enforced constraint that a state violates, with its residual, as a text; `None` if all hold.
    pub fn broken(&self, time: f64, state: &[f64]) -> Option<String> {
        let constraints = self.constraints.as_ref()?;
        let values = constraints.values(time, state, &self.parameters);
        let m = constraints.known.len();
        let size = state.iter().fold(1.0, |size: f64, part| size.max(part.abs()));
        let is_broken = |place: &usize| {
            let value: f64 = values[*place];
            place % m < constraints.kept && (value.is_nan() || value.abs() > LOOSE * size)
        };
        let place = (0..2 * m).find(is_broken)?;
        let Known { title, level, .. } = &constraints.known[place % m];
        let rate = if place >= m && *level == Level::Position { "the rate of " } else { "" };
        let unit = constraints.unit_of(place % m, if place < m { Some(*level) } else { None });
        Some(format!("{rate}{title} becomes {}", measured(values[place], &unit)))
    }
}

/// The residuals of position constraints or, without a level, the rates of all constraints, and their derivatives with respect to the speeds.
fn at(
    constraints: &Constraints,
    time: f64,
    state: &[f64],
    parameters: &[f64],
    level: Option<Level>,
) -> (DVector<f64>, DMatrix<f64>) {
    let values = constraints.values(time, state, parameters);
    let kept = &constraints.known[..constraints.kept];
    let count = level.map_or(kept.len(), |level| kept.iter().filter(|known| known.level == level).count());
    let first = if level.is_some() { 0 } else { constraints.known.len() };
    (DVector::from_fn(count, |row, _| values[first + row]), constraints.rows(&values, count))
}
