//! Event location: runs that end where a signal falls through zero, located to rounding.
//!
//! A step is examined when it is accepted. Value and rate of a signal at both ends bound it over the step ([`bounds`]), with a
//! doubt that follows from the step before and from how far the signal bends. Where the bounds leave open whether there is a
//! zero, the motion is computed again to the middle of the step, by the same method, and both halves are examined: a step may
//! be as long as its method likes, and have several zeros. The event is computed in this way too, not interpolated: its state
//! is as accurate as any state of the run. The Taylor method's step is a polynomial as accurate as its end: there a trial is
//! one sum, and a step is examined in parts from the start.

mod again;
mod bounds;
mod distances;
mod gap;
mod search;

use crate::{End, Failure, Method, Observer, Outcome, Span, System, Tolerance, Work, integrate};
use again::Again;
pub use distances::Pace;
use search::{Search, Seen, look};

/// A signal: its value, its rate along the motion, and the noise up to which a value counts as zero.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Signal {
    pub value: f64,
    pub rate: f64,
    pub noise: f64,
    /// For the square of a distance of the order of one, which may come down to zero and rise again in less than a
    /// step: bounds of the rate of the distance. Zero where values and rates at the ends of a step show enough.
    pub pace: Pace,
}

/// Signals that are watched. Each counts from the time at which it was first positive: one that starts at zero may rise
/// first.
pub trait Switches {
    /// The number of signals.
    fn count(&self) -> usize;

    /// The values of all signals at a state; `out` has their count.
    fn signals(&self, time: f64, state: &[f64], out: &mut [Signal]);

    /// Whether the fall of a signal must be reported at a state where the signal is still positive, a rounding before its zero: a law may
    /// end with it.
    fn ends_above(&self, _signal: usize) -> bool {
        false
    }

    /// Whether the time of the fall of a signal matters: where it lies in a gap of the law, and cannot be computed, the run ends before it.
    /// Other signals count as fallen by the end of the step.
    fn is_timed(&self, _signal: usize) -> bool {
        false
    }
}

/// The way in which a signal met zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Happening {
    /// The signal fell through zero.
    Falls,
    /// The signal came down to zero, within its noise, and rose again.
    Touches,
    /// The signal was zero or negative at the start, and negative then, without having been positive.
    StartsBelow,
}

/// The event with which a run ended before its span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// The number of the signal.
    pub signal: usize,
    pub what: Happening,
    pub time: f64,
}

/// Integrates until the first event, or to the end of the span, or to a failure. The outcome's state is that of the
/// event. The observer sees nothing beyond it.
pub fn integrate_to_event(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    span: &Span<'_, f64>,
    switches: &dyn Switches,
    observer: &mut dyn Observer<f64>,
) -> (Outcome<f64>, Option<Event>) {
    let count = switches.count();
    let mut guard = Guard {
        again: Again {
            system,
            // a constant step, made again, is one step
            method: method.once(),
            tolerance,
            switches,
            evaluations: span.budget.evaluations,
            series: if method == Method::Taylor { system.taylor() } else { None },
            expanded_at: None,
            is_blocked: false,
            extra: Work::default(),
        },
        observer,
        armed: vec![false; count],
        earlier: None,
        before: Instant::of(switches, span.start, &span.state),
        after: Instant::of(switches, span.start, &span.state),
        parts: Vec::new(),
        known: Vec::new(),
        samples: Vec::new(),
        found: None,
        long: LONG * (span.end - span.start).abs(),
        lost: None,
    };
    guard.arm();
    let mut outcome = integrate(system, method, tolerance, span, &mut guard);
    outcome.work = outcome.work + guard.again.extra;
    if outcome.failure().is_some_and(|failure| !failure.is_broken_off()) {
        guard.found = guard.event_at_its_end();
    }
    let Some((event, state)) = guard.found else {
        let outcome = match guard.lost {
            Some(Instant { time, state, .. }) => {
                Outcome { end: End::Stopped(Failure::LeftTheNumbers { at: time }), time, state, ..outcome }
            }
            None => outcome,
        };
        return (outcome, None);
    };
    (outcome.end, outcome.time, outcome.state) = (End::Halted, event.time, state);
    (outcome, Some(event))
}

/// An event with its state.
type Found = (Event, Vec<f64>);

/// Times that differ by at most so many roundings are equal.
const TOGETHER: f64 = 8.0;

/// A signal that falls to zero within so many roundings of the time at which steps collapse has come to it: where rates are infinite at
/// the zero, as those of a square root are, no step reaches it.
const AT_THE_END: f64 = 256.0;

/// The number of parts in which a polynomial step is examined.
const PARTS: usize = 8;

/// Halvings of a step, or of such a part, over which a distance may come to zero by the bound of its rate.
const MOST_HALVED: u32 = 8;

/// A first step is long beyond this part of the span, and the doubt of a signal over it is this part of its values.
const LONG: f64 = 1e-3;
const UNKNOWN: f64 = 0.5;

/// A state with its signals.
#[derive(Clone, Debug)]
struct Instant {
    time: f64,
    state: Vec<f64>,
    signals: Vec<Signal>,
}

impl Instant {
    fn of(switches: &dyn Switches, time: f64, state: &[f64]) -> Self {
        let mut signals = vec![Signal::default(); switches.count()];
        switches.signals(time, state, &mut signals);
        Instant { time, state: state.to_vec(), signals }
    }

    fn move_to(&mut self, switches: &dyn Switches, time: f64, state: &[f64]) {
        self.time = time;
        self.state.copy_from_slice(state);
        switches.signals(time, state, &mut self.signals);
    }
}

/// The observer between the run and its own observer: it examines each step first.
struct Guard<'a> {
    again: Again<'a>,
    observer: &'a mut dyn Observer<f64>,
    /// Whether each signal was positive before.
    armed: Vec<bool>,
    /// The beginning of the interval before this one.
    earlier: Option<Instant>,
    before: Instant,
    after: Instant,
    /// The state within the step, where the method gives it.
    parts: Vec<Instant>,
    /// Instants within the interval, computed again.
    known: Vec<Instant>,
    /// Outputs of the step that was not examined yet.
    samples: Vec<(f64, Vec<f64>)>,
    found: Option<Found>,
    /// The length of a first step beyond which it is doubtful: no step before it shows how the signals bend, and they may
    /// oscillate within.
    long: f64,
    /// The last instant before a zero that cannot be computed.
    lost: Option<Instant>,
}

impl Guard<'_> {
    fn arm(&mut self) {
        for (armed, signal) in self.armed.iter_mut().zip(&self.before.signals) {
            *armed |= signal.value > signal.noise;
        }
    }

    /// Whether the run ends in this step.
    fn is_over(&self) -> bool {
        self.found.is_some() || self.lost.is_some()
    }

    /// Moves to the interval that begins where the last one ends.
    fn go_on(&mut self) {
        let begin = self.earlier.get_or_insert_with(|| self.before.clone());
        std::mem::swap(begin, &mut self.before);
        std::mem::swap(&mut self.before, &mut self.after);
        self.arm();
    }

    /// The signal that is zero within the rounding of times at the last state, beyond which no step is possible.
    fn event_at_its_end(&self) -> Option<Found> {
        let Instant { time, state, signals } = &self.before;
        let direction = (time - self.earlier.as_ref()?.time).signum();
        let rounding = AT_THE_END * f64::EPSILON * time.abs();
        let is_at_zero = |signal: &usize| {
            let Signal { value, rate, .. } = signals[*signal];
            self.armed[*signal] && value <= -direction * rate * rounding
        };
        let signal = (0..signals.len()).find(is_at_zero)?;
        Some((Event { signal, what: Happening::Falls, time: *time }, state.clone()))
    }

    /// Whether an event comes before another. If two fall together within rounding, as at the stops of both ends of one rod,
    /// the one whose signal is steeper relative to its noise counts first: its time is known better.
    fn comes_before(&self, (event, state): &Found, (known, known_state): &Found) -> bool {
        let rounding = TOGETHER * f64::EPSILON * event.time.abs().max(known.time.abs());
        if (event.time - known.time).abs() > rounding {
            let direction = (self.after.time - self.before.time).signum();
            return (event.time - known.time) * direction < 0.0;
        }
        let steepness = |event: &Event, state: &[f64]| {
            let Signal { rate, noise, .. } = Instant::of(self.again.switches, event.time, state).signals[event.signal];
            rate.abs() / noise
        };
        steepness(event, state) > steepness(known, known_state)
    }

    /// Examines the interval between the two instants, in halves while a distance may come to zero within; then the interval
    /// is the last of them.
    fn look(&mut self, step: &Instant, halvings: u32) {
        if halvings > 0 && distances::are_open(&self.before, &self.after) {
            let length = self.after.time - self.before.time;
            // the motion may not be computed again beyond where the distance is zero
            let mut parts = (1..=halvings).map(|k| self.before.time + length / f64::from(1_u32 << k));
            if let Some(middle) = parts.find_map(|time| self.again.at(step, &self.before, time)) {
                let end = std::mem::replace(&mut self.after, middle);
                self.look(step, halvings - 1);
                if !self.is_over() {
                    self.go_on();
                    self.after = end;
                    self.look(step, halvings - 1);
                }
                return;
            }
        }
        self.found = self.first_event(step);
    }

    /// The first event between the two instants, within the step that began at another.
    fn first_event(&mut self, step: &Instant) -> Option<Found> {
        self.known.clear();
        let mut first: Option<Found> = None;
        for signal in 0..self.armed.len() {
            let ends = [&self.before, &self.after];
            if self.armed[signal] && distances::stays_off(ends, signal) {
                continue;
            }
            let earlier = self.earlier.as_ref().map(|at| (at.signals[signal], at.time));
            let mut doubt = Search::doubt(earlier, ends.map(|at| (at.signals[signal], at.time)));
            let length = (self.after.time - self.before.time).abs();
            if self.earlier.is_none() && length > self.long {
                let [a, b] = ends.map(|at| at.signals[signal]);
                let noise = a.noise.max(b.noise);
                let rests = [length * a.rate, length * b.rate, b.value - a.value].iter().all(|by| by.abs() <= noise);
                doubt = if rests { doubt } else { doubt.max(UNKNOWN * a.value.abs().max(b.value.abs())) };
            }
            let mut search = Search { again: &mut self.again, step, known: &mut self.known, signal };
            match look(&mut search, ends, self.armed[signal], doubt) {
                Seen::Nothing { armed } => self.armed[signal] = armed,
                // an event before it in the step could not be distinguished from it
                Seen::Lost(last) => self.lost = Some(last),
                Seen::Happened(event, state) => {
                    let found = (event, state);
                    if first.as_ref().is_none_or(|known| self.comes_before(&found, known)) {
                        first = Some(found);
                    }
                }
            }
        }
        first
    }
}

impl Observer<f64> for Guard<'_> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        if time == self.before.time {
            self.observer.sample(time, state);
        } else {
            self.samples.push((time, state.to_vec()));
        }
    }

    fn between(&mut self, begin: f64, end: f64, state_at: &dyn Fn(f64, &mut [f64])) {
        self.parts.resize(PARTS - 1, self.before.clone());
        let mut state = self.before.state.clone();
        for (number, part) in self.parts.iter_mut().enumerate() {
            let time = begin + (end - begin) * (number + 1) as f64 / PARTS as f64;
            state_at(time, &mut state);
            part.move_to(self.again.switches, time, &state);
        }
    }

    fn step(&mut self, time: f64, state: &[f64]) {
        let step = self.before.clone();
        let mut parts = std::mem::take(&mut self.parts);
        for part in &mut parts {
            std::mem::swap(&mut self.after, part);
            self.look(&step, MOST_HALVED);
            if self.is_over() {
                break;
            }
            self.go_on();
        }
        self.parts = parts;
        if !self.is_over() {
            self.after.move_to(self.again.switches, time, state);
            self.look(&step, MOST_HALVED);
        }
        let direction = (time - step.time).signum();
        // an output at the end of a step may be a rounding behind it
        let last = self.found.as_ref().map(|(event, _)| event.time).or(self.lost.as_ref().map(|last| last.time));
        let is_seen = |output: f64| last.is_none_or(|last| (last - output) * direction >= 0.0);
        for (output, state) in self.samples.drain(..).filter(|(output, _)| is_seen(*output)) {
            self.observer.sample(output, &state);
        }
        if !self.is_over() {
            self.observer.step(time, state);
            self.go_on();
        }
    }

    fn progress(&mut self, fraction: f64) {
        self.observer.progress(fraction);
    }

    fn enough(&self) -> bool {
        self.is_over() || self.observer.enough()
    }
}
