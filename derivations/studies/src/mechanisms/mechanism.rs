//! What a mechanism says of itself.

use super::rewritten::Rewritten;
use crate::ladder::Rung;
use field::{Analytic, Over};
use integrators::{Method, Ode};
use reader::Quantity;
use simulation::SymbolicLaw;
use simulation::events::{Margin, outside};
use simulation::work_precision::Formulation;
use std::fmt::Debug;
use std::sync::Arc;

/// A mechanism with its data: y' = f(t, y), its energy, and the power of what is not in that energy.
pub trait Mechanism: Clone + Debug + Send + Sync + 'static {
    /// As scene files call it.
    const NAME: &'static str;
    /// One line for lists.
    const SUMMARY: &'static str;
    /// y
    const STATE: &'static [Quantity];
    /// What a scene gives of it at the start.
    const START: &'static [Quantity] = Self::STATE;
    /// What a run shows beside the state.
    const SHOWN: &'static [Quantity] = &[];
    /// How the law is written.
    const FORMULATION: Formulation = Formulation::Minimal;

    /// Reads the data, each by its name.
    ///
    /// # Errors
    /// Those of the source.
    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E>;

    /// dy = f(t, y); must not allocate.
    fn rates<S: Over<f64> + Analytic>(&self, time: S, y: &[S], dy: &mut [S]);

    /// E(t, y), J.
    fn energy<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S;

    /// dE/dt along every motion, W; must not allocate.
    fn power<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S;

    /// The state that a start is completed to.
    fn state(&self, start: &[f64]) -> Vec<f64> {
        start.to_vec()
    }

    /// The values of [`Self::SHOWN`].
    fn shown(&self, _time: f64, _y: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    /// What is wrong with data that are single numbers of the right kind.
    fn amiss(&self, _start: &[f64]) -> Vec<Amiss> {
        Vec::new()
    }

    /// How far a state is from where the law ends, of a motion with this start; `dy` are the rates. Always as many.
    fn margins(&self, _start: &[f64], _y: &[f64], _dy: &[f64]) -> Vec<Margin> {
        Vec::new()
    }

    /// Why the law does not hold at a state of a motion with this start, where it does not.
    fn outside(&self, start: &[f64], y: &[f64]) -> Option<&'static str> {
        outside(&self.margins(start, y, &vec![0.0; y.len()]))
    }

    /// The name of what a motion that ended early has come to, if its last state shows it or it has left its law.
    fn diagnosis(&self, _run: &Ended<'_>) -> Option<Diagnosis> {
        None
    }

    /// The first states at a time in closed form, and what that is; `None` where it is not known.
    fn exact(&self, _start: &[f64], _time: f64) -> Option<(&'static str, Vec<f64>)> {
        None
    }

    /// The same mechanism in other coordinates, or with other treatments of its constraints.
    fn rewritten(&self, _start: &[f64]) -> Vec<Rewritten> {
        Vec::new()
    }

    /// Smaller models under this one, which is also given as its law over expressions.
    fn smaller(&self, _start: &[f64], _written: &Arc<dyn SymbolicLaw>) -> Vec<Rung> {
        Vec::new()
    }

    /// What theory says of the run without looking at it.
    fn theory(&self, _start: &[f64], _method: Method, _span: f64) -> Vec<String> {
        Vec::new()
    }
}

/// A condition that the data break.
#[derive(Clone, Debug, PartialEq)]
pub struct Amiss {
    /// The name of a datum or of a state, where it is shown.
    pub name: &'static str,
    /// In one line.
    pub what: &'static str,
    /// What would be accepted.
    pub accepted: String,
}

/// A run that ended early.
#[derive(Clone, Copy, Debug)]
pub struct Ended<'a> {
    pub start: &'a [f64],
    /// The last good state, and its time, s.
    pub last: &'a [f64],
    pub time: f64,
    /// Whether a [margin](Mechanism::margins) of the law has come to its end.
    pub left: bool,
    pub method: Method,
    /// What it was asked for, s.
    pub span: f64,
}

impl Ended<'_> {
    /// Whether a time is within the step that could not be made, where steps are constant.
    pub fn was_before(&self, end: f64) -> bool {
        self.method.steps().is_some_and(|steps| self.time + self.span / f64::from(steps) >= end)
    }
}

/// What a motion came to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diagnosis {
    pub what: &'static str,
    /// When, by the closed form, s.
    pub at: Option<f64>,
}

/// A mechanism and the work that is done on it, the last component: E - W keeps its first value.
#[derive(Clone, Debug)]
pub struct Balanced<M>(pub M);

impl<S: Over<f64> + Analytic, M: Mechanism> Ode<S> for Balanced<M> {
    fn dimension(&self) -> usize {
        M::STATE.len() + 1
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let (y, dy) = (&y[..M::STATE.len()], dy);
        self.0.rates(t, y, &mut dy[..M::STATE.len()]);
        dy[M::STATE.len()] = self.0.power(t, y);
    }
}

impl<M: Mechanism> integrators::System for Balanced<M> {}
