//! Modes of a model: the case of each of its conditions, the law that holds there, and the instants at which it ends.

mod decision;
mod expansion;
mod held;
mod jet;
mod multiples;
mod passage;
mod pivots;
mod shares;
mod sides;
mod signal_integrals;
mod signals;

pub(crate) use held::held;

use crate::compiled_system::{CompiledSystem, NotCompiled};
use derivations::scene::problem::Law;
use derivations::scene::switching::{Segment, Switching};
use expansion::Expansions;
use integrators::Event;
use model::Model;
use sides::Side;
use signals::{Fall, Signals};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The case of a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Case {
    /// Its expression is positive.
    On,
    /// It is negative.
    Off,
    /// It stays at zero, since either case drives it back: dry friction that sticks.
    Held,
    /// It stays at zero since conditions that are held imply it; its switch takes a part of what keeps them there.
    Shared,
    /// The same, and its switch stays at 1 (on) or at 0, since its part would be larger.
    Spent { on: bool },
}

impl Case {
    /// Whether the condition stays at zero.
    fn rests(self) -> bool {
        !matches!(self, Case::On | Case::Off)
    }

    /// Whether the switch is 1, where the case says it, or 0.
    fn fixed(self) -> Option<bool> {
        match self {
            Case::On | Case::Spent { on: true } => Some(true),
            Case::Off | Case::Spent { on: false } => Some(false),
            Case::Held | Case::Shared => None,
        }
    }
}

/// The laws of a model by their modes, and the mode of a run.
pub struct Modes {
    model: Arc<Model>,
    known: Mutex<HashMap<Vec<Case>, Made>>,
    /// Made when a mode is first decided.
    expansions: OnceLock<Result<Expansions, NotCompiled>>,
    current: Mutex<Option<Current>>,
    ended: Arc<Ended>,
}

/// The events that ended runs, by the times of their ends.
#[derive(Debug, Default)]
pub(crate) struct Ended(Mutex<HashMap<u64, End>>);

/// An event that ended a run, by its place in the model.
#[derive(Clone, Debug)]
pub(crate) struct End {
    pub event: usize,
    /// The constraint that it breaks, where it does, with the residual.
    pub breaks: Option<String>,
}

impl Ended {
    /// The end of a run at a time.
    pub fn at(&self, time: f64) -> Option<End> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get(&time.to_bits()).cloned()
    }

    fn keep(&self, time: f64, end: End) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(time.to_bits(), end);
    }
}

/// The law in which a run is, and what is known of the zeros of its signals.
#[derive(Clone)]
struct Current {
    moded: Arc<Moded>,
    /// The side of each event.
    sides: Vec<Side>,
    /// The distance beyond zero at which each condition counts as passed, where it began at zero: errors of rounding, and of the
    /// motion while it was held. The law to which it has been decided to move holds so far.
    near: Vec<f64>,
    /// The same for the distances of each switch from 0 and from 1, and for the expression of each event.
    near_bounds: Vec<[f64; 2]>,
    near_events: Vec<f64>,
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
struct Moded {
    system: Arc<CompiledSystem>,
    /// Made once: series and Jacobian serve every segment.
    law: Arc<dyn Law>,
    /// The number of signals that the law follows beside the state.
    followed: usize,
    signals: Signals,
}

impl Modes {
    /// The modes of a model; laws are compiled when a run comes to them.
    pub fn of(model: &Arc<Model>) -> Self {
        Modes::telling(model, Arc::default())
    }

    /// The same, and each event that ends a run is kept.
    pub(crate) fn telling(model: &Arc<Model>, ended: Arc<Ended>) -> Self {
        Modes {
            model: Arc::clone(model),
            known: Mutex::default(),
            expansions: OnceLock::new(),
            current: Mutex::default(),
            ended,
        }
    }

    /// The law in a mode.
    ///
    /// # Errors
    /// Why there is none.
    fn moded(&self, mode: &[Case]) -> Result<Arc<Moded>, NotCompiled> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let made = known.entry(mode.to_vec()).or_insert_with(|| {
            let system = Arc::new(CompiledSystem::of(&self.model, mode)?);
            let signals = Signals::of(&self.model, mode)?;
            let (law, followed) = signal_integrals::followed(&self.model, &system);
            Ok(Arc::new(Moded { law, followed, system, signals }))
        });
        made.clone()
    }

    /// The law of a start.
    ///
    /// # Errors
    /// Why there is none.
    pub fn first(&self, state: &[f64]) -> Result<Arc<CompiledSystem>, Refused> {
        let off = vec![Case::Off; self.model.switches.len()];
        let moded = self.moded(&off).map_err(Refused::Law)?;
        if self.model.switches.is_empty() && self.model.events.is_empty() {
            return Ok(Arc::clone(&moded.system));
        }
        self.expansions().map_err(Refused::Law)?;
        let begun = self.begun(0.0, state).map_err(|why| Refused::Motion { why, switch: self.at_zero(0.0, state) })?;
        Ok(Arc::clone(&begun.moded.system))
    }

    /// The law in which the run is, or was last.
    pub fn current(&self) -> Option<Arc<CompiledSystem>> {
        let current = self.current.lock().unwrap_or_else(PoisonError::into_inner);
        current.as_ref().map(|current| Arc::clone(&current.moded.system))
    }

    fn enter(&self, current: Current) -> Segment {
        *self.current.lock().unwrap_or_else(PoisonError::into_inner) = Some(current.clone());
        let Moded { law, followed, .. } = &*current.moded;
        Segment { law: Arc::clone(law), followed: *followed, switches: Box::new(current) }
    }
}

impl Switching for Modes {
    fn begin(&self, time: f64, state: &mut [f64]) -> Result<Segment, &'static str> {
        Ok(self.enter(self.begun(time, state)?))
    }

    fn pass(&self, event: &Event, state: &mut [f64]) -> Result<Option<Segment>, &'static str> {
        let before = self.current.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let Some(before) = before else { return Err("the run has no mode") };
        let fall = before.moded.signals.falls[event.signal];
        let after = self.after(&before, event, state)?;
        if let (Fall::Event { event: number }, None) = (fall, &after) {
            self.ended.keep(event.time, End { event: number, breaks: None });
        }
        Ok(after.map(|current| self.enter(current)))
    }
}
