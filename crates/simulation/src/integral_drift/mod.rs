//! Drift of integrals of motion under methods with constant steps, by theory and by runs.
//!
//! By backward error analysis, a method of order p with the step size h follows a modified equation. Along it an
//! integral I of the law y' = f(y) changes at the rate
//!
//!   g = h^p grad I . f_(p+1) + h^(p+1) grad I . f_(p+2) + ... .
//!
//! One step from a point y of the exact motion changes I by the integral of g over that step. Hence
//!
//!   D(h) = (1/h) integral over T of (I(step(y(t))) - I(y(t))) dt
//!
//! is the drift over a period T, up to terms of order h^(2p), which come from the distance between both motions
//! (Hairer, Lubich and Wanner, Geometric Numerical Integration, IX). If D falls as h^(2p), it consists of these terms
//! only: along such a motion, symplectic or symmetric methods let I oscillate but not drift.
//!
//! # Overview
//! * [`return_time`]: the period of a motion;
//! * `theory`: D(h) by single steps from points of the motion;
//! * `measurement`: the change of I along a run of many periods.

mod measurement;
mod return_time;
mod theory;

pub use measurement::{Measured, Slope, measured};
pub use return_time::{Returns, return_time};
pub use theory::{Drift, Expected, expected};

use crate::law::Law;
use crate::problem::{Function, Invariant, unit_of_invariant};
use integrators::{Failure, Method, Observer, Record, Span, Tolerance, integrate};
use std::sync::Arc;

/// An integral of motion: a function of time and state that is constant along a motion.
pub struct Integral {
    pub name: String,
    /// The unit of its value; "1" for a pure number, empty where unknown.
    pub unit: String,
    pub value: Arc<Function>,
    /// The size of its terms, if known.
    pub size: Option<Arc<Function>>,
}

impl From<Invariant> for Integral {
    fn from(Invariant { name, value, size }: Invariant) -> Self {
        Integral {
            name: name.replace('_', " "),
            unit: unit_of_invariant(name).to_owned(),
            value: Arc::from(value),
            size: size.map(Arc::from),
        }
    }
}

/// A motion with its integrals.
pub struct MotionWithIntegrals<'a> {
    pub law: &'a dyn Law,
    /// The state at time zero.
    pub start: &'a [f64],
    pub integrals: &'a [Integral],
}

/// The time interval of a drift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Window {
    /// A period of the motion, s.
    Period(f64),
    /// A span of a motion without a period, s.
    Span(f64),
}

impl Window {
    /// The length, s.
    pub fn length(self) -> f64 {
        match self {
            Window::Period(length) | Window::Span(length) => length,
        }
    }
}

/// The tolerance of the run that represents the exact motion.
const EXACT: f64 = 1e-13;

/// The number of states of a window at which sizes are computed.
const SIZED: usize = 64;

impl MotionWithIntegrals<'_> {
    /// The states of the exact motion at ascending times (s).
    ///
    /// # Errors
    /// [`Failure`] where the run ends before the last of them.
    fn states(&self, times: &[f64]) -> Result<Vec<Vec<f64>>, Failure> {
        let Some(&end) = times.last() else { return Ok(Vec::new()) };
        let mut record = Record::new();
        self.exactly((0.0, end), self.start, times, &mut record)?;
        Ok(record.states)
    }

    /// The state at the time `to` (s) of the motion that has the state `state` at `from` (s), with the accuracy of double
    /// precision. The observer receives the states at `outputs` (s).
    fn exactly(
        &self,
        (from, to): (f64, f64),
        state: &[f64],
        outputs: &[f64],
        observer: &mut dyn Observer<f64>,
    ) -> Result<Vec<f64>, Failure> {
        let span = Span::new(from, to, state).with_outputs(outputs);
        let outcome = integrate(self.law, Method::DormandPrince8, &Tolerance::both(EXACT), &span, observer);
        outcome.failure().map_or(Ok(outcome.state), Err)
    }

    /// The largest size of each integral along a window.
    ///
    /// # Errors
    /// [`Failure`] where the run ends early.
    pub fn sizes(&self, window: Window) -> Result<Vec<f64>, Failure> {
        let times: Vec<f64> = (1..=SIZED).map(|k| window.length() * k as f64 / SIZED as f64).collect();
        let states = self.states(&times)?;
        let all =
            || std::iter::once((0.0, self.start)).chain(times.iter().copied().zip(states.iter().map(Vec::as_slice)));
        let of = |integral: &Integral| {
            let size = |(time, state): (f64, &[f64])| match &integral.size {
                Some(size) => size(time, state),
                None => (integral.value)(time, state).abs(),
            };
            all().map(size).fold(0.0, f64::max)
        };
        Ok(self.integrals.iter().map(of).collect())
    }
}
