//! An initial value problem for any method, with object types.

use crate::events::{self, Ending, Margins, OneLaw, Switching};
use crate::law::Law;
use integrators::{End, Failure, Method, Observer, Outcome, Span, Tolerance};
use std::sync::Arc;

/// A law with its state at time zero, its integrals of motion, and the columns of its run.
pub struct Problem {
    pub law: Arc<dyn Law>,
    /// The initial state in the form of the law; for a gyrostat in the axes of the formulation.
    pub state: Vec<f64>,
    /// The number of components at the end of the state that only integrate other quantities, such as work; they do not
    /// count in the assessment of a run.
    pub metered: usize,
    /// The length of the run from time zero, s.
    pub span: f64,
    pub invariants: Vec<Invariant>,
    /// The residual of the constraints along the motion, if there are any.
    pub residual: Option<Box<Function>>,
    /// The column names of a row.
    pub columns: Vec<String>,
    /// Computes the columns from a time and a state.
    pub row: Box<Row>,
    /// The margins: positive where the law is valid.
    pub margins: Box<Margins>,
    /// The changes of the law at events; `law` is then the law at the start.
    pub switching: Option<Arc<dyn Switching>>,
}

impl Problem {
    /// The motion across events by a method. A motion that ends before the end of the span is a failure.
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
    /// The reason why the law is invalid at a state; `None` where it is valid.
    pub fn outside(&self, time: f64, y: &[f64]) -> Option<&'static str> {
        events::outside(&(self.margins)(time, y, &vec![0.0; y.len()]))
    }

    /// Integrates over a span across events, or to the end of the validity of the law: the outcome is then the last
    /// valid state, with the reason. The reason is `None` if the law stays valid.
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
        // a start near a singular position may lead away from it
        let zeros = vec![0.0; span.state.len()];
        if (self.margins)(span.start, &span.state, &zeros).iter().any(|margin| margin.goes_on && margin.value <= 0.0) {
            let alone = OneLaw(Arc::clone(&self.law));
            return events::integrate((&alone, &*self.margins), (method, tolerance), span, observer, false);
        }
        Ending { law: &*self.law, margins: &*self.margins }.integrate((method, tolerance), span, observer)
    }

    /// As [`integrate`](Self::integrate), but across singular positions of the constraints on the smooth branch of the
    /// motion, where one is found. The observer receives these positions.
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

/// An integral of motion: a function of time and state that keeps its initial value.
pub struct Invariant {
    pub name: &'static str,
    pub value: Box<Function>,
    /// The size of its terms, if known, such as that of kinetic and potential energy: a run that changes the integral
    /// by a hundredth of it has lost the integral.
    pub size: Option<Box<Function>>,
}

/// The unit of an invariant, by its name; empty where it is not known.
pub fn unit_of_invariant(name: &str) -> &'static str {
    if name.starts_with("energy") { "J" } else { "" }
}
