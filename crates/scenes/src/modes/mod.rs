//! Modes of a model: the case of each of its conditions, the law that holds there, and the instants at which it ends.

mod held;
mod passage;
mod signals;

pub(crate) use held::held;

use crate::compiled_system::{CompiledSystem, NotCompiled};
use derivations::scene::problem::Law;
use derivations::scene::switching::{Segment, Switching};
use integrators::Event;
use model::Model;
use signals::{Fall, Signals, Watch};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// The case of a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Case {
    /// Its expression is positive.
    On,
    /// It is negative.
    Off,
    /// It stays at zero, since either case drives it back: dry friction that sticks.
    Held,
}

/// The laws of a model by their modes, and the mode of a run.
pub struct Modes {
    model: Arc<Model>,
    known: Mutex<HashMap<Vec<Case>, Made>>,
    current: Mutex<Option<Current>>,
    ended: Arc<Ended>,
}

/// The events that ended runs, by the times of their ends.
#[derive(Debug, Default)]
pub(crate) struct Ended(Mutex<HashMap<u64, usize>>);

impl Ended {
    /// The event that ended a run at a time, by its place in the model.
    pub fn at(&self, time: f64) -> Option<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get(&time.to_bits()).copied()
    }

    fn keep(&self, time: f64, event: usize) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(time.to_bits(), event);
    }
}

/// The law in which a run is, and the sides of its events.
#[derive(Clone)]
struct Current {
    moded: Arc<Moded>,
    sides: Vec<f64>,
}

/// Why a motion does not start.
#[derive(Clone, Debug, PartialEq)]
pub enum Refused {
    /// No law can be written down.
    Law(NotCompiled),
    /// No case of the conditions, or more than one, agrees with the motion that it gives; with the first condition that is at zero.
    Motion { why: &'static str, switch: Option<usize> },
}

/// The law of a mode, or why there is none.
type Made = Result<Arc<Moded>, NotCompiled>;

/// The law of a mode, with the signals that end it.
pub(crate) struct Moded {
    pub system: Arc<CompiledSystem>,
    /// Made once: series and Jacobian serve every segment.
    law: Arc<dyn Law>,
    pub signals: Signals,
}

impl Modes {
    /// The modes of a model; laws are compiled when a run comes to them.
    pub fn of(model: &Arc<Model>) -> Self {
        Modes::telling(model, Arc::default())
    }

    /// The same, and each event that ends a run is kept.
    pub(crate) fn telling(model: &Arc<Model>, ended: Arc<Ended>) -> Self {
        Modes { model: Arc::clone(model), known: Mutex::default(), current: Mutex::default(), ended }
    }

    /// The law in a mode.
    ///
    /// # Errors
    /// Why there is none.
    pub(crate) fn moded(&self, mode: &[Case]) -> Result<Arc<Moded>, NotCompiled> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let made = known.entry(mode.to_vec()).or_insert_with(|| {
            let system = Arc::new(CompiledSystem::of(&self.model, mode)?);
            let signals = Signals::of(&self.model, mode)?;
            Ok(Arc::new(Moded { law: system.law(), system, signals }))
        });
        made.clone()
    }

    /// The law of a start.
    ///
    /// # Errors
    /// Why there is none.
    pub fn first(&self, state: &[f64]) -> Result<Arc<CompiledSystem>, Refused> {
        let off = vec![Case::Off; self.model.switches.len()];
        self.moded(&off).map_err(Refused::Law)?;
        let moded = self.at(0.0, state).map_err(|why| {
            let conditions = self.moded(&off).map(|moded| moded.signals.conditions(0.0, state)).unwrap_or_default();
            Refused::Motion { why, switch: conditions.iter().position(|[value, ..]| *value == 0.0) }
        })?;
        Ok(Arc::clone(&moded.system))
    }

    /// The law in which the run is, or was last.
    pub fn current(&self) -> Option<Arc<CompiledSystem>> {
        let current = self.current.lock().unwrap_or_else(PoisonError::into_inner);
        current.as_ref().map(|current| Arc::clone(&current.moded.system))
    }

    fn enter(&self, current: Current) -> Segment {
        let Current { moded, sides } = current.clone();
        *self.current.lock().unwrap_or_else(PoisonError::into_inner) = Some(current);
        Segment { law: Arc::clone(&moded.law), switches: Box::new(Watch { moded, sides }) }
    }
}

/// The side of each event's expression: by its value, or by its rate where it has just passed zero.
fn sides(moded: &Moded, time: f64, state: &[f64], passed: Option<(Fall, &[f64])>) -> Vec<f64> {
    let of = |(event, [value, rate]): (usize, [f64; 2])| {
        let at_zero = value == 0.0 || matches!(passed, Some((Fall::Event { event: own }, _)) if own == event);
        match (at_zero, passed) {
            (false, _) => value.signum(),
            (true, _) if rate != 0.0 => rate.signum(),
            (true, Some((_, before))) => before[event],
            (true, None) => 1.0,
        }
    };
    moded.signals.events(time, state).into_iter().enumerate().map(of).collect()
}

impl Switching for Modes {
    fn begin(&self, time: f64, state: &mut [f64]) -> Result<Segment, &'static str> {
        let moded = self.at(time, state)?;
        let sides = sides(&moded, time, state, None);
        Ok(self.enter(Current { moded, sides }))
    }

    fn pass(&self, event: &Event, state: &mut [f64]) -> Result<Option<Segment>, &'static str> {
        let before = self.current.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let Some(before) = before else { return Err("the run has no mode") };
        let fall = before.moded.signals.falls[event.signal];
        let Some(moded) = self.after(&before.moded, &before.sides, event, state)? else {
            if let Fall::Event { event: number } = fall {
                self.ended.keep(event.time, number);
            }
            return Ok(None);
        };
        let sides = sides(&moded, event.time, state, Some((fall, &before.sides)));
        Ok(Some(self.enter(Current { moded, sides })))
    }
}
