//! Runs of systems whose law changes at events: a sequence of segments, each ending at a located event.

use super::continuation::Continuation;
use super::law_end::{Ending, Ends, Margins, SwitchesAndEnds};
use super::poles::{PoleWatch, up_to};
use super::trail::{Instant, Trail};
use crate::law::Law;
use integrators::{
    Absolute, Deviation, End, Event, Failure, Method, Observer, Outcome, Span, Switches, System, Tolerance, Work,
    integrate_to_event,
};
use std::sync::Arc;

/// A law that is valid until one of its switches falls.
pub struct Segment {
    /// The law; further components may follow the state of the system, see `followed`.
    pub law: Arc<dyn Law>,
    /// The number of components that integrate the rates of signals, each zero at the beginning of the segment. Methods
    /// resolve them like the state. Without them the steps of a body at rest would grow beyond the period of the force
    /// that sets it in motion.
    pub followed: usize,
    /// The largest first step (s), for a law that changes rapidly from its initial state.
    pub longest_first: Option<f64>,
    pub switches: Box<dyn Switches>,
}

/// The kind of an event of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    Start,
    /// The expression of a condition reaches or leaves zero.
    Condition,
    /// A contact, a diode or a freewheel closes, opens, sticks or slides.
    Contact,
    /// An event that the model defines.
    Own,
    /// The motion goes on through a singular position of the constraints.
    SingularPosition,
}

/// A change of a law, or of a state, along a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Passage {
    pub time: f64,
    pub cause: Cause,
    /// The event, in words.
    pub what: String,
    /// The subsequent law, as text; `None` where the motion ends.
    pub then: Option<String>,
    /// The row of the run after the event, by the subsequent law.
    pub row: Vec<f64>,
}

/// A system whose law or state changes at events.
pub trait Switching: Send + Sync {
    /// The law that is valid from `time` (s) on. An event at that time may change the state.
    ///
    /// # Errors
    /// The reason why the motion is not determined.
    fn begin(&self, time: f64, state: &mut [f64]) -> Result<Segment, &'static str>;

    /// The law after an event; changes the state. `None` where the motion ends with the event.
    ///
    /// # Errors
    /// The reason why no motion follows.
    fn pass(&self, event: &Event, state: &mut [f64]) -> Result<Option<Segment>, &'static str>;

    /// The reason why a method cannot integrate these laws; `None` where it can.
    fn refuses(&self, _method: Method) -> Option<&'static str> {
        None
    }

    /// The reason why no method can continue from a state, if the law gives one.
    fn obstacle(&self, _time: f64, _state: &[f64]) -> Option<&'static str> {
        None
    }

    /// The start and the events of the present or last run.
    fn passages(&self) -> Vec<Passage> {
        Vec::new()
    }
}

/// A run is given up where this number of events takes less than a part of its span: switching at a fixed frequency goes on, chattering ends.
const MANY_EVENTS: usize = 20_000;
const SHORT: f64 = 0.02;

/// After this many events in a row within a rounding of the time, their times count as having a limit.
const MOST_TOGETHER: usize = 64;

/// The reason of a run that ends where its events accumulate.
pub const ACCUMULATE: &str = "the events accumulate: infinitely many occur in a finite time";

/// Why a run ends where events follow each other too fast.
pub const TOO_MANY: &str = "20,000 events follow each other within 2 % of the span";

/// Integrates over a span across events while the margins are positive. With `goes_on`, singular positions are passed
/// on the smooth branch. Returns the reason if the motion ends before the span.
pub(crate) fn integrate(
    (switching, margins): (&dyn Switching, &Margins),
    (method, tolerance): (Method, &Tolerance),
    span: &Span<'_, f64>,
    observer: &mut dyn Observer<f64>,
    goes_on: bool,
) -> (Outcome<f64>, Option<&'static str>) {
    let mut at = Outcome {
        end: End::Halted,
        time: span.start,
        state: span.state.clone(),
        work: Work::default(),
        deviations: Vec::new(),
    };
    if let Some(why) = switching.refuses(method) {
        return (at, Some(why));
    }
    let mut segment = match switching.begin(at.time, &mut at.state) {
        Ok(segment) => segment,
        Err(why) => return (at, Some(why)),
    };
    let (mut together, mut sampled) = (0, 0);
    let mut trail = goes_on.then(Trail::default);
    let mut counted_from = span.start;
    for number in 0_usize.. {
        let here = at.time;
        if number > 0 && number.is_multiple_of(MANY_EVENTS) {
            if (here - counted_from).abs() < SHORT * (span.end - span.start).abs() {
                break;
            }
            counted_from = here;
        }
        // the instant of an event is shown once, on one of its sides
        let outputs: Vec<f64> = span.outputs[sampled..].iter().filter(|time| **time >= here).copied().collect();
        let states = at.state.len();
        at.state.resize(states + segment.followed, 0.0);
        let mut rest = Span::new(here, span.end, &at.state).with_outputs(&outputs);
        rest.budget = span.budget;
        rest.longest_first = segment.longest_first;
        rest.budget.evaluations = span.budget.evaluations.saturating_sub(at.work.rates);
        if rest.budget.evaluations == 0 {
            at.state.truncate(states);
            return (Outcome { end: spent(here, span), ..at }, None);
        }
        for monitor in &span.monitors {
            rest = rest.with_monitor(&monitor.name, move |time, state| (monitor.value)(time, &state[..states]));
            if let Some(size) = &monitor.size {
                rest = rest.beside(move |time, state| size(time, &state[..states]));
            }
        }
        let whole = span.end - span.start;
        let done = (here - span.start) / whole;
        let share = (span.end - here) / whole;
        let ends = Ends::of(Ending { law: &*segment.law, margins }, here, &at.state[..states], segment.followed);
        let switches = SwitchesAndEnds { switches: &*segment.switches, ends };
        let tolerance = with_followed(tolerance, segment.followed);
        if let Some((margin, rate)) = switches.beside(here, &at.state) {
            let begin = (here, at.state.clone());
            at.state.truncate(states);
            let found = (rate > 0.0 || goes_on)
                .then(|| from_beside((&*segment.law, &tolerance), (&begin, rate), whole, &switches))
                .flatten();
            let Some(found) = found else { return (at, Some(margin.what)) };
            sampled += moved(&mut at, &found, (&outputs, span.end), observer);
            if at.time == span.end {
                return (Outcome { end: End::Reached, ..at }, None);
            }
            continue;
        }
        if let Some(trail) = &mut trail {
            trail.restart(here, &at.state);
        }
        let mut part = Part { observer, states, sampled: &mut sampled, done, share, trail: trail.as_mut() };
        let mut watch = PoleWatch::new((&*segment.law, &tolerance), (here, &at.state), &mut part);
        let (mut outcome, event) = integrate_to_event(&*segment.law, method, &tolerance, &rest, &switches, &mut watch);
        let pole = watch.end(&outcome);
        let whole_state = outcome.state.clone();
        outcome.state.truncate(states);
        at = joined(at, outcome);
        if let Some((time, mut state, why)) = pole {
            state.truncate(states);
            return (up_to(at, (time, state)), Some(why));
        }
        if let End::Stopped(Failure::TooManyEvaluations { at: time, .. }) = at.end {
            at.end = spent(time, span);
        }
        let Some(event) = event else {
            let failed = matches!(at.end, End::Stopped(failure) if !failure.is_broken_off());
            let why = if failed { switching.obstacle(at.time, &at.state) } else { None };
            return (at, why);
        };
        if let Some(margin) = switches.end(&event, &at.state) {
            let met = (event.time, &whole_state[..]);
            let beyond = |trail: &Trail| Continuation::of((&*segment.law, &tolerance), trail, met, &switches);
            let beyond = trail.as_ref().filter(|_| margin.goes_on).and_then(|trail| {
                beyond(trail).or_else(|| beyond(&trail.extended(&*segment.law, event.time, &switches)?))
            });
            let Some(beyond) = beyond else { return (at, Some(margin.what)) };
            sampled += moved(&mut at, &beyond, (&outputs, span.end), observer);
            if at.time == span.end {
                return (Outcome { end: End::Reached, ..at }, None);
            }
            continue;
        }
        together = if at.time - here <= 8.0 * f64::EPSILON * at.time.abs() { together + 1 } else { 0 };
        if together > MOST_TOGETHER {
            return (at, Some(ACCUMULATE));
        }
        segment = match switching.pass(&event, &mut at.state) {
            Ok(Some(segment)) if at.time != span.end => segment,
            Ok(_) => return (Outcome { end: End::Reached, ..at }, None),
            Err(why) => return (at, Some(why)),
        };
    }
    (at, Some(TOO_MANY))
}

/// The motion from a start near a singular position, where the margin has the given rate, to where the law determines
/// it. `None` where the rounding of the start decides about it.
fn from_beside<'a>(
    (law, tolerance): (&'a dyn System, &Tolerance),
    (begin, rate): (&Instant, f64),
    span: f64,
    switches: &SwitchesAndEnds<'_>,
) -> Option<Continuation<'a>> {
    let motion = |begin: &Instant| match rate > 0.0 {
        true => Continuation::leaving((law, tolerance), begin, span, switches),
        false => Trail::before(law, begin, span, switches)
            .and_then(|trail| Continuation::of((law, tolerance), &trail, (begin.0, &begin.1), switches)),
    };
    let found = motion(begin)?;
    let largest = begin.1.iter().fold(0.0, |largest: f64, part| largest.max(part.abs()));
    let mut rounded = begin.clone();
    for (place, part) in rounded.1.iter_mut().enumerate() {
        // fractions of both signs that are no multiples of each other
        let by = ((place + 1) as f64 * 0.618_033_988_749_894_9).fract() * 2.0 - 1.0;
        *part += 2.0 * f64::EPSILON * largest * by;
    }
    if let Some(projection) = law.projection() {
        projection.project(rounded.0, &mut rounded.1);
    }
    found.agrees(&motion(&rounded)?, tolerance).then_some(found)
}

/// The end of a run that has exhausted its evaluations.
fn spent(at: f64, span: &Span<'_, f64>) -> End {
    End::Stopped(Failure::TooManyEvaluations { at, allowed: span.budget.evaluations })
}

/// Moves a run along a continuation, at most to the end of the span. Returns the number of reported samples.
fn moved(
    at: &mut Outcome<f64>,
    beyond: &Continuation<'_>,
    (outputs, end): (&[f64], f64),
    observer: &mut dyn Observer<f64>,
) -> usize {
    let (states, is_last) = (at.state.len(), (end - at.time).abs() <= (beyond.time - at.time).abs());
    let time = if is_last { end } else { beyond.time };
    let shown = beyond.show(outputs, (at.time, time), states, observer);
    at.state = beyond.at(time)[..states].to_vec();
    at.time = time;
    shown
}

/// The tolerance for a state followed by integrals of rates of signals, which are of size one.
fn with_followed(tolerance: &Tolerance, followed: usize) -> Tolerance {
    let mut tolerance = tolerance.clone();
    if let Absolute::Each(each) = &mut tolerance.absolute {
        each.resize(each.len() + followed, tolerance.relative);
    }
    tolerance
}

/// Joins two consecutive parts of a run.
fn joined(before: Outcome<f64>, after: Outcome<f64>) -> Outcome<f64> {
    let mut deviations = after.deviations;
    for (later, earlier) in deviations.iter_mut().zip(before.deviations) {
        // the first value is that of the whole run
        let moved = later.largest + (later.first - earlier.first).abs();
        let lost = earlier.lost.or(later.lost);
        *later = match moved > earlier.largest {
            true => Deviation { first: earlier.first, largest: moved, lost, ..later.clone() },
            false => Deviation { lost, ..earlier },
        };
    }
    Outcome { work: before.work + after.work, deviations, ..after }
}

/// An observer that removes the further components of the state, and converts progress to that of the whole run.
struct Part<'a> {
    observer: &'a mut dyn Observer<f64>,
    states: usize,
    /// The number of reported samples.
    sampled: &'a mut usize,
    done: f64,
    share: f64,
    /// The last steps, for the continuation beyond a singular position.
    trail: Option<&'a mut Trail>,
}

impl Observer<f64> for Part<'_> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        *self.sampled += 1;
        self.observer.sample(time, &state[..self.states]);
    }

    fn step(&mut self, time: f64, state: &[f64]) {
        if let Some(trail) = &mut self.trail {
            trail.step(time, state);
        }
        self.observer.step(time, &state[..self.states]);
    }

    fn progress(&mut self, fraction: f64) {
        self.observer.progress(self.done + fraction * self.share);
    }

    fn enough(&self) -> bool {
        self.observer.enough()
    }
}
