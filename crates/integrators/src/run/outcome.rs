//! The result of a run, whether it reached its end or not.

use std::fmt;

use crate::Failure;

/// The way in which a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// At the end of the span, with a finite state.
    Reached,
    /// The observer ended the run.
    Halted,
    /// Before the end of the span, for this reason.
    Stopped(Failure),
}

/// The work of a run, in counts that every machine repeats.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Evaluations of the rates.
    pub rates: u64,
    /// Evaluations of the whole Jacobian.
    pub jacobians: u64,
    /// Factorisations of a matrix.
    pub factorisations: u64,
    /// Evaluations of constraints alone, with their derivatives.
    pub constraints: u64,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Steps made again for outputs that lie between two steps: no other count contains them or their evaluations.
    pub outputs: u64,
}

/// The largest distance of a monitored quantity from its first value.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    pub name: String,
    /// The value at the start.
    pub first: f64,
    /// The largest |value - first| over the accepted steps; infinite where the quantity has no value.
    pub largest: f64,
    /// The time at which it was reached.
    pub at: f64,
    /// The first time at which it was larger than [`LOST`] of the size of the quantity up to then, if that size is known and the change is
    /// larger in the end too.
    pub lost: Option<Lost>,
}

/// A conserved quantity is lost where it has changed by this part of its size: numbers from there on belong to another motion, or to none.
pub const LOST: f64 = 0.01;

/// The time at which a quantity was lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lost {
    pub at: f64,
    /// The largest size of the quantity.
    pub size: f64,
}

/// The end of a run: the last good state in any case, never NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome<S> {
    pub end: End,
    /// The time of the last good state: the span's end if it was reached.
    pub time: f64,
    /// The last good state.
    pub state: Vec<S>,
    pub work: Work,
    /// One for each monitor of the span.
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
    /// The reason for which the run stopped, if it did.
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
            write!(f, "; in addition {} steps for outputs between the steps", self.outputs)?;
        }
        Ok(())
    }
}
