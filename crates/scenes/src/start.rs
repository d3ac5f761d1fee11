//! The state at time zero: what the file gives, completed so that every constraint holds.
//!
//! Coordinates that the file does not give, or gives as a guess, are moved by Newton's method with least changes until the constraints
//! of positions hold; then speeds so that all constraints hold, which is linear in them.

use crate::compiled_system::{NotCompiled, has_values};
use crate::letters::Inputs;
use model::equations::{Equation, Equations, Level};
use model::{Model, Trace};
use nalgebra::{DMatrix, DVector};
use std::fmt;
use std::ops::Range;
use symbolic::{Sym, Tape, apart};

/// Why a start does not do.
#[derive(Clone, Debug, PartialEq)]
pub enum Unmet {
    /// A constraint does not hold, and nothing that may be moved changes that.
    Open(Open),
    /// A constraint, where the model has it, that follows from those before it.
    Redundant { at: Range<usize>, name: String },
    /// The constraints have no values.
    NotCompiled(NotCompiled),
}

/// A constraint that the start does not meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Open {
    /// Where the model has the constraint.
    pub at: Range<usize>,
    pub name: String,
    /// The value of what should be zero; none where it has no value.
    pub residual: Option<f64>,
    /// Whether it is the constraint of positions, or that of speeds.
    pub level: Level,
}

/// Steps of Newton's method: from a fair guess six are many.
const MOST_STEPS: usize = 50;

/// Residuals below this, in SI units, are rounding of data with fifteen digits.
const MET: f64 = 1e-10;

/// Singular values below this part of the largest one are taken for zero.
const RANK: f64 = 1e-10;

/// Completes starts of a model, whatever values its parameters have.
#[derive(Debug)]
pub(crate) struct StartSolver {
    constraints: Option<Constraints>,
}

/// The constraints of a model with their derivatives.
#[derive(Debug)]
struct Constraints {
    /// From state, time and parameters to the residuals, their rates, and the rates' derivatives by the speeds.
    tape: Tape,
    /// Constraints of positions stand first.
    known: Vec<(Level, String, Range<usize>)>,
    coordinates: usize,
}

/// The start of a model whose parameters have values.
///
/// # Errors
/// The first constraint that cannot be met.
pub fn consistent(model: &Model) -> Result<Vec<f64>, Unmet> {
    let solver = StartSolver::of(model).map_err(Unmet::NotCompiled)?;
    if solver.constraints.is_some() {
        has_values(model).map_err(Unmet::NotCompiled)?;
    }
    let parameters: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
    solver.complete(&parameters, model.start_state(), &given(model))
}

/// Which states, coordinates and then speeds, the file gives, so that they are not moved.
pub(crate) fn given(model: &Model) -> Vec<bool> {
    let mut given = vec![false; 2 * model.coordinates.len()];
    for value in model.start.iter().filter(|value| !value.is_guess) {
        given[value.order * model.coordinates.len() + value.coordinate] = true;
    }
    given
}

impl StartSolver {
    /// Writes the constraints down.
    ///
    /// # Errors
    /// Where they have no values.
    pub fn of(model: &Model) -> Result<Self, NotCompiled> {
        Ok(StartSolver { constraints: Constraints::of(model)? })
    }

    /// A state with these parameters, where what is not given is moved until the constraints hold.
    ///
    /// # Errors
    /// The first constraint that cannot be met.
    pub fn complete(&self, parameters: &[f64], mut state: Vec<f64>, given: &[bool]) -> Result<Vec<f64>, Unmet> {
        let Some(constraints) = &self.constraints else { return Ok(state) };
        let n = constraints.coordinates;
        for (order, level) in [(0, Some(Level::Position)), (1, None)] {
            let free: Vec<usize> = (0..n).filter(|i| !given[order * n + i]).collect();
            for _ in 0..MOST_STEPS {
                let (residuals, jacobian) = constraints.at(&state, parameters, level);
                if residuals.amax() <= MET || free.is_empty() {
                    break;
                }
                let columns = DMatrix::from_fn(residuals.len(), free.len(), |row, at| jacobian[(row, free[at])]);
                if !residuals.iter().chain(columns.iter()).all(|number| number.is_finite()) {
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
            if let Some(open) = constraints.open(&state, parameters, level) {
                return Err(Unmet::Open(open));
            }
        }
        match constraints.redundant(&state, parameters) {
            Some((name, at)) => Err(Unmet::Redundant { at, name }),
            None => Ok(state),
        }
    }

    /// Writes all that decides a completed start beside the given numbers.
    pub fn write(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        match &self.constraints {
            None => Ok(()),
            Some(Constraints { tape, known, .. }) => {
                let levels: Vec<Level> = known.iter().map(|(level, ..)| *level).collect();
                write!(out, "{tape:?} {levels:?}")
            }
        }
    }
}

impl Constraints {
    fn of(model: &Model) -> Result<Option<Self>, NotCompiled> {
        if model.constraints.is_empty() {
            return Ok(None);
        }
        let n = model.coordinates.len();
        apart(|| {
            let trace = Trace::of(model);
            let mut all = Equations::of(&trace).constraints;
            all.sort_by_key(|constraint| constraint.level != Level::Position);
            let zeros = all.iter().map(|constraint| constraint.zero);
            let rates = all.iter().map(|constraint| constraint.rate);
            let rows = all.iter().flat_map(|constraint| constraint.row.iter().copied());
            let wanted: Vec<Sym> = zeros.chain(rates).chain(rows).collect();
            let inputs = Inputs::of(model);
            let wanted = inputs.letters().put_into(&trace, &wanted);
            let tape = Tape::record(&inputs.all(), &wanted)
                .map_err(|reason| NotCompiled::Undefined { reason: reason.to_string() })?
                .arranged();
            let known: Vec<_> = all.into_iter().map(|Equation { level, name, at, .. }| (level, name, at)).collect();
            Ok((!known.is_empty()).then_some(Constraints { tape, known, coordinates: n }))
        })
    }

    /// Residuals and their derivatives: of positions by the coordinates, of all by the speeds.
    fn at(&self, state: &[f64], parameters: &[f64], level: Option<Level>) -> (DVector<f64>, DMatrix<f64>) {
        let (m, n) = (self.known.len(), self.coordinates);
        let mut values = vec![f64::NAN; m * (2 + n)];
        self.tape.over().evaluate(&[state, &[0.0], parameters].concat(), &mut values);
        let count = match level {
            Some(level) => self.known.iter().filter(|(own, ..)| *own == level).count(),
            None => m,
        };
        let first = if level.is_some() { 0 } else { m };
        let residuals = DVector::from_fn(count, |i, _| values[first + i]);
        (residuals, DMatrix::from_fn(count, n, |i, j| values[2 * m + i * n + j]))
    }

    /// The first constraint whose direction depends on those of the others before it.
    fn redundant(&self, state: &[f64], parameters: &[f64]) -> Option<(String, Range<usize>)> {
        let (_, jacobian) = self.at(state, parameters, None);
        let largest = jacobian.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
        let mut kept: Vec<DVector<f64>> = Vec::new();
        for (row, (_, name, at)) in self.known.iter().enumerate() {
            let whole: DVector<f64> = jacobian.row(row).transpose();
            // twice, so that rounding leaves nothing along the others
            let rest =
                (0..2).fold(whole.clone(), |rest, _| kept.iter().fold(rest, |rest, one| &rest - one * one.dot(&rest)));
            let length = rest.norm();
            if length <= RANK * whole.norm() || whole.norm() <= RANK * largest || length == 0.0 {
                return Some((called(name), at.clone()));
            }
            kept.push(rest / length);
        }
        None
    }

    fn open(&self, state: &[f64], parameters: &[f64], level: Option<Level>) -> Option<Open> {
        let (residuals, _) = self.at(state, parameters, level);
        let unmet = |residual: &f64| residual.is_nan() || residual.abs() > MET;
        let worst = residuals.iter().position(unmet)?;
        let (_, name, at) = &self.known[worst];
        let level = if level.is_some() { Level::Position } else { Level::Speed };
        let residual = residuals[worst].is_finite().then_some(residuals[worst]);
        Some(Open { at: at.clone(), name: called(name), residual, level })
    }
}

/// A constraint by its name, where it has one.
fn called(name: &str) -> String {
    if name.is_empty() { "this constraint".to_owned() } else { format!("the constraint `{name}`") }
}

impl fmt::Display for Open {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.residual {
            Some(residual) => write!(f, "{} is {residual:.6e}, and not zero", self.name),
            None => write!(f, "{} has no value", self.name),
        }
    }
}
