//! Modes of a hybrid model. A mode is the case of each condition and the phase of each contact; each mode has a law. This module compiles
//! the laws, detects the events that end them, and chooses the next mode.

mod accumulation;
mod algebraic;
mod combinations;
mod consistency;
mod contacts;
mod continuum;
mod course;
mod critical_friction;
mod decision;
mod distribution;
mod event_error;
mod exact;
mod expansion;
mod glides;
mod headings;
mod held;
mod held_forces;
mod jet;
mod mode;
mod mode_values;
mod motion;
mod multiples;
mod own_event;
mod passage;
mod pivots;
pub(crate) mod reasons;
mod regimes;
mod rests;
mod shares;
mod sides;
mod signal_integrals;
mod signals;
mod slip_start;
mod slowed;
mod touch;
mod touches;
mod unfit;
mod unknown_speeds;
mod words;

pub(crate) use algebraic::Parted;
pub(crate) use contacts::letters as reactions_of;
pub use course::RunTable;
pub(crate) use held::eliminated;
pub use mode::{Case, Face, Mode, Phase};
pub(crate) use motion::ModeMotion;

use crate::changing_laws::is_watched;
use crate::compiled_system::{CompiledSystem, NotCompiled};
use crate::constraint_projection::ConstraintProjection;
use crate::start::KeptConstraints;
use course::{Crossing, Leg, Sets};
use expansion::{Expansions, Instant};
use glides::Glide;
use integrators::{Event, Happening, Method};
pub(crate) use mode_values::{ModeValues, OF_CONTACT, lengths as mode_values_lengths, mode_values_at_start};
use model::Model;
use passage::After;
pub(crate) use reasons::BROKEN;
pub use regimes::{CriticalFriction, Margin, Motions, Regime, Regimes};
use sides::Side;
use signals::{Fall, GLIDE, Signals};
use simulation::Law;
use simulation::events::{Cause, Passage, Segment, Switching};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
pub(crate) use touches::NEGATIVE;
pub(crate) use unfit::RESTITUTION;
pub use unfit::Unfit;
use words::Words;

/// The compiled laws of a model, one for each mode that a run has entered.
pub struct Laws {
    model: Arc<Model>,
    known: Mutex<HashMap<Mode, Made>>,
    /// The Taylor series that decide modes, compiled when a mode is first decided.
    expansions: OnceLock<Result<Expansions, NotCompiled>>,
    /// The constraints that events must preserve, compiled when an event first sets a state.
    kept: OnceLock<KeptConstraints>,
    words: Words,
    /// The value of each condition where its expression is zero.
    at_zero: Vec<Option<bool>>,
}

/// The modes of one run: the present law, and the record of events.
pub struct Modes {
    laws: Arc<Laws>,
    current: Mutex<Option<Current>>,
    passages: Mutex<Vec<Passage>>,
    course: Mutex<Vec<Leg>>,
}

/// The present law of a run, with the state of the detection of its signals.
#[derive(Clone)]
struct Current {
    moded: Arc<Moded>,
    /// For each event, the side of zero on which its expression is.
    sides: Vec<Side>,
    /// For each condition that began at zero: the distance beyond zero up to which the decided law remains valid, due to errors of
    /// rounding and of the motion while the condition was held.
    near: Vec<f64>,
    /// These distances for each switch at 0 and at 1, and for the expression of each event.
    near_bounds: Vec<[f64; 2]>,
    near_events: Vec<f64>,
    /// These distances for each contact: for its gap or pressure, then for its two margins of friction or its sliding velocity.
    near_contacts: Vec<[f64; 3]>,
    /// The observation of each contact that slides in space.
    glides: Vec<Option<Glide>>,
    /// The determinant of the equations for the reactions at the start of the law.
    determinant: f64,
}

impl Current {
    /// The constants of the signals of all contacts that may slide in space.
    fn glide_letters(&self) -> Vec<f64> {
        let in_space = self.moded.signals.in_space.iter().map(|&contact| self.glides[contact]);
        in_space.flat_map(|glide| glide.map_or([0.0; GLIDE], |glide| glide.letters())).collect()
    }
}

/// The reason for which no motion starts from a state.
#[derive(Clone, Debug, PartialEq)]
pub enum Refused {
    /// The equations cannot be compiled.
    Law(NotCompiled),
    /// No mode, or more than one, is consistent with its motion. `switch` is the index of the first condition at zero.
    Motion { why: &'static str, switch: Option<usize> },
    /// The state violates a contact.
    Contact(Unfit),
}

/// The law of a mode, or the reason for which it cannot be compiled.
type Made = Result<Arc<Moded>, NotCompiled>;

/// The compiled law of a mode, with the signals that end it.
struct Moded {
    system: Arc<CompiledSystem>,
    /// The law for integrators, compiled once: all segments of runs share its series and Jacobian.
    law: Arc<dyn Law>,
    /// The number of signals that the law integrates as additional states.
    followed: usize,
    signals: Signals,
}

/// A text that determines all laws and events of a model, for fingerprints.
///
/// # Errors
/// The reason for which the equations cannot be compiled.
pub(crate) fn described(model: &Model) -> Result<String, NotCompiled> {
    let expansions = Expansions::of(model)?;
    let events = model.events.iter().map(|event| (event.direction, event.ends)).collect::<Vec<_>>();
    // with algebraic speeds, a mode that no run enters may have no law
    let sets = match model.algebraic_speeds.is_empty() {
        true => format!("{:?}", Signals::of(model, &Mode::off(model))?),
        false => format!("{:?}", signals::sets(model)),
    };
    Ok(format!("{expansions:?} {sets} {events:?}"))
}

impl Laws {
    /// The law of a mode, compiled on first use.
    ///
    /// # Errors
    /// The reason for which this mode has no law.
    fn moded(&self, mode: &Mode) -> Result<Arc<Moded>, NotCompiled> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let made = known.entry(mode.clone()).or_insert_with(|| {
            let system = Arc::new(CompiledSystem::of(&self.model, mode)?);
            let signals = Signals::of(&self.model, mode)?;
            let (law, followed) = signal_integrals::followed(&self.model, &system);
            let keeps_positions = ConstraintProjection::keeps_positions(&self.model);
            let in_touch = keeps_positions.then(|| mode.with_closed_contacts(&self.model));
            let projection = in_touch.and_then(|model| ConstraintProjection::of(&model)).map(Arc::new);
            let law = ConstraintProjection::onto(projection.as_ref(), law);
            Ok(Arc::new(Moded { law, followed, system, signals }))
        });
        made.clone()
    }

    fn kept(&self) -> &KeptConstraints {
        self.kept.get_or_init(|| KeptConstraints::of(&self.model))
    }

    fn expansions(&self) -> Result<&Expansions, NotCompiled> {
        self.expansions.get_or_init(|| Expansions::of(&self.model)).as_ref().map_err(Clone::clone)
    }
}

impl Modes {
    /// The modes of a model; laws are compiled when a run enters them. `events` are names for messages, `condition_lines` the lines of
    /// the conditions in the file.
    pub fn of(model: &Arc<Model>, events: &[String], condition_lines: &[usize]) -> Self {
        let model = model.with_smooth_contacts();
        Modes::with(Arc::new(Laws {
            known: Mutex::default(),
            expansions: OnceLock::new(),
            kept: OnceLock::new(),
            words: Words::of(&model, events, condition_lines),
            at_zero: (0..model.switches.len()).map(|switch| model.value_at_zero(switch)).collect(),
            model,
        }))
    }

    fn with(laws: Arc<Laws>) -> Self {
        Modes { laws, current: Mutex::default(), passages: Mutex::default(), course: Mutex::default() }
    }

    /// Modes for another run with shared laws.
    pub fn of_another_run(&self) -> Self {
        Modes::with(Arc::clone(&self.laws))
    }

    /// Records an event in the list of passages, with the next law, or with the end of the run.
    fn tell(
        &self,
        (time, state): (f64, &[f64]),
        (cause, what): (Cause, String),
        (by, goes_on): (&CompiledSystem, bool),
    ) {
        let then = goes_on.then(|| self.laws.words.mode(&by.mode));
        let row = [state, &by.outputs(time, state)].concat();
        self.passages.lock().unwrap_or_else(PoisonError::into_inner).push(Passage { time, cause, what, then, row });
    }

    /// Records an event after which no motion continues, with the reason.
    fn end(&self, before: &Current, (time, state): (f64, &[f64]), crossing: Crossing, why: &'static str) {
        let fall = before.moded.signals.falls.get(crossing.signal).copied();
        let (sets, fall) = match why {
            reasons::JAMS => (Sets::Jam, Some(Fall::Jams)),
            _ => (Sets::End, fall),
        };
        // a broken constraint has already been reported
        if why != reasons::BROKEN
            && let Some(fall) = fall
        {
            self.tell((time, state), (fall.cause(), self.laws.words.fall(fall)), (&before.moded.system, false));
        }
        self.follow(Some(Crossing { sets, ..crossing }), before);
    }

    /// Records a law of the run with the event that led to it.
    fn follow(&self, cause: Option<Crossing>, current: &Current) {
        let moded = Arc::clone(&current.moded);
        let begins_to_glide = current.glides.iter().flatten().any(|glide| glide.doubling().is_some());
        let leg = Leg { cause, moded, glides: current.glide_letters(), begins_to_glide };
        self.course.lock().unwrap_or_else(PoisonError::into_inner).push(leg);
    }

    /// The law of the motion from a state at time zero.
    ///
    /// # Errors
    /// [`Refused`] if no motion, or more than one, starts from the state.
    pub fn first(&self, state: &[f64]) -> Result<Arc<CompiledSystem>, Refused> {
        self.law_from(0.0, state)
    }

    /// The law of the motion from a state at a time in s.
    ///
    /// # Errors
    /// [`Refused`] if no motion, or more than one, starts from the state.
    pub fn law_from(&self, time: f64, state: &[f64]) -> Result<Arc<CompiledSystem>, Refused> {
        let model = &self.laws.model;
        CompiledSystem::has_equations(model).map_err(Refused::Law)?;
        // with algebraic speeds, a mode that no run enters may have no law
        if model.algebraic_speeds.is_empty() {
            let moded = self.laws.moded(&Mode::off(model)).map_err(Refused::Law)?;
            if !is_watched(model) {
                return Ok(Arc::clone(&moded.system));
            }
        }
        let expansions = self.laws.expansions().map_err(Refused::Law)?;
        let instant = Instant::at(time, state);
        if let Ok(cases) = self.cases_next(&instant)
            && let Some(unfit) = Unfit::first(expansions, &instant, &cases)
        {
            return Err(Refused::Contact(unfit));
        }
        let begun =
            self.begun(time, state).map_err(|why| Refused::Motion { why, switch: self.at_zero(time, state) })?;
        Ok(Arc::clone(&begun.moded.system))
    }

    /// The current law of the run; after its end, the last.
    pub fn current(&self) -> Option<Arc<CompiledSystem>> {
        let current = self.current.lock().unwrap_or_else(PoisonError::into_inner);
        current.as_ref().map(|current| Arc::clone(&current.moded.system))
    }

    /// The index of the first condition that the current law keeps at zero.
    pub fn held_condition(&self) -> Option<usize> {
        self.current()?.mode.cases.iter().position(|case| case.rests())
    }

    /// True if two laws differ only in the distribution of voltage among diodes that block together.
    fn only_shares(&self, before: &Current, after: &Current) -> bool {
        let [before, after] = [before, after].map(|current| &current.moded.system.mode);
        let kinds = &self.laws.model.contacts;
        let mut phases = before.phases.iter().zip(&after.phases).zip(kinds);
        let blocks = |phase: &Phase| *phase != Phase::Apart;
        before.cases == after.cases
            && phases.all(|((now, then), kind)| now == then || kind.one_way.is_some() && blocks(now) && blocks(then))
    }

    fn enter(&self, current: Current) -> Segment {
        *self.current.lock().unwrap_or_else(PoisonError::into_inner) = Some(current.clone());
        let Moded { law, followed, .. } = &*current.moded;
        let (law, longest_first) = slip_start::from_rest(&current, Arc::clone(law));
        Segment { law, followed: *followed, longest_first, switches: Box::new(current) }
    }
}

impl Switching for Modes {
    fn begin(&self, time: f64, state: &mut [f64]) -> Result<Segment, &'static str> {
        self.passages.lock().unwrap_or_else(PoisonError::into_inner).clear();
        self.course.lock().unwrap_or_else(PoisonError::into_inner).clear();
        let begun = self.begun(time, state)?;
        begun.moded.system.set_algebraic_speeds(time, state);
        self.push_off(time, state, &begun);
        self.tell((time, state), (Cause::Start, "start".to_owned()), (&begun.moded.system, true));
        self.follow(None, &begun);
        Ok(self.enter(begun))
    }

    fn pass(&self, event: &Event, state: &mut [f64]) -> Result<Option<Segment>, &'static str> {
        let before = self.current.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let Some(before) = before else { return Err("the run has no mode") };
        let fall = before.moded.signals.falls[event.signal];
        let crossing = |sets| Some(Crossing { time: event.time, signal: event.signal, what: event.what, sets });
        let rest = Self::rest_of_a_glide(&before, event, state);
        let at_event = state.to_vec();
        let after = self.after(&before, event, state).inspect_err(|why| {
            let crossing = Crossing { time: event.time, signal: event.signal, what: event.what, sets: Sets::End };
            self.end(&before, (event.time, &at_event), crossing, why);
        });
        match after? {
            After::Unchanged(current) => {
                self.follow(crossing(Sets::Unseen), &current);
                Ok(Some(self.enter(current)))
            }
            After::Changed(current, Sets::Nothing) if self.only_shares(&before, &current) => {
                self.follow(crossing(Sets::Unseen), &current);
                Ok(Some(self.enter(current)))
            }
            After::Changed(current, sets) => {
                let (time, fall) = match sets {
                    Sets::Rest { contact, .. } => (event.time + rest, Fall::Stops { contact }),
                    _ => (event.time, fall),
                };
                self.tell((time, state), (fall.cause(), self.laws.words.fall(fall)), (&current.moded.system, true));
                self.follow(crossing(sets), &current);
                Ok(Some(self.enter(current)))
            }
            After::Ended => {
                self.tell(
                    (event.time, state),
                    (fall.cause(), self.laws.words.fall(fall)),
                    (&before.moded.system, false),
                );
                self.follow(crossing(Sets::End), &before);
                Ok(None)
            }
        }
    }

    fn refuses(&self, method: Method) -> Option<&'static str> {
        let slides = self.laws.model.contacts.iter().any(|contact| contact.is_in_space());
        (slides && method == Method::BaderDeuflhard).then_some(reasons::STEPS_OVER_REST)
    }

    fn obstacle(&self, time: f64, state: &[f64]) -> Option<&'static str> {
        let current = self.current.lock().unwrap_or_else(PoisonError::into_inner).clone()?;
        let jams = self.jams(&current, time, state);
        if jams {
            let crossing = Crossing { time, signal: 0, what: Happening::Falls, sets: Sets::Jam };
            self.end(&current, (time, state), crossing, reasons::JAMS);
        }
        jams.then_some(reasons::JAMS)
    }

    fn passages(&self) -> Vec<Passage> {
        self.passages.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}
