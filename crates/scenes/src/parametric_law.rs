//! The equations of motion of a model with every parameter as an input: one law for all members of an ensemble.

use crate::compiled_system::{NotCompiled, conserves, outputs, rates};
use crate::letters::Inputs;
use model::Model;
use symbolic::{Equations, Recurrence, Tape, Untapeable, apart};

/// The law of a model and its outputs, over state, time and parameters.
#[derive(Debug)]
pub(crate) struct ParametricLaw {
    pub recurrence: Recurrence,
    /// From state, time and parameters to the outputs, the kinetic and the potential energy.
    outputs: Tape,
    /// Whether kinetic and potential energy together stay what they are, for all values of the parameters.
    pub keeps_energy: bool,
}

impl ParametricLaw {
    /// By the trace from which a run is compiled; parameters need no values.
    pub fn of(model: &Model) -> Result<Self, NotCompiled> {
        let undefined = |reason: Untapeable| NotCompiled::Undefined { reason: reason.to_string() };
        apart(|| {
            let inputs = Inputs::of(model);
            let rates = rates(model, &[], inputs.letters())?;
            let moves = rates.iter().any(|rate| rate.symbols_of().contains(&inputs.time));
            let recurrence = Recurrence::record(&Equations {
                state: &inputs.state,
                time: moves.then_some(inputs.time),
                parameters: &inputs.parameters,
                rates: &rates,
            });
            let recurrence = recurrence.map_err(undefined)?;
            let outputs = Tape::record(&inputs.all(), &outputs(model, &[], inputs.letters())).map_err(undefined)?;
            Ok(ParametricLaw { recurrence, outputs, keeps_energy: conserves(model) })
        })
    }

    /// The outputs of the model, the kinetic and the potential energy.
    pub fn outputs(&self, time: f64, state: &[f64], parameters: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.outputs.outputs()];
        self.outputs.over().evaluate(&[state, &[time], parameters].concat(), &mut values);
        values
    }
}
