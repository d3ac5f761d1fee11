//! The signals of a mode: positive while its law holds, and those of the model's own events.

use super::{Case, Moded};
use crate::compiled_system::{Motion, NotCompiled, values};
use derivations::taped::Program;
use integrators::{Signal, Switches};
use model::{Model, Trace};
use std::sync::Arc;
use symbolic::{Sym, substitute_all};

/// The meaning of the fall of a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fall {
    /// A condition passes to its other case.
    Passes { switch: usize },
    /// A condition that was held would have to leave its cases: to the one that is not there, or to the other.
    Leaves { switch: usize, to: Case },
    /// An event of the model, on either side of which the run may be.
    Event { event: usize },
}

/// Values and rates of all signals, and of all conditions.
#[derive(Debug)]
pub(crate) struct Signals {
    pub falls: Vec<Fall>,
    program: Program,
    conditions: usize,
    events: usize,
}

impl Signals {
    pub fn of(model: &Model, mode: &[Case]) -> Result<Self, NotCompiled> {
        let mut falls = Vec::new();
        for (switch, case) in mode.iter().enumerate() {
            match case {
                Case::On | Case::Off => falls.push(Fall::Passes { switch }),
                Case::Held => falls.extend([Case::Off, Case::On].map(|to| Fall::Leaves { switch, to })),
            }
        }
        falls.extend((0..model.events.len()).map(|event| Fall::Event { event }));
        let mut wrong = None;
        let program = Program::of_any_length(model.positions() + model.speeds(), |time, state| {
            written(model, mode, time, state).unwrap_or_else(|reason| {
                wrong = Some(reason);
                Vec::new()
            })
        });
        match (wrong, program) {
            (Some(reason), _) => Err(reason),
            (None, None) => Err(NotCompiled::TooLong),
            (None, Some(program)) => Ok(Signals { falls, program, conditions: mode.len(), events: model.events.len() }),
        }
    }

    /// The values of everything that is written: signals with their rates, conditions with theirs, and what events set.
    fn all(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; 2 * self.falls.len() + 3 * self.conditions + self.events * state.len()];
        self.program.run(time, state, &mut values);
        values
    }

    /// The value and the rate of every signal.
    pub fn at(&self, time: f64, state: &[f64]) -> Vec<[f64; 2]> {
        self.all(time, state).as_chunks::<2>().0[..self.falls.len()].to_vec()
    }

    /// The value and the rate of the expression of every event.
    pub fn events(&self, time: f64, state: &[f64]) -> Vec<[f64; 2]> {
        self.at(time, state)[self.falls.len() - self.events..].to_vec()
    }

    /// The value of every condition, its rate, and the rate of that.
    pub fn conditions(&self, time: f64, state: &[f64]) -> Vec<[f64; 3]> {
        self.all(time, state)[2 * self.falls.len()..].as_chunks::<3>().0[..self.conditions].to_vec()
    }

    /// The state after an event.
    pub fn set_by(&self, event: usize, time: f64, state: &[f64]) -> Vec<f64> {
        let first = 2 * self.falls.len() + 3 * self.conditions + event * state.len();
        self.all(time, state)[first..][..state.len()].to_vec()
    }
}

/// All that [`Signals::all`] gives, over symbols.
fn written(model: &Model, mode: &[Case], time: Sym, state: &[Sym]) -> Result<Vec<Sym>, NotCompiled> {
    if mode.is_empty() && model.events.is_empty() {
        return Ok(Vec::new());
    }
    let trace = Trace::of(model);
    let Motion { accelerations, switches, .. } = Motion::of(&trace, mode)?;
    let cases: Vec<(Sym, Sym)> = trace.switches.iter().copied().zip(switches.iter().copied()).collect();
    let motion: Vec<(Sym, Sym)> = trace.accelerations.iter().copied().zip(accelerations).collect();
    let with_rate = |value: Sym| -> [Sym; 2] {
        let value = value.substitute(&cases);
        [value, trace.rate_of(value).substitute(&motion)]
    };
    let conditions: Vec<Sym> = model.switches.iter().map(|condition| trace.scalar(*condition)).collect();
    let mut all: Vec<Sym> = Vec::new();
    for ((case, condition), letter) in mode.iter().zip(&conditions).zip(&switches) {
        match case {
            Case::On => all.extend(with_rate(*condition)),
            Case::Off => all.extend(with_rate(-*condition)),
            Case::Held => {
                all.extend(with_rate(*letter));
                all.extend(with_rate(Sym::ONE - *letter));
            }
        }
    }
    for event in &model.events {
        all.extend(with_rate(trace.scalar(event.when)));
    }
    for condition in conditions {
        let [value, rate] = with_rate(condition);
        all.extend([value, rate, trace.rate_of(rate).substitute(&motion)]);
    }
    let kept: Vec<Sym> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
    for event in &model.events {
        let mut after = kept.clone();
        for assignment in &event.set {
            let place = assignment.order * trace.coordinates.len() + assignment.coordinate;
            after[place] = trace.scalar(assignment.is).substitute(&cases);
        }
        all.extend(after);
    }
    Ok(substitute_all(&all, &values(&trace, time, state)))
}

/// Watches the signals of a mode, and the events of the model from the side on which the run is.
pub(crate) struct Watch {
    pub moded: Arc<Moded>,
    /// Side of each event: 1 above zero, -1 below.
    pub sides: Vec<f64>,
}

impl Switches for Watch {
    fn count(&self) -> usize {
        self.moded.signals.falls.len()
    }

    fn signals(&self, time: f64, state: &[f64], out: &mut [Signal]) {
        let conditions = self.moded.signals.falls.len() - self.sides.len();
        let sides = std::iter::repeat_n(&1.0, conditions).chain(&self.sides);
        for ((signal, [value, rate]), side) in out.iter_mut().zip(self.moded.signals.at(time, state)).zip(sides) {
            *signal = Signal { value: side * value, rate: side * rate, noise: 0.0 };
        }
    }
}
