//! The state at time zero: what the file gives, completed so that every constraint holds.
//!
//! Coordinates that the file does not give, or gives as a guess, are moved by Newton's method with least changes until the constraints
//! of positions hold; then speeds so that all constraints hold, which is linear in them.

use crate::compiled_system::{NotCompiled, has_values, values as known_values};
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
    /// A constraint that no coordinate and no speed moves.
    Idle(Range<usize>),
    /// A constraint that is led to zero by more gains, or fewer, than its kind has.
    Gains { at: Range<usize>, level: Level },
    /// A constraint that is another one in another case of a condition.
    Piecewise(Range<usize>),
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
    /// Coordinates, or speeds, that were moved to meet it, without success.
    pub moved: Vec<String>,
    /// Whether it is the constraint of positions, or that of speeds.
    pub level: Level,
}

/// Steps of Newton's method: from a fair guess six are many.
const MOST_STEPS: usize = 50;

/// Residuals below this, in SI units, are rounding of data with fifteen digits.
const MET: f64 = 1e-10;

/// Residuals beyond this part of the state are no drift of a run.
const LOOSE: f64 = 1e-6;

/// Singular values below this part of the largest one are taken for zero.
const RANK: f64 = 1e-10;

/// The constraints of a model with their derivatives.
struct Constraints {
    program: Program,
    /// Constraints of positions stand first.
    known: Vec<(Level, String, Range<usize>)>,
    /// So many stand first; the others are led to zero, and may start elsewhere.
    kept: usize,
    coordinates: usize,
}

/// The start of a model whose parameters have values.
///
/// # Errors
/// The first constraint that cannot be met.
pub fn consistent(model: &Model) -> Result<Vec<f64>, Unmet> {
    let mut state = model.start_state();
    let Some(constraints) = Constraints::of(model)? else { return Ok(state) };
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
        if let Some(open) = constraints.open(&state, level, &free, model) {
            return Err(Unmet::Open(open));
        }
    }
    constraints.redundant(&state).map_or(Ok(state), Err)
}

/// Whether a state breaks a constraint of a model that is kept at zero.
pub(crate) fn breaks(model: &Model, time: f64, state: &[f64]) -> bool {
    let Ok(Some(constraints)) = Constraints::of(model) else { return false };
    let mut values = vec![f64::NAN; constraints.known.len() * (2 + constraints.coordinates)];
    constraints.program.run(time, state, &mut values);
    let m = constraints.known.len();
    let size = state.iter().fold(1.0, |size: f64, part| size.max(part.abs()));
    let broken = |value: &f64| value.is_nan() || value.abs() > LOOSE * size;
    values[..2 * m].iter().enumerate().any(|(place, value)| place % m < constraints.kept && broken(value))
}

impl Constraints {
    fn of(model: &Model) -> Result<Option<Self>, Unmet> {
        if model.constraints.is_empty() {
            return Ok(None);
        }
        has_values(model).map_err(Unmet::NotCompiled)?;
        let n = model.coordinates.len();
        let (mut known, mut kept, mut unfit, mut piecewise) = (Vec::new(), 0, None, None);
        let program = Program::of_any_length(2 * n, |time, state| {
            let trace = Trace::of(model);
            let mut all = Equations::of(&trace).constraints;
            all.sort_by_key(|constraint| (constraint.gains.is_some(), constraint.level != Level::Position));
            kept = all.iter().filter(|constraint| constraint.gains.is_none()).count();
            let wrong = |constraint: &&Equation| match (constraint.gains, constraint.level) {
                (None, _) | (Some(2), Level::Position) | (Some(1), Level::Speed) => false,
                (Some(_), _) => true,
            };
            let chooses =
                |each: &&Equation| each.zero.symbols_of().iter().any(|symbol| trace.switches.contains(symbol));
            piecewise = all.iter().find(chooses).map(|constraint| constraint.at.clone());
            unfit = all.iter().find(wrong).map(|constraint| (constraint.at.clone(), constraint.level));
            known = all.iter().map(|Equation { level, name, at, .. }| (*level, name.clone(), at.clone())).collect();
            let zeros = all.iter().map(|constraint| constraint.zero);
            let rates = all.iter().map(|constraint| constraint.rate);
            let rows = all.iter().flat_map(|constraint| constraint.row.iter().copied());
            let wanted: Vec<_> = zeros.chain(rates).chain(rows).collect();
            substitute_all(&wanted, &known_values(&trace, time, state))
        });
        if let Some(at) = piecewise {
            return Err(Unmet::Piecewise(at));
        }
        if let Some((at, level)) = unfit {
            return Err(Unmet::Gains { at, level });
        }
        let program = program.ok_or(Unmet::NotCompiled(NotCompiled::TooLong))?;
        Ok((!known.is_empty()).then_some(Constraints { program, known, kept, coordinates: n }))
    }

    /// Residuals and their derivatives: of positions by the coordinates, of all by the speeds.
    fn at(&self, state: &[f64], level: Option<Level>) -> (DVector<f64>, DMatrix<f64>) {
        let m = self.known.len();
        let values = self.values(state);
        let count = match level {
            Some(level) => self.known[..self.kept].iter().filter(|(own, ..)| *own == level).count(),
            None => self.kept,
        };
        let first = if level.is_some() { 0 } else { m };
        let residuals = DVector::from_fn(count, |i, _| values[first + i]);
        (residuals, self.rows(state, count))
    }

    /// What should be zero, its rates, and their derivatives by the speeds.
    fn values(&self, state: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.known.len() * (2 + self.coordinates)];
        self.program.run(0.0, state, &mut values);
        values
    }

    /// The derivatives of the first constraints by the speeds.
    fn rows(&self, state: &[f64], count: usize) -> DMatrix<f64> {
        let (m, n) = (self.known.len(), self.coordinates);
        let values = self.values(state);
        DMatrix::from_fn(count, n, |i, j| values[2 * m + i * n + j])
    }

    /// The first constraint whose direction depends on those of the others before it.
    fn redundant(&self, state: &[f64]) -> Option<Unmet> {
        let jacobian = self.rows(state, self.known.len());
        let largest = jacobian.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
        let mut kept: Vec<DVector<f64>> = Vec::new();
        for (row, (_, _, at)) in self.known.iter().enumerate() {
            let whole: DVector<f64> = jacobian.row(row).transpose();
            // twice, so that rounding leaves nothing along the others
            let rest =
                (0..2).fold(whole.clone(), |rest, _| kept.iter().fold(rest, |rest, one| &rest - one * one.dot(&rest)));
            let length = rest.norm();
            if whole.norm() <= RANK * largest || whole.norm() == 0.0 {
                return Some(Unmet::Idle(at.clone()));
            }
            if length <= RANK * whole.norm() {
                return Some(Unmet::Redundant(at.clone()));
            }
            kept.push(rest / length);
        }
        None
    }

    /// The first constraint that does not hold, with those of the free coordinates, or speeds, that move it.
    fn open(&self, state: &[f64], level: Option<Level>, free: &[usize], model: &Model) -> Option<Open> {
        let (residuals, jacobian) = self.at(state, level);
        let unmet = |residual: &f64| residual.is_nan() || residual.abs() > MET;
        let worst = residuals.iter().position(unmet)?;
        let (_, name, at) = &self.known[worst];
        let level = if level.is_some() { Level::Position } else { Level::Speed };
        let prime = if level == Level::Speed { "'" } else { "" };
        let moves = free.iter().filter(|place| jacobian[(worst, **place)] != 0.0);
        let moved = moves.map(|place| format!("{}{prime}", model.coordinates[*place].name)).collect();
        Some(Open { at: at.clone(), name: name.clone(), residual: residuals[worst], moved, level })
    }
}
