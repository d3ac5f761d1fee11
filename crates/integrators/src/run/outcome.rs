//! The result of a run.

use std::fmt;

use crate::Failure;

/// The way in which a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// The run reached the end of the span, with a finite state.
    Reached,
    /// The observer ended the run.
    Halted,
    /// The run failed before the end of the span.
    Stopped(Failure),
}

/// The work of a run, in reproducible counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Evaluations of the rates.
    pub rates: u64,
    /// Evaluations of the whole Jacobian.
    pub jacobians: u64,
    /// LU factorisations.
    pub factorisations: u64,
    /// Evaluations of the constraints with their derivatives.
    pub constraints: u64,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Additional steps for outputs that lie between two steps; these steps and their evaluations are not in the other
    /// counts.
    pub outputs: u64,
}

/// The largest change of a monitored quantity from its first value.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    pub name: String,
    /// The value at the start.
    pub first: f64,
    /// The largest |value - first| over the accepted steps; infinite where the quantity is undefined.
    pub largest: f64,
    /// The time of the largest change, s.
    pub at: f64,
    /// The time from which the change exceeds [`LOST`] times the size of the quantity. `None` if the size is unknown,
    /// or the change is smaller again at the end.
    pub lost: Option<Lost>,
}

/// A conserved quantity counts as lost once it has changed by this fraction of its size: the numerical motion from
/// there on is not a motion of the law.
pub const LOST: f64 = 0.01;

/// The time (s) at which a conserved quantity was lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lost {
    pub at: f64,
    /// The largest size of the quantity up to then.
    pub size: f64,
}

/// The result of a run. Contains the last valid state in any case, never NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome<S> {
    pub end: End,
    /// The time of the last valid state, s; the end of the span if it was reached.
    pub time: f64,
    /// The last valid state.
    pub state: Vec<S>,
    pub work: Work,
    /// The largest changes of the monitored quantities, in the order of the span's monitors.
    pub deviations: Vec<Deviation>,
}

impl std::ops::Add for Work {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Work {
            rates: self.rates + b.rates,
            jacobians: self.jacobians + b.jacobians,
            factorisations: self.factorisations + b.factorisations,
            constraints: self.constraints + b.constraints,
            steps: self.steps + b.steps,
            rejected: self.rejected + b.rejected,
            outputs: self.outputs + b.outputs,
        }
    }
}

impl<S> Outcome<S> {
    /// The failure; `None` if the run reached its end or was halted.
    pub fn failure(&self) -> Option<Failure> {
        match self.end {
            End::Reached | End::Halted => None,
            End::Stopped(failure) => Some(failure),
        }
    }

    /// Whether the end of the span was reached.
    pub fn reached(&self) -> bool {
        self.end == End::Reached
    }
}

impl fmt::Display for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} evaluations, {} steps, {} rejected", self.rates, self.steps, self.rejected)?;
        if self.jacobians > 0 {
            write!(f, ", {} Jacobians, {} factorisations", self.jacobians, self.factorisations)?;
        }
        if self.constraints > 0 {
            write!(f, ", {} of the constraints alone", self.constraints)?;
        }
        if self.outputs > 0 {
            write!(f, "; {} extra steps to output times between the steps", self.outputs)?;
        }
        Ok(())
    }
}
