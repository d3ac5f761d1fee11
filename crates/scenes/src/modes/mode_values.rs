//! Values along a run that depend on the mode, for drawings.
//!
//! For each switch 1 or 0, or a number between them if its condition stays at zero (sticking dry friction). Then for each contact the
//! three components of its friction on the touching body, in axes of the ground, and its normal reaction, N. A value is NaN if no law
//! determines it.

use super::{Mode, Modes};
use crate::compiled_system::{CompiledSystem, determined};
use crate::letters::Letters;
use crate::program::recorded;
use model::{FrameId, Model, Trace, Vector};
use simulation::Program;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use symbolic::Sym;

/// The number of values of a contact.
pub(crate) const OF_CONTACT: usize = 4;

/// The values of a model by the current law of a run, with programs for each mode.
pub(crate) struct ModeValues {
    modes: Arc<Modes>,
    known: Mutex<HashMap<Mode, Arc<Programs>>>,
}

/// The programs of a mode: for the switches, and for the contacts.
struct Programs([Option<Program>; 2]);

impl ModeValues {
    pub fn of(modes: Arc<Modes>) -> Self {
        ModeValues { modes, known: Mutex::default() }
    }

    /// The values at a time (s) and a state of the run; empty before the run has a law.
    pub fn at(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let Some(system) = self.modes.current() else { return Vec::new() };
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let programs = known.entry(system.mode.clone()).or_insert_with(|| Arc::new(Programs::of(&system)));
        let programs = Arc::clone(programs);
        drop(known);
        programs.values(system.model(), time, state)
    }
}

/// The values at the start of a model; `None` if no motion, or more than one, continues from there.
pub(crate) fn mode_values_at_start(model: &Arc<Model>, state: &[f64]) -> Option<Vec<f64>> {
    let system = Modes::of(model, &[], &[]).first(state).ok()?;
    Some(Programs::of(&system).values(system.model(), 0.0, state))
}

/// Indices of the contacts between bodies: all except diodes and freewheels.
fn contacts(model: &Model) -> impl Iterator<Item = usize> {
    (0..model.contacts.len()).filter(|place| model.contacts[*place].one_way.is_none())
}

/// The numbers of values for switches and for contacts.
pub(crate) fn lengths(model: &Model) -> [usize; 2] {
    [model.switches.len(), OF_CONTACT * contacts(model).count()]
}

impl Programs {
    fn of(system: &CompiledSystem) -> Self {
        let (model, mode) = (system.model(), &system.mode);
        let program = |of: fn(&Trace<'_>) -> Vec<Sym>| {
            let program = recorded(model.positions() + model.speeds(), |time, state| {
                let trace = Trace::of(model);
                let values = determined(&trace, mode, of(&trace));
                Letters::with_data(time, state).put_into(&trace, &values)
            });
            program.ok()
        };
        let has_cases = mode.cases.len() == model.switches.len();
        Programs([
            if has_cases { program(|trace| trace.switches.clone()) } else { None },
            program(|trace| contacts(trace.model).flat_map(|contact| of_contact(trace, contact)).collect()),
        ])
    }

    fn values(&self, model: &Model, time: f64, state: &[f64]) -> Vec<f64> {
        let parts = self.0.iter().zip(lengths(model)).map(|(program, length)| {
            let mut values = vec![f64::NAN; length];
            if let Some(program) = program {
                // values remain NaN if the state has none
                let state = &state[..state.len().min(model.positions() + model.speeds())];
                let _ = program.run(time, state, &mut values);
            }
            values
        });
        parts.collect::<Vec<_>>().concat()
    }
}

/// The friction of a contact as a vector in axes of the ground, then its normal reaction.
fn of_contact(trace: &Trace<'_>, place: usize) -> [Sym; OF_CONTACT] {
    let contact = &trace.model.contacts[place];
    let along = |(number, tangent): (usize, &model::VectorId)| {
        let component = trace.reaction(place, number + 1);
        trace.vector(*tangent).map(|part| component * part)
    };
    let friction = contact.tangents.iter().enumerate().map(along).fold(Vector::ZERO, |sum, part| trace.sum(sum, part));
    let [x, y, z] = trace.express(friction, FrameId::GROUND);
    [x, y, z, trace.reaction(place, 0)]
}
