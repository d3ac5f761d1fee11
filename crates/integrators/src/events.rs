//! Runs that end where something happens: the fall of a signal through zero, located to rounding.
//!
//! A step is looked at when it is accepted. Where a signal fell through zero in it, or may have dipped below, the motion
//! is computed again from the beginning of the step to trial times, by the same method: so the state of an event is as
//! accurate as any state of the run, and no interpolant comes in. The Taylor method's step is a polynomial as accurate as
//! its end: there a trial is one sum, and a step, which may be long, is looked at in parts. Two falls with a rise between them within one step
//! leave no trace at its ends if the rates there do not differ in sign; nothing finds them but a smaller tolerance.

use crate::taylor::taylor_order;
use crate::{End, Method, Observer, Outcome, Span, System, TaylorSeries, Tolerance, Work, integrate};

/// The value of a signal, its rate along the motion, and how large a value still counts as zero.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Signal {
    pub value: f64,
    pub rate: f64,
    pub noise: f64,
}

/// Signals that are watched. Each counts from when it was first positive: one that starts at zero may rise first.
pub trait Switches {
    /// How many.
    fn count(&self) -> usize;

    /// All of them at a state; `out` has their count.
    fn signals(&self, time: f64, state: &[f64], out: &mut [Signal]);
}

/// What a signal did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Happening {
    /// It fell through zero.
    Falls,
    /// It came down to zero, within its noise, and rose again.
    Touches,
    /// It was zero at the start, and negative without having been positive.
    StartsBelow,
}

/// Where a run ended before its span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Which signal.
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
            // a constant step again is one step
            method: method.once(),
            tolerance,
            switches,
            evaluations: span.budget.evaluations,
            series: if method == Method::Taylor { system.taylor() } else { None },
        },
        observer,
        armed: vec![false; count],
        before: Instant::of(switches, span.start, &span.state),
        after: Instant::of(switches, span.start, &span.state),
        parts: Vec::new(),
        samples: Vec::new(),
        found: None,
        extra: Work::default(),
    };
    guard.arm();
    let mut outcome = integrate(system, method, tolerance, span, &mut guard);
    outcome.work.rates += guard.extra.rates;
    outcome.work.steps += guard.extra.steps;
    let Some((event, state)) = guard.found else { return (outcome, None) };
    (outcome.end, outcome.time, outcome.state) = (End::Halted, event.time, state);
    (outcome, Some(event))
}

/// So many parts of a step that is a polynomial are looked at one by one.
const PARTS: usize = 8;

/// A signal that would not come to zero in so many such steps, at the rates of both ends, does not in one of them: it is not
/// searched for a least value.
const SLOW: f64 = 100.0;

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

/// Stands between the run and its observer: looks at each step before the observer does.
struct Guard<'a> {
    again: Again<'a>,
    observer: &'a mut dyn Observer<f64>,
    /// Which signals were positive once.
    armed: Vec<bool>,
    before: Instant,
    after: Instant,
    /// Within the step, where the method shows it.
    parts: Vec<Instant>,
    /// Outputs of the step that was not looked at yet.
    samples: Vec<(f64, Vec<f64>)>,
    found: Option<(Event, Vec<f64>)>,
    extra: Work,
}

impl Guard<'_> {
    fn arm(&mut self) {
        for (armed, signal) in self.armed.iter_mut().zip(&self.before.signals) {
            *armed |= signal.value > signal.noise;
        }
    }

    /// The first event of the step just taken.
    fn first_event(&mut self) -> Option<(Event, Vec<f64>)> {
        let mut first: Option<(Event, Vec<f64>)> = None;
        for signal in 0..self.armed.len() {
            let found = self.event_of(signal);
            if let Some((event, state)) = found
                && first.as_ref().is_none_or(|(known, _)| (event.time - known.time) * self.direction() < 0.0)
            {
                first = Some((event, state));
            }
        }
        first
    }

    fn direction(&self) -> f64 {
        (self.after.time - self.before.time).signum()
    }

    fn event_of(&mut self, signal: usize) -> Option<(Event, Vec<f64>)> {
        let (a, b) = (self.before.signals[signal], self.after.signals[signal]);
        let (t0, t1) = (self.before.time, self.after.time);
        if !self.armed[signal] {
            let event = Event { signal, what: Happening::StartsBelow, time: t0 };
            return (b.value < -b.noise).then(|| (event, self.before.state.clone()));
        }
        if b.value <= 0.0 {
            let (time, state) =
                self.again.root(&self.before, t1, &mut self.extra, |s| (s[signal].value, s[signal].rate))?;
            return Some((Event { signal, what: Happening::Falls, time }, state));
        }
        let direction = self.direction();
        if !(a.rate * direction < 0.0 && b.rate * direction > 0.0) {
            return None;
        }
        // at rest rates are rounding, and their signs say nothing
        if SLOW * (t1 - t0).abs() * (a.rate.abs() + b.rate.abs()) < a.value.min(b.value) {
            return None;
        }
        // a least value within the step: where the rate changes its sign
        let (time, state) =
            self.again.root(&self.before, t1, &mut self.extra, |s| (-direction * s[signal].rate, f64::NAN))?;
        let least = Instant::of(self.again.switches, time, &state).signals[signal];
        if least.value > least.noise {
            return None;
        }
        if least.value >= -least.noise {
            return Some((Event { signal, what: Happening::Touches, time }, state));
        }
        let (time, state) =
            self.again.root(&self.before, time, &mut self.extra, |s| (s[signal].value, s[signal].rate))?;
        Some((Event { signal, what: Happening::Falls, time }, state))
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
        let mut parts = std::mem::take(&mut self.parts);
        for part in &mut parts {
            std::mem::swap(&mut self.after, part);
            self.found = self.first_event();
            if self.found.is_some() {
                break;
            }
            std::mem::swap(&mut self.before, &mut self.after);
            self.arm();
        }
        self.parts = parts;
        if self.found.is_none() {
            self.after.move_to(self.again.switches, time, state);
            self.found = self.first_event();
        }
        let direction = self.direction();
        let last = self.found.as_ref().map_or(time, |(event, _)| event.time);
        for (output, state) in self.samples.drain(..).filter(|(output, _)| (last - output) * direction >= 0.0) {
            self.observer.sample(output, &state);
        }
        if self.found.is_none() {
            self.observer.step(time, state);
            std::mem::swap(&mut self.before, &mut self.after);
            self.arm();
        }
    }

    fn progress(&mut self, fraction: f64) {
        self.observer.progress(fraction);
    }

    fn enough(&self) -> bool {
        self.found.is_some() || self.observer.enough()
    }
}

/// The motion from the beginning of a step, computed again.
struct Again<'a> {
    system: &'a dyn System,
    method: Method,
    tolerance: &'a Tolerance,
    switches: &'a dyn Switches,
    evaluations: u64,
    /// The motion as a polynomial, where the method has it.
    series: Option<Box<dyn TaylorSeries<f64> + 'a>>,
}

/// A halving gains one bit, and there are no more in a double.
const MOST_TRIALS: usize = 120;

impl Again<'_> {
    /// Where a function of the signals, positive or zero at the beginning, becomes negative before `end`: Newton's
    /// method with the rate, kept in the bracket by halving. `None` where the motion could not be computed again.
    fn root(
        &mut self,
        from: &Instant,
        end: f64,
        work: &mut Work,
        function: impl Fn(&[Signal]) -> (f64, f64),
    ) -> Option<(f64, Vec<f64>)> {
        let (mut low, mut high, mut time) = (from.time, end, end);
        let (mut best, mut beyond): (Option<(f64, Vec<f64>)>, _) = (None, None);
        let (mut instant, mut state) = (from.clone(), from.state.clone());
        if let Some(series) = &mut self.series {
            let order = taylor_order(self.tolerance.relative);
            series.expand(from.time, &from.state, order);
            work.rates += order as u64;
        }
        for trial in 0..MOST_TRIALS {
            if time == from.time {
                instant.clone_from(from);
            } else if let Some(series) = &self.series {
                series.sum(time - from.time, &mut state);
                instant.move_to(self.switches, time, &state);
            } else {
                let span = Span::new(from.time, time, &from.state).with_evaluations(self.evaluations);
                let outcome = integrate(self.system, self.method, self.tolerance, &span, &mut ());
                (work.rates, work.steps) = (work.rates + outcome.work.rates, work.steps + outcome.work.steps);
                if !outcome.reached() {
                    return best;
                }
                instant.move_to(self.switches, time, &outcome.state);
            }
            let (value, rate) = function(&instant.signals);
            best = Some((time, instant.state.clone()));
            if value == 0.0 {
                return best;
            }
            if value > 0.0 {
                low = time;
            } else {
                high = time;
                beyond.clone_from(&best);
            }
            let newton = time - value / rate;
            let inside = (newton - low) * (newton - high) < 0.0;
            // a halving now and then, lest Newton creep
            let next = if inside && trial % 8 != 7 { newton } else { low + 0.5 * (high - low) };
            if next == low || next == high {
                // nothing between: a signal that jumps has its new value here
                return beyond;
            }
            if inside && (next - time).abs() <= f64::EPSILON * time.abs().max((end - from.time).abs()) {
                return best;
            }
            time = next;
        }
        best
    }
}
