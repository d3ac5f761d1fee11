//! The ladders of governors and other mechanisms: a law without some of its terms, quasi-steady states, series.

use crate::ladder::Ladder;
use crate::mechanisms::Mechanism;
use crate::mechanisms::rewritten::ready;
use field::{Analytic, Over};
use integrators::Ode;
use simulation::{Problem, SymbolicLaw};
use std::sync::Arc;

/// A mechanism's law without the work that is done on it.
#[derive(Clone)]
pub struct Alone<M>(pub M);

impl<S: Over<f64> + Analytic, M: Mechanism> Ode<S> for Alone<M> {
    fn dimension(&self) -> usize {
        M::STATE.len()
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        self.0.rates(t, y, dy);
    }
}

/// The models of a mechanism with its initial value problem, whose last state is the work.
pub fn of_mechanism<M: Mechanism>(mechanism: &M, start: &[f64], own: Problem) -> Ladder {
    let written: Arc<dyn SymbolicLaw> = Arc::new(Alone(mechanism.clone()));
    let rungs = mechanism.smaller(start, &written);
    let state = mechanism.state(start);
    let whole = |_: f64, y: &[f64]| [y, &[0.0]].concat();
    let law = ready(Alone(mechanism.clone()));
    let (model, whole) = (M::NAME, Box::new(whole));
    Ladder { model, own, written, law, start: state, whole, rungs, lumping: None }
}
