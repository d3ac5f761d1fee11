//! The equations of motion of a model, ready to run: one trace, in every form that a method asks for.

use crate::letters::Letters;
use derivations::differentiated::Differentiated;
use derivations::recorded::Recorded;
use derivations::scene::problem::Law;
use derivations::taped::Program;
use field::DoubleDouble;
use integrators::{Directions, Ode};
use model::equations::{Equation, Equations, Level, Singular};
use model::{Model, Trace};
use std::fmt;
use std::sync::Arc;
use symbolic::{Hypotheses, Sym, decide, substitute_all};

/// Why a model has no law that runs.
#[derive(Clone, Debug, PartialEq)]
pub enum NotCompiled {
    /// A parameter without a value.
    Open { parameter: String },
    /// An axial inertia on a body that tilts.
    Tilted { body: String },
    /// No inertia resists a coordinate.
    Massless { coordinate: String },
    /// A constraint that others imply.
    Redundant { constraint: usize },
    /// An expression has no values.
    Undefined { reason: String },
    /// Longer than what can be run.
    TooLong,
}

impl fmt::Display for NotCompiled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Open { parameter } => write!(f, "the parameter `{parameter}` has no value: a run needs one"),
            Self::Tilted { body } => {
                write!(f, "`{body}` turns about another axis than z: one moment of inertia does not say how it resists")
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

/// The law of a model with the values of its parameters: q' = u, and u' by the equations of motion.
#[derive(Debug)]
pub struct CompiledSystem {
    model: Arc<Model>,
    rates: Program,
    /// Scalars that a run shows beside the state.
    outputs: Program,
    /// Whether kinetic and potential energy together stay what they are.
    pub keeps_energy: bool,
}

impl CompiledSystem {
    /// Writes the equations down and compiles them.
    ///
    /// # Errors
    /// Why there is no law that runs.
    pub fn of(model: &Arc<Model>) -> Result<Self, NotCompiled> {
        has_values(model)?;
        let states = 2 * model.coordinates.len();
        let (mut wrong, mut keeps_energy) = (None, false);
        let rates = Program::of_any_length(states, |time, state| {
            keeps_energy = conserves(model);
            rates(model, Letters::with_data(time, state)).unwrap_or_else(|reason| {
                wrong = Some(reason);
                Vec::new()
            })
        });
        if let Some(reason) = wrong {
            return Err(reason);
        }
        let outputs = Program::of_any_length(states, |time, state| outputs(model, Letters::with_data(time, state)))
            .ok_or(NotCompiled::TooLong)?;
        Ok(CompiledSystem {
            model: Arc::clone(model),
            rates: rates.ok_or(NotCompiled::TooLong)?,
            outputs,
            keeps_energy,
        })
    }

    /// As every method runs it: with series and derivatives where it asks for them.
    pub fn law(self: &Arc<Self>) -> Arc<dyn Law> {
        Arc::new(Differentiated::new(Recorded::new(Arc::clone(self)), Arc::clone(self)))
    }

    /// The outputs at a time and a state.
    pub fn outputs(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.model.outputs.len() + ENERGIES];
        self.outputs.run(time, state, &mut values);
        values
    }
}

/// Whether every parameter has a value.
pub(crate) fn has_values(model: &Model) -> Result<(), NotCompiled> {
    match model.parameters.iter().find(|parameter| parameter.value.is_none()) {
        Some(open) => Err(NotCompiled::Open { parameter: open.name.clone() }),
        None => Ok(()),
    }
}

/// Kinetic and potential energy stand behind the outputs.
pub const ENERGIES: usize = 2;

/// The rates of the state over letters.
pub(crate) fn rates(model: &Model, letters: Letters<'_>) -> Result<Vec<Sym>, NotCompiled> {
    let trace = Trace::of(model);
    if let Some(body) = trace.tilted().first() {
        return Err(NotCompiled::Tilted { body: (*body).to_owned() });
    }
    let (accelerations, _) = Equations::of(&trace).solved().map_err(|singular| match singular {
        Singular::Massless { coordinate } => {
            NotCompiled::Massless { coordinate: model.coordinates[coordinate].name.clone() }
        }
        Singular::Redundant { constraint } => NotCompiled::Redundant { constraint },
    })?;
    let all: Vec<Sym> = trace.speeds.iter().copied().chain(accelerations).collect();
    Ok(letters.put_into(&trace, &all))
}

/// Whether nothing but weights and a given potential acts, only positions are held, and nothing knows the time.
pub(crate) fn conserves(model: &Model) -> bool {
    let acts = !(model.forces.is_empty() && model.torques.is_empty()) || model.energies.dissipation.is_some();
    if acts || model.gravity.is_some() && Trace::of(model).uniform_gravity().is_none() {
        return false;
    }
    let trace = Trace::of(model);
    let equations = Equations::of(&trace);
    let held = equations.constraints.iter();
    let knows_time = |scalar: &Sym| scalar.symbols_of().contains(&trace.time);
    // reactions do no work where every constraint is homogeneous in the speeds
    let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let is_linear = |one: &Equation| {
        let moves = one.row.iter().any(|slope| slope.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol)));
        one.level == Level::Position || !moves && one.zero.substitute(&at_rest) == Sym::ZERO
    };
    let do_no_work = held.clone().all(|one| !knows_time(&one.zero) && is_linear(one));
    // a system that is driven at a speed of its own moves where its coordinates rest
    let driven = trace.kinetic_energy().substitute(&at_rest);
    let is_driven = driven != Sym::ZERO && !decide(driven, &Hypotheses::none()).is_zero();
    do_no_work && !is_driven && ![trace.kinetic_energy(), trace.potential_energy()].iter().any(knows_time)
}

/// The outputs, the kinetic and the potential energy.
pub(crate) fn outputs(model: &Model, letters: Letters<'_>) -> Vec<Sym> {
    let trace = Trace::of(model);
    let shown = model.outputs.iter().map(|output| trace.scalar(output.is));
    let mut all: Vec<Sym> = shown.chain([trace.kinetic_energy(), trace.potential_energy()]).collect();
    let used: Vec<Sym> = all.iter().flat_map(|each| each.symbols_of()).collect();
    if trace.accelerations.iter().any(|symbol| used.contains(symbol))
        && let Ok((accelerations, _)) = Equations::of(&trace).solved()
    {
        let known: Vec<(Sym, Sym)> = trace.accelerations.iter().copied().zip(accelerations).collect();
        all = substitute_all(&all, &known);
    }
    letters.put_into(&trace, &all)
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl Ode<$field> for CompiledSystem {
            fn dimension(&self) -> usize {
                2 * self.model.coordinates.len()
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                // made for a state of this length
                self.rates.run(t, y, dy).unwrap_or(());
            }
        }
    )*};
}
runs!(f64, Directions, DoubleDouble);

impl Ode<Sym> for CompiledSystem {
    fn dimension(&self) -> usize {
        2 * self.model.coordinates.len()
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        match rates(&self.model, Letters::with_data(t, y)) {
            Ok(rates) => dy.copy_from_slice(&rates),
            Err(_) => dy.fill(Sym::UNDEFINED),
        }
    }
}
