//! The state at time zero: what the file gives, completed so that every constraint holds.
//!
//! Coordinates that the file does not give, or gives as a guess, are moved by Newton's method with least changes until the constraints
//! of positions hold; then speeds so that all constraints hold, which is linear in them.

use crate::compiled_system::{NotCompiled, has_values, values};
use derivations::taped::Program;
use model::equations::{Equation, Equations, Level};
use model::{Model, Trace};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;
use symbolic::substitute_all;

/// Why a start does not do.
#[derive(Clone, Debug, PartialEq)]
pub enum Unmet {
    /// A constraint does not hold, and nothing that may be moved changes that.
    Open(Open),
    /// A constraint, where the model has it, that follows from those before it.
    Redundant(Range<usize>),
    /// The constraints have no values.
    NotCompiled(NotCompiled),
}

/// A constraint that the start does not meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Open {
    /// Where the model has the constraint.
    pub at: Range<usize>,
    pub name: String,
    /// The value of what should be zero.
    pub residual: f64,
    /// Whether it is the constraint of positions, or that of speeds.
    pub level: Level,
}

/// Steps of Newton's method: from a fair guess six are many.
const MOST_STEPS: usize = 50;

/// Residuals below this, in SI units, are rounding of data with fifteen digits.
const MET: f64 = 1e-10;

/// Singular values below this part of the largest one are taken for zero.
const RANK: f64 = 1e-10;

/// The constraints of a model with their derivatives.
struct Constraints {
    program: Program,
    /// Constraints of positions stand first.
    known: Vec<(Level, String, Range<usize>)>,
    coordinates: usize,
}

/// The start of a model whose parameters have values.
///
/// # Errors
/// The first constraint that cannot be met.
pub fn consistent(model: &Model) -> Result<Vec<f64>, Unmet> {
    let mut state = model.start_state();
    let Some(constraints) = Constraints::of(model).map_err(Unmet::NotCompiled)? else { return Ok(state) };
    let n = constraints.coordinates;
    for (order, level) in [(0, Some(Level::Position)), (1, None)] {
        let given = |i: usize| model.start.iter().any(|v| (v.coordinate, v.order, v.is_guess) == (i, order, false));
        let free: Vec<usize> = (0..n).filter(|&i| !given(i)).collect();
        for _ in 0..MOST_STEPS {
            let (residuals, jacobian) = constraints.at(&state, level);
            if residuals.amax() <= MET {
                break;
            }
            let columns = DMatrix::from_fn(residuals.len(), free.len(), |row, at| jacobian[(row, free[at])]);
            if free.is_empty() {
                break;
            }
            let decomposed = columns.svd(true, true);
            let largest = decomposed.singular_values.amax();
            let Ok(step) = decomposed.solve(&residuals, RANK * largest) else { break };
            if !step.iter().all(|part| part.is_finite()) || step.amax() == 0.0 {
                break;
            }
            for (&at, part) in free.iter().zip(step.iter()) {
                state[order * n + at] -= part;
            }
        }
        if let Some(open) = constraints.open(&state, level) {
            return Err(Unmet::Open(open));
        }
    }
    match constraints.redundant(&state) {
        Some(at) => Err(Unmet::Redundant(at)),
        None => Ok(state),
    }
}

impl Constraints {
    fn of(model: &Model) -> Result<Option<Self>, NotCompiled> {
        if model.constraints.is_empty() {
            return Ok(None);
        }
        has_values(model)?;
        let n = model.coordinates.len();
        let mut known = Vec::new();
        let program = Program::of_any_length(2 * n, |time, state| {
            let trace = Trace::of(model);
            let mut all = Equations::of(&trace).constraints;
            all.sort_by_key(|constraint| constraint.level != Level::Position);
            known = all.iter().map(|Equation { level, name, at, .. }| (*level, name.clone(), at.clone())).collect();
            let zeros = all.iter().map(|constraint| constraint.zero);
            let rates = all.iter().map(|constraint| constraint.rate);
            let rows = all.iter().flat_map(|constraint| constraint.row.iter().copied());
            let wanted: Vec<_> = zeros.chain(rates).chain(rows).collect();
            substitute_all(&wanted, &values(&trace, time, state))
        });
        let program = program.ok_or(NotCompiled::TooLong)?;
        Ok((!known.is_empty()).then_some(Constraints { program, known, coordinates: n }))
    }

    /// Residuals and their derivatives: of positions by the coordinates, of all by the speeds.
    fn at(&self, state: &[f64], level: Option<Level>) -> (DVector<f64>, DMatrix<f64>) {
        let (m, n) = (self.known.len(), self.coordinates);
        let mut values = vec![f64::NAN; m * (2 + n)];
        self.program.run(0.0, state, &mut values);
        let count = match level {
            Some(level) => self.known.iter().filter(|(own, ..)| *own == level).count(),
            None => m,
        };
        let first = if level.is_some() { 0 } else { m };
        let residuals = DVector::from_fn(count, |i, _| values[first + i]);
        (residuals, DMatrix::from_fn(count, n, |i, j| values[2 * m + i * n + j]))
    }

    /// The first constraint whose direction depends on those of the others before it.
    fn redundant(&self, state: &[f64]) -> Option<Range<usize>> {
        let (_, jacobian) = self.at(state, None);
        let largest = jacobian.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
        let mut kept: Vec<DVector<f64>> = Vec::new();
        for (row, (_, _, at)) in self.known.iter().enumerate() {
            let whole: DVector<f64> = jacobian.row(row).transpose();
            // twice, so that rounding leaves nothing along the others
            let rest =
                (0..2).fold(whole.clone(), |rest, _| kept.iter().fold(rest, |rest, one| &rest - one * one.dot(&rest)));
            let length = rest.norm();
            if length <= RANK * whole.norm() || whole.norm() <= RANK * largest || length == 0.0 {
                return Some(at.clone());
            }
            kept.push(rest / length);
        }
        None
    }

    fn open(&self, state: &[f64], level: Option<Level>) -> Option<Open> {
        let (residuals, _) = self.at(state, level);
        let unmet = |residual: &f64| residual.is_nan() || residual.abs() > MET;
        let worst = residuals.iter().position(unmet)?;
        let (_, name, at) = &self.known[worst];
        let level = if level.is_some() { Level::Position } else { Level::Speed };
        Some(Open { at: at.clone(), name: name.clone(), residual: residuals[worst], level })
    }
}
