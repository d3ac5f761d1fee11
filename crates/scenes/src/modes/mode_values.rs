//! The values of the switches along a run: 1 or 0, and between them where a condition stays at zero, as of dry friction that sticks.

use super::{Mode, Modes};
use crate::compiled_system::{CompiledSystem, determined};
use crate::letters::Letters;
use crate::program::recorded;
use model::{Model, Trace};
use simulation::Program;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// The switches of a model in the law in which a run is.
pub(crate) struct SwitchValues {
    modes: Arc<Modes>,
    known: Mutex<HashMap<Mode, Option<Arc<Program>>>>,
}

impl SwitchValues {
    pub fn of(modes: Arc<Modes>) -> Self {
        SwitchValues { modes, known: Mutex::default() }
    }

    /// The values at a time and a state of the run; not numbers where no law determines them.
    pub fn at(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let Some(system) = self.modes.current() else { return Vec::new() };
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let program = known.entry(system.mode.clone()).or_insert_with(|| program(&system).map(Arc::new)).clone();
        drop(known);
        values(system.model(), program.as_deref(), (time, state))
    }
}

/// The values at the start of a model; none where no motion, or no single one, goes on from there.
pub(crate) fn switch_values_at_start(model: &Arc<Model>, state: &[f64]) -> Option<Vec<f64>> {
    let system = Modes::of(model, &[], &[]).first(state).ok()?;
    Some(values(system.model(), program(&system).as_ref(), (0.0, state)))
}

fn values(model: &Model, program: Option<&Program>, (time, state): (f64, &[f64])) -> Vec<f64> {
    let mut values = vec![f64::NAN; model.switches.len()];
    if let Some(program) = program {
        // a state without values leaves them undefined
        let _ = program.run(time, state, &mut values);
    }
    values
}

fn program(system: &CompiledSystem) -> Option<Program> {
    let (model, mode) = (system.model(), &system.mode);
    if mode.cases.len() != model.switches.len() {
        return None;
    }
    let program = recorded(model.positions() + model.speeds(), |time, state| {
        let trace = Trace::of(model);
        let switches = determined(&trace, mode, trace.switches.clone());
        Letters::with_data(time, state).put_into(&trace, &switches)
    });
    program.ok()
}
