//! The initial value problem of a run: span, initial state, outputs, monitors, budget.

use std::time::Instant;

use crate::{Absolute, Real, Refusal, Tolerance};

/// The limits of the work of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    /// The largest number of evaluations of the rates.
    pub evaluations: u64,
    /// The deadline of the run.
    pub deadline: Option<Instant>,
}

impl Default for Budget {
    fn default() -> Self {
        Budget { evaluations: 50_000_000, deadline: None }
    }
}

/// A function of time and state.
pub type Quantity<'a, S> = Box<dyn Fn(f64, &[S]) -> S + 'a>;

/// A conserved quantity whose changes are recorded.
pub struct Monitor<'a, S> {
    pub name: String,
    pub value: Quantity<'a, S>,
    /// The size of the terms of the quantity, if known: changes are compared with its largest value along the run.
    pub size: Option<Quantity<'a, S>>,
}

/// An initial value problem without its law. Times in s.
pub struct Span<'a, S> {
    pub start: f64,
    /// The end; if it is less than `start`, the run goes backwards in time.
    pub end: f64,
    /// The state at `start`.
    pub state: Vec<S>,
    /// The output times, in the order of the run, from `start` to `end`. In `f64` they do not affect the steps: a state
    /// between two steps has the accuracy of a step. In double-double the steps end at the outputs.
    pub outputs: Vec<f64>,
    pub monitors: Vec<Monitor<'a, S>>,
    pub budget: Budget,
    /// The largest first step (s), for a law that changes rapidly from its initial state.
    pub longest_first: Option<f64>,
    /// Whether the span lies within an accepted step of the method: its first step is then the whole span.
    pub(crate) within_step: bool,
}

impl<'a, S: Real> Span<'a, S> {
    /// The span from `start` to `end` (s) with the initial state `state`, and one output at the end.
    pub fn new(start: f64, end: f64, state: &[S]) -> Self {
        let (outputs, monitors) = (vec![end], Vec::new());
        let (budget, longest_first, within_step) = (Budget::default(), None, false);
        Span { start, end, state: state.to_vec(), outputs, monitors, budget, longest_first, within_step }
    }

    /// The span, marked as part of an accepted step.
    pub(crate) fn within_step(mut self) -> Self {
        self.within_step = true;
        self
    }

    /// The span with outputs at these times (s), in the order of the run.
    pub fn with_outputs(mut self, outputs: &[f64]) -> Self {
        self.outputs = outputs.to_vec();
        self
    }

    /// The span with `count` outputs at equal distances, the last at the end.
    pub fn with_even_outputs(mut self, count: usize) -> Self {
        let step = |k: usize| self.start + (self.end - self.start) * (k as f64 / count as f64);
        self.outputs = (1..=count).map(|k| if k == count { self.end } else { step(k) }).collect();
        self
    }

    /// The span with one more monitored quantity, a function of time (s) and state.
    pub fn with_monitor(mut self, name: &str, value: impl Fn(f64, &[S]) -> S + 'a) -> Self {
        self.monitors.push(Monitor { name: name.to_owned(), value: Box::new(value), size: None });
        self
    }

    /// Sets the size of the terms of the last monitored quantity, a function of time (s) and state.
    pub fn beside(mut self, size: impl Fn(f64, &[S]) -> S + 'a) -> Self {
        if let Some(last) = self.monitors.last_mut() {
            last.size = Some(Box::new(size));
        }
        self
    }

    /// The span with a budget of evaluations of the rates.
    pub fn with_evaluations(mut self, evaluations: u64) -> Self {
        self.budget.evaluations = evaluations;
        self
    }

    /// The span with a deadline.
    pub fn with_deadline(mut self, deadline: Instant) -> Self {
        self.budget.deadline = Some(deadline);
        self
    }

    /// The length |end - start|, s.
    pub fn length(&self) -> S {
        (S::lift(self.end) - S::lift(self.start)).magnitude()
    }

    /// +1 forwards, -1 backwards.
    pub fn direction(&self) -> f64 {
        (self.end - self.start).signum()
    }

    /// The time tau = |time - start| since the start.
    pub(crate) fn since_start(&self, time: f64) -> S {
        (S::lift(time) - S::lift(self.start)) * S::lift(self.direction())
    }

    /// Checks the data.
    ///
    /// # Errors
    /// [`Refusal`] for numbers that are not finite, an empty span, wrong dimensions, or invalid outputs or tolerances.
    pub(crate) fn check(&self, dimension: usize, tolerance: Option<&Tolerance>) -> Result<(), Refusal> {
        if !(self.start.is_finite() && self.end.is_finite()) {
            return Err(Refusal::SpanNotFinite { start: self.start, end: self.end });
        }
        if self.start == self.end || !self.length().finite() {
            return Err(Refusal::SpanEmpty { start: self.start, end: self.end });
        }
        if self.state.len() != dimension || dimension == 0 {
            return Err(Refusal::Dimension { expected: dimension, found: self.state.len() });
        }
        if let Some(component) = self.state.iter().position(|y| !y.finite()) {
            return Err(Refusal::StateNotFinite { component });
        }
        if self.budget.evaluations == 0 {
            return Err(Refusal::NoBudget);
        }
        let mut last = S::zero();
        for (index, &time) in self.outputs.iter().enumerate() {
            let passed = if time.is_finite() { self.since_start(time) } else { -S::one() };
            if passed < last || passed > self.length() || (index > 0 && passed == last) {
                return Err(Refusal::Output { index, time, start: self.start, end: self.end });
            }
            last = passed;
        }
        tolerance.map_or(Ok(()), |tolerance| check_tolerance::<S>(tolerance, dimension))
    }
}

/// Checks that the tolerance is positive, finite, not below rounding, and has one entry per component if given by
/// component.
fn check_tolerance<S: Real>(tolerance: &Tolerance, dimension: usize) -> Result<(), Refusal> {
    let least = 10.0 * S::EPSILON;
    if !(tolerance.relative >= least && tolerance.relative < 1.0) {
        return Err(Refusal::Relative { given: tolerance.relative, least });
    }
    if let Absolute::Each(each) = &tolerance.absolute
        && each.len() != dimension
    {
        return Err(Refusal::AbsoluteCount { expected: dimension, found: each.len() });
    }
    match (0..dimension).map(|i| tolerance.absolute(i)).find(|a| !(*a > 0.0 && a.is_finite())) {
        Some(given) => Err(Refusal::Absolute { given }),
        None => Ok(()),
    }
}
