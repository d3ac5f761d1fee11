//! The compiled equations of motion of a model: rates of the state, Taylor series and Jacobian, all from one trace.

mod implicit_speeds;
mod outputs;

pub(crate) use implicit_speeds::ImplicitSpeeds;
pub use outputs::ENERGIES;
pub(crate) use outputs::{determined, outputs, outputs_of_solved};

use crate::changing_laws::{changes, is_watched};
use crate::conservation::conserves;
use crate::constraint_projection::ConstraintProjection;
use crate::elimination::{Elimination, LEAST_MOVING, LEAST_SOLVED, is_tree};
use crate::implicit::{Implicit, ImplicitLaw, Inertia, recurrence};
use crate::letters::Letters;
use crate::modes::{Mode, ModeMotion};
use crate::program::recorded;
use crate::residual_differential::residual_differential;
use crate::row_units::columns;
use field::DoubleDouble;
use integrators::{Dual8, Ode, Real};
use model::equations::{MOST_COMPARED, constraints_of};
use model::{Model, ScalarId, Trace};
use outputs::of_motion;
use simulation::{CompiledLaw, JacobianProgram, Law, LawSeries, Program, Running, SymbolicLaw};
use std::fmt;
use std::ops::Range;
use std::sync::{Arc, OnceLock};
use symbolic::{Sym, apart, substitute_all};

/// The reason for which the equations of motion of a model cannot be compiled.
#[derive(Clone, Debug, PartialEq)]
pub enum NotCompiled {
    /// A parameter or an input has no value. `what` is the word "parameter" or "input".
    Open { what: &'static str, name: String },
    /// No inertia (mass, moment of inertia, inductance) belongs to the coordinate.
    Massless { coordinate: String },
    /// The constraint with this index depends on those before it.
    Redundant { constraint: usize },
    /// The caller needs one law for all times, but the law changes with contacts, or the run starts from an equilibrium.
    Changes,
    /// A condition or an event depends on accelerations or reactions. `at` is its byte range in the file.
    OfAccelerations { at: Range<usize> },
    /// The motion with the condition of this index at zero (sliding mode) is undetermined: the law does not depend on the value of the switch between its two cases.
    NotHeld { switch: usize },
    /// The reaction of the contact with this index is not determined by the motion.
    NotHeldContact { contact: usize },
    /// An expression has no value; `reason` says which.
    Undefined { reason: String },
    /// The equations are too long to be compiled.
    TooLong,
}

impl fmt::Display for NotCompiled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Open { what, name } => write!(f, "the {what} `{name}` has no value"),
            Self::Changes => write!(
                f,
                "its law changes with its contacts, which this command does not know yet; one that stays in touch may be written as a constraint"
            ),
            Self::NotHeld { switch } => {
                write!(f, "condition {} cannot be kept at zero: nothing in the law grows with it alone", switch + 1)
            }
            Self::NotHeldContact { contact } => {
                write!(f, "contact {} has no reaction that the motion determines", contact + 1)
            }
            Self::OfAccelerations { .. } => {
                write!(f, "a condition that depends on accelerations or reactions is not supported yet")
            }
            Self::Massless { coordinate } => write!(f, "nothing with a mass or an inertia moves with `{coordinate}`"),
            Self::Redundant { constraint } => {
                write!(f, "constraint {} follows from those before it", constraint + 1)
            }
            Self::Undefined { reason } => write!(f, "its equations have no values: {reason}"),
            Self::TooLong => write!(f, "the equations of motion are longer than what this version can run"),
        }
    }
}

/// The equations of motion of a model, with numbers for its parameters: q' = u, u' = M^-1 F for a state of coordinates, then speeds.
#[derive(Debug)]
pub struct CompiledSystem {
    model: Arc<Model>,
    /// The mode for which the law is compiled: the case of each condition and the regime of each contact.
    pub mode: Mode,
    rates: Rates,
    /// Algebraic speeds of this mode that no expression gives: roots of their laws.
    implicit: Option<ImplicitSpeeds>,
    /// The outputs and energies of the model. Inputs are the state, and with [`Rates::Solved`] also accelerations and multipliers.
    outputs: Program,
    /// Indices of outputs that are NaN because they depend on accelerations or reactions, at a start without a motion.
    without_value: Vec<usize>,
    /// True if the sum of kinetic and potential energy is constant.
    pub keeps_energy: bool,
    /// The projection onto the constraints, compiled when a run first needs it; `None` if no constraint is projected.
    projection: OnceLock<Option<Arc<ConstraintProjection>>>,
    /// True if accelerations are eliminated along a tree of many bodies. The length of series and derivatives is then linear in the number of bodies.
    is_tree: bool,
}

/// The evaluation of the rates.
#[derive(Debug)]
enum Rates {
    /// Explicit expressions of the accelerations, evaluated over any field.
    Written(Box<Program>),
    /// Linear equations for accelerations and multipliers, solved at each evaluation.
    Solved(Arc<ImplicitLaw>),
}

impl CompiledSystem {
    /// Derives and compiles the equations of a mode.
    ///
    /// # Errors The reason for which the equations cannot be compiled.
    pub fn of(model: &Arc<Model>, mode: &Mode) -> Result<Self, NotCompiled> {
        CompiledSystem::has_equations(model)?;
        if Elimination::of(model) == Elimination::Solved {
            return CompiledSystem::solved(model);
        }
        if !is_watched(model) {
            match Inertia::of(model) {
                Inertia::Open { speed } => {
                    return Err(NotCompiled::Massless { coordinate: speed_name(model, speed) });
                }
                Inertia::Held => return CompiledSystem::solved(model),
                Inertia::Resists => {}
            }
        }
        match CompiledSystem::written(model, mode) {
            // a constraint may determine a coordinate without inertia
            Err(NotCompiled::Massless { coordinate }) if !is_watched(model) && !model.constraints.is_empty() => {
                CompiledSystem::solved(model).map_err(|_| NotCompiled::Massless { coordinate })
            }
            other => other,
        }
    }

    /// The system for a start from which no motion, or more than one, continues: the law with all contacts open. It serves to show the
    /// start; outputs that depend on the motion are NaN.
    ///
    /// # Errors The equations with open contacts cannot be compiled.
    pub fn without_motion(model: &Arc<Model>) -> Result<Self, NotCompiled> {
        let apart = CompiledSystem::of(model, &Mode::off(model))?;
        Ok(CompiledSystem { without_value: symbolic::apart(|| of_motion(model)), ..apart })
    }

    /// Checks that all parameters and inputs have values, and that no condition or event depends on accelerations or reactions.
    ///
    /// # Errors The first parameter or input without a value, or the first such condition or event.
    pub(crate) fn has_equations(model: &Model) -> Result<(), NotCompiled> {
        has_values(model)?;
        of_accelerations(model).map_or(Ok(()), |at| Err(NotCompiled::OfAccelerations { at }))
    }

    fn solved(model: &Arc<Model>) -> Result<Self, NotCompiled> {
        let implicit = Implicit::of(model)?;
        let mut keeps_energy = false;
        let outputs = recorded(implicit.extended(), |time, extended| {
            keeps_energy = conserves(model);
            let (state, unknowns) = extended.split_at(model.positions() + model.speeds());
            outputs_of_solved(model, Letters::with_data(time, state), unknowns)
        });
        Ok(CompiledSystem {
            model: Arc::clone(model),
            mode: Mode::default(),
            implicit: None,
            rates: Rates::Solved(Arc::new(ImplicitLaw::new(implicit))),
            outputs: outputs?,
            without_value: Vec::new(),
            keeps_energy,
            projection: OnceLock::new(),
            is_tree: false,
        })
    }

    fn written(model: &Arc<Model>, mode: &Mode) -> Result<Self, NotCompiled> {
        let states = model.positions() + model.speeds();
        let (mut wrong, mut keeps_energy) = (None, false);
        let rates = recorded(states, |time, state| {
            keeps_energy = conserves(model);
            rates(model, mode, Letters::with_data(time, state)).unwrap_or_else(|reason| {
                wrong = Some(reason);
                Vec::new()
            })
        });
        if let Some(reason) = wrong {
            return Err(reason);
        }
        let outputs = recorded(states, |time, state| outputs(model, mode, Letters::with_data(time, state)))?;
        Ok(CompiledSystem {
            model: Arc::clone(model),
            mode: mode.clone(),
            rates: Rates::Written(Box::new(rates?)),
            implicit: if model.algebraic_speeds.is_empty() { None } else { ImplicitSpeeds::of(model, mode)? },
            outputs,
            without_value: Vec::new(),
            keeps_energy,
            projection: OnceLock::new(),
            is_tree: model.speeds() > MOST_COMPARED && is_tree(model),
        })
    }

    /// The model of these equations.
    pub(crate) fn model(&self) -> &Arc<Model> {
        &self.model
    }

    /// The law for every integrator; series and derivatives are compiled on demand. Constraints hold at the level of accelerations (index 1).
    pub fn law(self: &Arc<Self>) -> Arc<dyn Law> {
        match &self.rates {
            Rates::Written(rates) => {
                let mut law =
                    CompiledLaw::of(Arc::clone(self) as Arc<dyn SymbolicLaw>).with_rates(Program::clone(rates));
                if self.has_solved_series() {
                    let system = Arc::clone(self);
                    law = law.with_series(LawSeries::by(move || {
                        recurrence(&system.model, LEAST_MOVING).or_else(|| LawSeries::written(&*system))
                    }));
                }
                let rates = || Arc::clone(self) as Arc<dyn SymbolicLaw>;
                let differential = residual_differential(&self.model, rates());
                Arc::new(law.with_jacobian(Arc::new(JacobianProgram::of(rates()).with_differential(differential))))
            }
            Rates::Solved(law) => Arc::clone(law) as Arc<dyn Law>,
        }
    }

    /// `law` with accepted steps projected onto the constraints. Its state may have further components behind coordinates and speeds.
    pub(crate) fn projected(&self, law: Arc<dyn Law>) -> Arc<dyn Law> {
        let made = self.projection.get_or_init(|| ConstraintProjection::of(&self.model).map(Arc::new));
        ConstraintProjection::onto(made.as_ref(), law)
    }

    /// True if accelerations are explicit expressions, which symbolic rewriting needs.
    pub(crate) fn is_written(&self) -> bool {
        matches!(self.rates, Rates::Written(_))
    }

    /// For each component of the state: true if one of the columns `wanted` of a run depends on it. Columns are states, outputs and energies by name.
    pub(crate) fn states_behind(&self, wanted: &[String]) -> Vec<bool> {
        let states = self.model.positions() + self.model.speeds();
        let columns = columns(&self.model);
        let is_wanted = |place: usize| wanted.contains(&columns[place]);
        let mut found: Vec<bool> = (0..states).map(is_wanted).collect();
        if (states..columns.len()).any(is_wanted) {
            apart(|| {
                let state: Vec<Sym> = (0..states).map(|i| Sym::symbol(&format!("y{i}"))).collect();
                let shown = outputs(&self.model, &self.mode, Letters::with_data(Sym::symbol("t"), &state));
                for (_, output) in shown.iter().enumerate().filter(|(place, _)| is_wanted(states + place)) {
                    let used = output.symbols_of();
                    found.iter_mut().zip(&state).for_each(|(behind, state)| *behind |= used.contains(state));
                }
            });
        }
        found
    }

    /// True if the rates are compiled to machine code; otherwise they are interpreted.
    pub fn is_code(&self) -> bool {
        match &self.rates {
            Rates::Written(program) => program.is_code(),
            Rates::Solved(law) => law.equations.is_code(),
        }
    }

    /// True if Taylor series solve linear equations for the accelerations although the rates have them as expressions: from
    /// [`LEAST_SOLVED`] unknowns on this needs fewer products.
    pub(crate) fn has_solved_series(&self) -> bool {
        !self.is_tree && !changes(&self.model) && self.model.speeds() + self.model.constraints.len() >= LEAST_SOLVED
    }

    /// True if some algebraic speeds are given by no expression in this mode; a run then integrates their rates.
    pub(crate) fn has_implicit_speeds(&self) -> bool {
        self.implicit.is_some()
    }

    /// Sets the algebraic speeds of a state to their values in this mode: the rates of their coordinates.
    pub(crate) fn set_algebraic_speeds<S: Real + Running>(&self, time: S, state: &mut [S])
    where
        Self: Ode<S>,
    {
        if self.model.algebraic_speeds.is_empty() {
            return;
        }
        if let Some(implicit) = &self.implicit {
            implicit.set(time, (self.model.positions(), state));
        }
        let mut rates = vec![S::zero(); state.len()];
        self.rates(time, state, &mut rates);
        for &speed in &self.model.algebraic_speeds {
            state[self.model.positions() + speed] = rates[speed];
        }
    }

    /// The outputs, then kinetic and potential energy, at a time (s) and a state, in SI units; NaN for outputs that depend on a motion that does not exist.
    pub fn outputs(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.model.outputs.len() + ENERGIES];
        match &self.rates {
            Rates::Written(_) => self.outputs.run(time, state, &mut values),
            Rates::Solved(law) => self.outputs.run(time, &law.equations.extend(time, state), &mut values),
        };
        self.without_value.iter().for_each(|&output| values[output] = f64::NAN);
        values
    }
}

/// The name of the coordinate of a speed; for a free frame the name of the component of its angular velocity.
pub(crate) fn speed_name(model: &Model, speed: usize) -> String {
    match model.coordinates.get(speed) {
        Some(coordinate) => coordinate.name.clone(),
        None => model.state_names()[model.positions() + speed].0.clone(),
    }
}

/// The byte range in the file of the first condition or event that depends on accelerations or reactions.
pub(crate) fn of_accelerations(model: &Model) -> Option<Range<usize>> {
    if !is_watched(model) {
        return None;
    }
    apart(|| {
        let trace = Trace::of(model);
        let multipliers = constraints_of(&trace).into_iter().map(|one| one.multiplier);
        let unknown: Vec<Sym> = trace.accelerations.iter().copied().chain(multipliers).collect();
        let depends = |id: ScalarId| trace.scalar(id).symbols_of().iter().any(|symbol| unknown.contains(symbol));
        let mut switches = model.switches.iter().zip(&model.switch_places);
        let switch = switches.find_map(|(switch, at)| depends(*switch).then(|| at.clone()));
        switch.or_else(|| model.events.iter().find_map(|event| depends(event.when).then(|| event.at.clone())))
    })
}

/// Checks that every parameter and every input has a value.
///
/// # Errors
/// [`NotCompiled::Open`] with the first that has none.
pub(crate) fn has_values(model: &Model) -> Result<(), NotCompiled> {
    has_values_but(model, &[])
}

/// Checks that every input, and every parameter except those with the indices `given`, has a value.
///
/// # Errors
/// [`NotCompiled::Open`] with the first that has none.
pub(crate) fn has_values_but(model: &Model, given: &[usize]) -> Result<(), NotCompiled> {
    let mut open = model.parameters.iter().enumerate().filter(|(_, parameter)| parameter.value.is_none());
    let parameter = open.find(|(place, _)| !given.contains(place)).map(|(_, open)| &open.name);
    let input = model.inputs.iter().find(|input| input.value.is_none()).map(|open| &open.name);
    match (parameter, input) {
        (Some(open), _) => Err(NotCompiled::Open { what: "parameter", name: open.clone() }),
        (None, Some(open)) => Err(NotCompiled::Open { what: "input", name: open.clone() }),
        (None, None) => Ok(()),
    }
}

/// The rates of the state in a mode, as expressions over `letters`.
pub(crate) fn rates(model: &Model, mode: &Mode, letters: Letters<'_>) -> Result<Vec<Sym>, NotCompiled> {
    let trace = Trace::of(model);
    let ModeMotion { accelerations, speeds, .. } = ModeMotion::of(&trace, mode)?;
    let moved = substitute_all(&trace.position_rates, &speeds);
    Ok(letters.put_into(&trace, &[moved, accelerations].concat()))
}

/// Substitutions: symbols of the model by those of `time` and `state`, parameters by their values.
pub(crate) fn values(trace: &Trace<'_>, time: Sym, state: &[Sym]) -> Vec<(Sym, Sym)> {
    Letters::with_data(time, state).known(trace)
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl Ode<$field> for CompiledSystem {
            fn dimension(&self) -> usize {
                self.model.positions() + self.model.speeds()
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                match &self.rates {
                    // the program was compiled for this dimension, so it cannot fail
                    Rates::Written(program) => program.run(t, y, dy).unwrap_or(()),
                    Rates::Solved(law) => law.rates(t, y, dy),
                }
            }
        }
    )*};
}
runs!(f64, Dual8, DoubleDouble);

impl Ode<Sym> for CompiledSystem {
    fn dimension(&self) -> usize {
        self.model.positions() + self.model.speeds()
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        match rates(&self.model, &self.mode, Letters::with_data(t, y)) {
            Ok(rates) => dy.copy_from_slice(&rates),
            Err(_) => dy.fill(Sym::UNDEFINED),
        }
    }
}
