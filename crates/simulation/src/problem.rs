//! An initial value problem with its types erased, for any method.

use crate::events::{self, Ending, Margins, OneLaw, Switching};
use crate::law::Law;
use integrators::{End, Failure, Method, Observer, Outcome, Span, Tolerance};
use std::sync::Arc;

/// A law with its state at time zero, its integrals, and the columns that a run shows.
pub struct Problem {
    pub law: Arc<dyn Law>,
    /// The state as the law has it: for a gyrostat in the axes of the form.
    pub state: Vec<f64>,
    /// The number of components, the last ones, that only meter others, such as work: a run is not judged by them.
    pub metered: usize,
    /// The length of the run, s, from time zero.
    pub span: f64,
    pub invariants: Vec<Invariant>,
    /// The residual of the constraints that hold along the motion, where there are some.
    pub residual: Option<Box<Function>>,
    /// The names of a row.
    pub columns: Vec<String>,
    /// The columns that a run shows of a state at a time.
    pub row: Box<Row>,
    /// The distance of a state from the end of the law.
    pub margins: Box<Margins>,
    /// The changes of a law at events; `law` is then the law at the start.
    pub switching: Option<Arc<dyn Switching>>,
}

impl Problem {
    /// The motion across the events of a switching, by a method. A motion that ends before its span is another course.
    pub fn across(
        &self,
        switching: &dyn Switching,
        (method, tolerance): (Method, &Tolerance),
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> Outcome<f64> {
        let (outcome, left) = events::integrate((switching, &self.margins), (method, tolerance), span, observer, false);
        match left {
            None => outcome,
            Some(_) => Outcome { end: End::Stopped(Failure::OtherCourse { at: outcome.time }), ..outcome },
        }
    }
}

impl Problem {
    /// Why the law does not hold at a state, if it does not.
    pub fn outside(&self, time: f64, y: &[f64]) -> Option<&'static str> {
        events::outside(&(self.margins)(time, y, &vec![0.0; y.len()]))
    }

    /// Runs over a span, event after event, or to the end of the law: then the outcome is the last state within it, with the
    /// reason.
    pub fn integrate(
        &self,
        method: Method,
        tolerance: &Tolerance,
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> (Outcome<f64>, Option<&'static str>) {
        if let Some(switching) = &self.switching {
            return events::integrate((&**switching, &*self.margins), (method, tolerance), span, observer, false);
        }
        // a start beside a singular position may lead away from it
        let zeros = vec![0.0; span.state.len()];
        if (self.margins)(span.start, &span.state, &zeros).iter().any(|margin| margin.goes_on && margin.value <= 0.0) {
            let alone = OneLaw(Arc::clone(&self.law));
            return events::integrate((&alone, &*self.margins), (method, tolerance), span, observer, false);
        }
        Ending { law: &*self.law, margins: &*self.margins }.integrate((method, tolerance), span, observer)
    }

    /// As [`integrate`](Self::integrate), but beyond singular positions of the constraints, each on the smooth branch of the motion, where
    /// one is found: the observer is told of them.
    pub fn integrate_through_singular_positions(
        &self,
        method: Method,
        tolerance: &Tolerance,
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> (Outcome<f64>, Option<&'static str>) {
        let alone = OneLaw(Arc::clone(&self.law));
        let switching: &dyn Switching = self.switching.as_deref().unwrap_or(&alone);
        events::integrate((switching, &*self.margins), (method, tolerance), span, observer, true)
    }
}

pub type Function = dyn Fn(f64, &[f64]) -> f64 + Send + Sync;
pub type Row = dyn Fn(f64, &[f64]) -> Vec<f64> + Send + Sync;

/// A function of time and state that keeps its first value.
pub struct Invariant {
    pub name: &'static str,
    pub value: Box<Function>,
    /// The size of the terms of which it is composed, where it is known, such as that of kinetic and potential energy: a run that
    /// changes its value by a hundredth of that has lost it.
    pub size: Option<Box<Function>>,
}
