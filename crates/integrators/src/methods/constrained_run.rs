//! One interface for runs of all kinds of laws: ordinary differential equations, DAEs, and hybrid motions with events.

use crate::{Index2DaeSystem, Index2Method, Method, Observer, Outcome, Span, System, Tolerance};
use crate::{integrate, integrate_index2};
use std::fmt;

/// A law with the method that integrates it.
#[derive(Clone, Copy)]
pub enum Attempt<'a> {
    /// An ordinary differential equation y' = f(t, y).
    Integrated(&'a dyn System, Method),
    /// A DAE of index 2.
    Held(&'a dyn Index2DaeSystem, Index2Method),
    /// A hybrid motion: several laws in sequence, separated by events.
    Hybrid(&'a dyn HybridMotion, Method),
}

/// A motion by several laws in sequence, which locates its events itself.
pub trait HybridMotion {
    /// The number of states, equal for all laws.
    fn dimension(&self) -> usize;

    /// Whether each law has a Taylor series.
    fn has_series(&self) -> bool {
        false
    }

    /// Integrates over a span. The budget of evaluations counts evaluations of the active law.
    fn run(
        &self,
        method: Method,
        tolerance: &Tolerance,
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> Outcome<f64>;
}

/// The method of an [`Attempt`], without the law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Means {
    Integrated(Method),
    Held(Index2Method),
}

impl Attempt<'_> {
    pub fn means(&self) -> Means {
        match *self {
            Attempt::Integrated(_, method) | Attempt::Hybrid(_, method) => Means::Integrated(method),
            Attempt::Held(_, holding) => Means::Held(holding),
        }
    }

    /// Integrates the law. Methods with a constant step ignore the tolerance.
    pub fn run(&self, tolerance: &Tolerance, span: &Span<'_, f64>, observer: &mut dyn Observer<f64>) -> Outcome<f64> {
        match *self {
            Attempt::Integrated(system, method) => integrate(system, method, tolerance, span, observer),
            Attempt::Held(held, holding) => integrate_index2(held, holding, span, observer),
            Attempt::Hybrid(motion, method) => motion.run(method, tolerance, span, observer),
        }
    }

    /// The cost of a run in evaluations of the rates: a Jacobian counts as its number of columns, a projection onto the
    /// constraints as one.
    pub fn evaluations(&self, work: &crate::Work) -> u64 {
        let columns = match *self {
            Attempt::Integrated(system, _) => crate::Ode::<f64>::dimension(system),
            Attempt::Hybrid(motion, _) => motion.dimension(),
            Attempt::Held(held, _) => {
                let (states, multipliers) = crate::Index2Dae::<f64>::sizes(held);
                states + multipliers
            }
        };
        work.rates + work.jacobians * columns as u64 + work.constraints
    }
}

impl Means {
    /// The number of equal steps; `None` for a method with step size control.
    pub fn steps(self) -> Option<u32> {
        match self {
            Means::Integrated(method) => method.steps(),
            Means::Held(holding) => Some(holding.steps()),
        }
    }
}

impl fmt::Display for Means {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Means::Integrated(method) => method.fmt(f),
            Means::Held(holding) => holding.fmt(f),
        }
    }
}
