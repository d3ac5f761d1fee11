//! Actions after accepted steps of any method: outputs, monitors, progress, last valid state.

use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::outcome::{LOST, Lost};
use crate::run::within::{StepEnd, Within};
use crate::{Deviation, End, Failure, Observer, Outcome, Projection, Real, Span};

/// The magnitudes of monitored quantities are computed at least once in this many steps.
const SIZED: u64 = 64;

/// The state of a run outside its method.
pub(crate) struct Watch<'a, 'm, S> {
    span: &'a Span<'m, S>,
    observer: &'a mut dyn Observer<S>,
    within: Within<'a, S>,
    projection: Option<&'a dyn Projection<S>>,
    length: S,
    next_output: usize,
    tau: S,
    state: Vec<S>,
    /// For each monitor: its first value, its deviation, and its largest size so far.
    deviations: Vec<(S, Deviation, f64)>,
    steps: u64,
    rejected: u64,
    /// The failure of an output.
    failed: Option<Failure>,
}

impl<'a, 'm, S: Real> Watch<'a, 'm, S> {
    /// Begins the observation, and reports outputs at the start.
    pub fn new(span: &'a Span<'m, S>, observer: &'a mut dyn Observer<S>, within: Within<'a, S>) -> Self {
        let first = |monitor: &crate::Monitor<'m, S>| {
            let value = (monitor.value)(span.start, &span.state);
            let name = monitor.name.clone();
            (value, Deviation { name, first: value.approx(), largest: 0.0, at: span.start, lost: None }, 0.0)
        };
        let mut watch = Watch {
            length: span.length(),
            next_output: 0,
            tau: S::zero(),
            state: span.state.clone(),
            deviations: span.monitors.iter().map(first).collect(),
            steps: 0,
            rejected: 0,
            failed: None,
            span,
            observer,
            within,
            projection: None,
        };
        watch.sample_if_at(S::zero());
        watch
    }

    /// As [`Watch::new`], with a projection of every state after the start onto invariants.
    pub fn projected(self, projection: Option<&'a dyn Projection<S>>) -> Self {
        Watch { projection, ..self }
    }

    /// Whether states are projected.
    pub fn projects(&self) -> bool {
        self.projection.is_some()
    }

    /// The run's time tau of the last valid state.
    pub fn tau(&self) -> S {
        self.tau
    }

    /// The last valid state.
    pub fn state(&self) -> &[S] {
        &self.state
    }

    pub fn length(&self) -> S {
        self.length
    }

    /// Whether the run continues: the end is not reached and the observer has not stopped it.
    pub fn goes_on(&self) -> bool {
        self.tau < self.length && self.failed.is_none() && !self.observer.enough()
    }

    /// The kind of end of a run whose method did not fail.
    pub fn end(&self) -> End {
        match self.failed {
            Some(failure) => End::Stopped(failure),
            None if self.tau < self.length => End::Halted,
            None => End::Reached,
        }
    }

    /// The time at which the next step must end at the latest: the end of the span; in a scalar type finer than `f64`,
    /// also the next output.
    pub fn landing(&self) -> S {
        match self.output() {
            Some(time) if S::EPSILON < f64::EPSILON => self.span.since_start(time),
            _ => self.length,
        }
    }

    /// The time of the next output, s; `None` after the last one.
    pub fn output(&self) -> Option<f64> {
        self.span.outputs.get(self.next_output).copied()
    }

    /// The time of the next output since the start of the run, s; `None` if it is after tau or there is none.
    pub fn output_up_to(&self, tau: S) -> Option<S> {
        self.output().map(|time| self.span.since_start(time)).filter(|at| *at <= tau)
    }

    /// Reports the next output with a state from the method's dense output.
    pub fn sample(&mut self, state: &mut [S]) {
        if let Some(time) = self.output() {
            self.project(S::lift(time), state);
            self.observer.sample(time, state);
            self.next_output += 1;
        }
    }

    /// Gives the observer access to the states of the step from the last valid state to tau.
    pub fn look_between(&mut self, tau: S, state_after: impl Fn(S, &mut [S])) {
        let (begin, end) = (self.time(), self.time_of(tau));
        let begun = self.tau;
        let span = self.span;
        let projection = self.projection;
        self.observer.between(begin, end, &|time, state| {
            state_after(span.since_start(time) - begun, state);
            if let Some(projection) = projection {
                projection.project(S::lift(time), state);
            }
        });
    }

    fn project(&self, time: S, state: &mut [S]) -> bool {
        self.projection.is_some_and(|projection| projection.project(time, state))
    }

    /// Records the state after an accepted step, and reports the outputs up to it.
    pub fn accept(&mut self, tau: S, state: &[S]) {
        self.show_within(tau, state);
        self.state.copy_from_slice(state);
        self.accepted(tau);
    }

    /// As [`Self::accept`], without copying: the state may be projected, and is swapped with the previous one. Returns
    /// whether the projection changed it.
    pub fn take(&mut self, tau: S, state: &mut Vec<S>) -> bool {
        let moved = self.project(self.clock(tau), state);
        self.show_within(tau, state);
        std::mem::swap(&mut self.state, state);
        self.accepted(tau);
        moved
    }

    /// Reports the outputs between the last valid state and the state at tau.
    fn show_within(&mut self, tau: S, after: &[S]) {
        let end = self.time_of(tau);
        let known = self.span.outputs.iter().skip(self.next_output);
        let before = |time: f64| self.span.since_start(time) < tau && !self.meets(time, tau);
        let times: Vec<f64> = known.copied().take_while(|time| before(*time)).collect();
        if times.is_empty() || self.failed.is_some() {
            return;
        }
        let places = [StepEnd { time: self.time(), state: &self.state }, StepEnd { time: end, state: after }];
        let read = match self.within.polynomial(self.span, places, times.len()) {
            Ok(read) => read,
            Err(failure) => {
                self.failed = Some(failure);
                return;
            }
        };
        for time in times {
            let state = match &read {
                Some(polynomial) => Ok(polynomial.at(time)),
                None if self.observer.enough() => return,
                None => self.within.state(self.span, StepEnd { time: self.time(), state: &self.state }, time),
            };
            match state {
                Ok(mut state) => self.sample(&mut state),
                Err(failure) => {
                    self.failed = Some(failure);
                    return;
                }
            }
        }
    }

    /// Whether a time equals that at tau up to rounding.
    fn meets(&self, time: f64, tau: S) -> bool {
        let apart = (self.span.since_start(time) - tau).magnitude().approx();
        apart <= 4.0 * S::EPSILON * time.abs().max(tau.approx())
    }

    fn accepted(&mut self, tau: S) {
        self.tau = tau;
        self.steps += 1;
        self.sample_if_at(tau);
        let time = self.time();
        for (monitor, (first, deviation, largest)) in self.span.monitors.iter().zip(&mut self.deviations) {
            let distance = ((monitor.value)(time, &self.state) - *first).magnitude().approx();
            let distance = if distance.is_nan() { f64::INFINITY } else { distance };
            let is_off = |size: f64| distance > LOST * size;
            if let Some(size) = &monitor.size
                && (is_off(*largest) || self.steps.is_multiple_of(SIZED))
            {
                *largest = largest.max(size(time, &self.state).magnitude().approx());
                if is_off(*largest) && deviation.lost.is_none() {
                    deviation.lost = Some(Lost { at: time, size: *largest });
                }
            }
            if distance > deviation.largest {
                (deviation.largest, deviation.at) = (distance, time);
            }
        }
        self.observer.step(time, &self.state);
        self.observer.progress(((tau / self.length).approx()).min(1.0));
    }

    pub fn reject(&mut self) {
        self.rejected += 1;
    }

    /// The time of the last valid state, s.
    pub fn time(&self) -> f64 {
        self.time_of(self.tau)
    }

    fn time_of(&self, tau: S) -> f64 {
        self.clock(tau).approx()
    }

    fn clock(&self, tau: S) -> S {
        if tau == self.length {
            return S::lift(self.span.end);
        }
        S::lift(self.span.start) + S::lift(self.span.direction()) * tau
    }

    pub fn finish(self, end: End, meter: &BudgetedRhs<S>) -> Outcome<S> {
        let time = self.time();
        let mut work = meter.work();
        (work.steps, work.rejected, work.outputs) = (self.steps, self.rejected, self.within.steps);
        // a loss that is small compared with the largest value along the motion is ignored, as at the beginning of a
        // motion from rest
        let judged = |(_, deviation, largest): (S, Deviation, f64)| {
            let is_lost = deviation.largest > LOST * largest;
            let lost = deviation.lost.filter(|_| is_lost).map(|lost| Lost { size: largest, ..lost });
            Deviation { lost, ..deviation }
        };
        let deviations = self.deviations.into_iter().map(judged).collect();
        Outcome { end, time, state: self.state, work, deviations }
    }

    pub fn fail(self, failure: Failure, meter: &BudgetedRhs<S>) -> Outcome<S> {
        self.finish(End::Stopped(failure), meter)
    }

    fn sample_if_at(&mut self, tau: S) {
        while let Some(time) = self.output()
            && self.failed.is_none()
            && self.meets(time, tau)
        {
            self.observer.sample(time, &self.state);
            self.next_output += 1;
        }
    }
}
