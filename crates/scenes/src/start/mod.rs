//! The state at time zero: the values in the file, completed so that every constraint holds.
//!
//! Newton's method with least changes adjusts coordinates that the file does not give, or gives as guesses, until the position constraints
//! hold. Then speeds are adjusted until all constraints hold, which is a linear problem.

mod algebraic;
mod constraints;
mod displacement;
mod gimbal;
mod gradient_jumps;
mod junction;
mod kept;
mod leaf;
mod multiple_roots;
mod redundancy;
mod singular_positions;
mod unmet;

pub(crate) use algebraic::{complete_algebraic_speeds, with_algebraic_speeds};
pub use displacement::displaced;
pub(crate) use junction::joined;
pub(crate) use kept::{Dependence, KeptConstraints};
pub(crate) use leaf::Leaf;
pub(crate) use singular_positions::SingularPositions;
pub use unmet::{Open, Unmet};

use crate::compiled_system::has_values;
use constraints::Constraints;
use model::equations::Level;
use model::{Constraint, Contact, Model};
use nalgebra::DMatrix;
use std::borrow::Cow;
use std::fmt;

/// Largest number of Newton's iterations; from a fair guess six are sufficient.
const MOST_STEPS: usize = 50;

/// Residuals below this size are rounding errors of data with fifteen digits; in SI units, or relative to terms larger than one unit.
const MET: f64 = 1e-10;

/// Residuals below this, relative to the largest derivative and to one, are rounding errors.
const ROUNDED: f64 = 1e-14;

/// A step on constraints that hold already is worth another one where it reduces the largest residual to this fraction.
const SHRINKS: f64 = 0.1;

/// A component of a state that changes by less than this relative amount, or of the largest component where it was zero, keeps its
/// value: the change is the rounding of a few steps by singular values.
const STAYS: f64 = 32.0 * f64::EPSILON;

/// Singular values below this multiple of the largest one count as zero.
const RANK: f64 = 1e-10;

/// Completes starts of a model, for any values of its parameters.
#[derive(Debug)]
pub(crate) struct StartSolver {
    constraints: Option<Constraints>,
    /// If coordinates lack inertia: the constraints without these coordinates, and the indices of the coordinates.
    with_inertia: Option<(Option<Constraints>, Vec<usize>)>,
}

/// A start that satisfies all constraints.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Completed {
    /// Coordinates, then speeds, in SI units.
    pub state: Vec<f64>,
    /// Constraint equations that are redundant along every motion: index of the constraint and of its component.
    pub implied: Vec<[usize; 2]>,
}

/// The completed start of a model whose parameters have values.
///
/// # Errors
/// The first constraint that cannot be satisfied or whose reaction is not determined, or a value that is missing.
pub fn consistent(model: &Model) -> Result<Completed, Unmet> {
    let in_touch = in_touch(model);
    let solver = StartSolver::of(&in_touch)?;
    if solver.constraints.is_some() {
        has_values(model).map_err(Unmet::NotCompiled)?;
    }
    let parameters: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
    let mut completed = solver.complete(&parameters, &start_speeds(model), model.start_state(), &given(model))?;
    completed.implied.retain(|[constraint, _]| *constraint < model.constraints.len());
    Ok(completed)
}

/// The model in which the gap of each contact that touches at the start is a constraint.
pub(crate) fn in_touch(model: &Model) -> Cow<'_, Model> {
    let touches = |contact: &&Contact| contact.is_touching && contact.guide.is_none();
    let held: Vec<Constraint> = model.contacts.iter().filter(touches).map(Contact::closed).collect();
    if held.is_empty() {
        return Cow::Borrowed(model);
    }
    let mut with = model.clone();
    with.constraints.extend(held);
    Cow::Owned(with)
}

/// The values of the quasi-velocities that the file gives at the start.
pub(crate) fn start_speeds(model: &Model) -> Vec<f64> {
    model.start_speeds.iter().map(|start| start.value).collect()
}

/// For each coordinate and then each speed, whether the file gives its value, which then stays unchanged.
pub(crate) fn given(model: &Model) -> Vec<bool> {
    let mut given = vec![false; model.positions() + model.speeds()];
    for value in model.start.iter().filter(|value| !value.is_guess) {
        given[value.order * model.positions() + value.coordinate] = true;
    }
    given
}

impl StartSolver {
    /// Compiles the constraints of a model.
    ///
    /// # Errors
    /// If a constraint cannot be compiled, depends on conditions, contains no coordinate and no speed, or has a wrong number of gains.
    pub fn of(model: &Model) -> Result<Self, Unmet> {
        let with_inertia = match model.with_inertia_alone() {
            Some((without, own)) => Some((Constraints::of(&without)?, own)),
            None => None,
        };
        Ok(StartSolver { constraints: Constraints::of(model)?, with_inertia })
    }

    /// Completes a state for values of parameters and of quasi-velocities. Values with `given` = false are adjusted until the constraints hold.
    ///
    /// # Errors
    /// The first constraint that cannot be satisfied, or whose reaction is not determined.
    pub fn complete(
        &self,
        parameters: &[f64],
        speeds: &[f64],
        state: Vec<f64>,
        given: &[bool],
    ) -> Result<Completed, Unmet> {
        let by_all =
            |state: Vec<f64>, given: &[bool]| completed(self.constraints.as_ref(), parameters, speeds, state, given);
        let Some((others, own)) = &self.with_inertia else { return by_all(state, given) };
        // coordinates with inertia stay unchanged if adjusting the others suffices
        let first = completed(others.as_ref(), parameters, speeds, state.clone(), given)?;
        let positions = self.constraints.as_ref().map_or(0, |constraints| constraints.layout.positions());
        let mut kept = vec![true; given.len()];
        for &coordinate in own {
            for place in [coordinate, positions + coordinate] {
                kept[place] = given[place];
            }
        }
        by_all(first.state, &kept).or_else(|_| by_all(state, given))
    }

    /// Writes a text that, together with the numbers passed to [`StartSolver::complete`], determines the result; two equal texts give equal starts.
    pub fn write(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        match &self.constraints {
            None => Ok(()),
            Some(Constraints { tape, known, kept, started, .. }) => {
                let levels: Vec<Level> = known.iter().map(|known| known.level).collect();
                write!(out, "{tape:?} {levels:?} {kept} {started}")
            }
        }
    }
}

/// The state that satisfies the given constraints, by Newton's method.
fn completed(
    constraints: Option<&Constraints>,
    parameters: &[f64],
    speeds: &[f64],
    mut state: Vec<f64>,
    given: &[bool],
) -> Result<Completed, Unmet> {
    let Some(constraints) = constraints else { return Ok(Completed { state, ..Completed::default() }) };
    let parameters = &[parameters, speeds].concat();
    let layout = constraints.layout;
    for (order, level) in [(0, Some(Level::Position)), (1, None)] {
        let is_given = |speed: &usize| layout.places(*speed, order).any(|at| given[at]);
        let free: Vec<usize> = (0..layout.speeds()).filter(|speed| !is_given(speed)).collect();
        let written = state.clone();
        // the largest residual of a state that meets the constraints
        let mut met = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let at = constraints.at(&state, parameters, level);
            let largest = at.0.amax();
            // once met, further steps leave rounding alone: it counts where a contact of small bodies is to touch
            if free.is_empty() || constraints.are_rounded(&at) || largest > SHRINKS * met {
                break;
            }
            if constraints.met(&state, &at, order).iter().all(|is_met| *is_met) {
                met = largest;
            }
            let (residuals, jacobian) = at;
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
                layout.displace(&mut state, (at, order), -part);
            }
        }
        // values that changed only by rounding are restored
        let (coordinates, speeds) = (0..layout.positions(), layout.positions()..state.len());
        for parts in [coordinates, speeds] {
            let largest = state[parts.clone()].iter().fold(0.0, |largest: f64, part| largest.max(part.abs()));
            for (now, &written) in state[parts.clone()].iter_mut().zip(&written[parts]) {
                let size = if written == 0.0 { largest } else { written.abs() };
                if (*now - written).abs() <= STAYS * size {
                    *now = written;
                }
            }
        }
        if let Some(open) = constraints.open(&state, parameters, level, &free) {
            let contradiction = constraints.contradiction(&state, parameters, level);
            let locked = || constraints.locked(&state, parameters).filter(|_| level.is_none());
            let named = |row: usize| (constraints.known[row].at.clone(), constraints.known[row].title.clone());
            let locked = || locked().map(named).map(|(at, name)| Unmet::Locked { at, name });
            return Err(contradiction.or_else(locked).unwrap_or(Unmet::Open(Box::new(open))));
        }
    }
    let wrong = constraints.without_gradient(&state, parameters);
    if let Some(wrong) = wrong.or_else(|| constraints.with_multiple_root(&state, parameters)) {
        return Err(wrong);
    }
    let implied = constraints.implied(&state, parameters)?;
    let implied = implied.into_iter().filter_map(|row| constraints.known[row].of).collect();
    Ok(Completed { state, implied })
}
