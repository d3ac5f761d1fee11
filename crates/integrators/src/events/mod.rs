//! Event location: runs that end where a signal falls through zero, located to rounding.
//!
//! Each accepted step is examined. The value and the rate of a signal at both ends bound it over the step ([`bounds`]),
//! with an error bound from the previous step and the curvature of the signal. Where these bounds do not decide whether
//! there is a zero, the method integrates to the middle of the step, and both halves are examined. Steps can be long
//! and contain several zeros. The state at the event is integrated, not interpolated: it is as accurate as any state of
//! the run. With Taylor's method the polynomial of the step gives these states, and each step is examined in eight
//! parts.

mod again;
mod bounds;
mod distances;
mod gap;
mod search;

use crate::{End, Failure, Method, Observer, Outcome, Span, System, Tolerance, Work, integrate};
use again::Again;
pub use distances::Pace;
use search::{Search, Seen, look};

/// A signal: its value, its rate along the motion (1/s), and the noise level below which a value counts as zero.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Signal {
    pub value: f64,
    pub rate: f64,
    pub noise: f64,
    /// Bounds of the rate of the distance, for a signal that is the square of a distance of order one: it may touch
    /// zero and rise again within one step. Zero for other signals.
    pub pace: Pace,
}

/// The signals of an event search. A signal is watched from the time at which it was first positive: a signal that
/// starts at zero may rise first.
pub trait Switches {
    /// The number of signals.
    fn count(&self) -> usize;

    /// Computes all signals at a state; `out` has `count()` entries.
    fn signals(&self, time: f64, state: &[f64], out: &mut [Signal]);

    /// Whether the event must be reported just before the zero, at a state where the signal is still positive: for
    /// signals beyond whose zero the law is undefined.
    fn ends_above(&self, _signal: usize) -> bool {
        false
    }

    /// Whether the time of the event matters. If so, and if the zero lies in a gap where the integration fails, the run
    /// ends before it. Other signals count as fallen at the end of the step.
    fn is_timed(&self, _signal: usize) -> bool {
        false
    }
}

/// The kind of a zero of a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Happening {
    /// The signal fell through zero.
    Falls,
    /// The signal decreased to zero, within its noise, and increased again.
    Touches,
    /// The signal was zero or negative at the start and then negative, without having been positive.
    StartsBelow,
}

/// The event that ended a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// The index of the signal.
    pub signal: usize,
    pub what: Happening,
    pub time: f64,
}

/// Integrates to the first event, the end of the span, or a failure. The state of the outcome is that at the event. The
/// observer receives no output beyond the event. The event is `None` if the span ended or the run failed first.
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
            // a repeated constant step must be a single step
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

/// Times that differ by at most this many units of rounding count as equal.
const TOGETHER: f64 = 8.0;

/// A signal that falls to zero within this many units of rounding of the time at which the step size collapses counts as
/// zero. Where rates are infinite at the zero, as for a square root, no step reaches the zero itself.
const AT_THE_END: f64 = 256.0;

/// The number of parts in which a step with a polynomial is examined.
const PARTS: usize = 8;

/// The largest number of halvings of a step, or of a part of it, while a distance may touch zero within.
const MOST_HALVED: u32 = 8;

/// A first step longer than this fraction of the span is examined with the initial error bound `UNKNOWN`, relative to
/// the values of the signal.
const LONG: f64 = 1e-3;
const UNKNOWN: f64 = 0.5;

/// A time with its state and signals.
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

/// The observer that examines each step before it passes the step to the user's observer.
struct Guard<'a> {
    again: Again<'a>,
    observer: &'a mut dyn Observer<f64>,
    /// Whether each signal has been positive.
    armed: Vec<bool>,
    /// The beginning of the previous interval.
    earlier: Option<Instant>,
    before: Instant,
    after: Instant,
    /// Instants within the step from its polynomial, if the method has one.
    parts: Vec<Instant>,
    /// Instants within the interval from repeated integrations.
    known: Vec<Instant>,
    /// Outputs of the step that has not been examined yet.
    samples: Vec<(f64, Vec<f64>)>,
    found: Option<Found>,
    /// The length (s) beyond which a first step is examined with a large error bound: no previous step shows the
    /// curvature of the signals, which may oscillate within the step.
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

    /// Moves on to the next interval.
    fn go_on(&mut self) {
        let begin = self.earlier.get_or_insert_with(|| self.before.clone());
        std::mem::swap(begin, &mut self.before);
        std::mem::swap(&mut self.before, &mut self.after);
        self.arm();
    }

    /// The signal that is zero within rounding at the last state, where the step size has collapsed.
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

    /// Whether one event comes before another. For equal times within rounding, as at stops of both ends of a rod, the
    /// signal with the larger rate relative to its noise comes first: its time is better determined.
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

    /// Examines the current interval. While a distance may touch zero within, the interval is halved; after the call,
    /// `before` and `after` are the ends of its last part.
    fn look(&mut self, step: &Instant, halvings: u32) {
        if halvings > 0 && distances::are_open(&self.before, &self.after) {
            let length = self.after.time - self.before.time;
            // the integration may fail beyond the zero of the distance
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

    /// The first event in the current interval; `step` is the beginning of the whole step.
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
                // an earlier event in this step cannot be separated from the lost one
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
        // the output at the end of a step may be late by rounding
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
