//! The ladders of governors and other mechanisms: a law without some of its terms, quasi-steady states, series.

use crate::ladder::rung::Lower;
use crate::ladder::{Ladder, Loss, Rung};
use crate::mechanisms::Mechanism;
use crate::mechanisms::rewritten::ready;
use field::{Analytic, Over, Scalar};
use integrators::Ode;
use simulation::{Problem, SymbolicLaw};
use std::sync::Arc;
use symbolic::Sym;
use systems::governor::series::Programme;

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

/// The same mechanism with other data, on states of the same meaning: exact where the laws do not differ, which is decided.
pub fn with_data<M: Mechanism>(
    name: &'static str,
    dropped: &str,
    parameter: &'static str,
    other: M,
    start: &[f64],
    written: &Arc<dyn SymbolicLaw>,
) -> Option<Rung> {
    let lower = Lower::other(&(Arc::new(Alone(other)) as Arc<dyn SymbolicLaw>));
    let loss = if lower.is_exact(&**written) { Loss::Nothing { claim: None } } else { Loss::Small { parameter } };
    Rung::new(name, dropped, loss, lower, start.to_vec())
}

/// The programme's series by powers of its small parameter, cut off: no equation is solved, only a clock goes.
pub fn series(law: &Programme<f64>, start: f64) -> Vec<Rung> {
    const ORDERS: [(usize, &str); 4] =
        [(1, "series to eps"), (2, "series to eps^2"), (4, "series to eps^4"), (8, "series to eps^8")];
    let rung = |(order, name): (usize, &'static str)| {
        let terms = law.series(start, order);
        let (epsilon, whole) = (law.epsilon, terms.clone());
        let lift = move |_: Sym, z: &[Sym]| {
            let clock = z[0];
            let value = |term: &Vec<f64>| term.iter().rev().fold(Sym::ZERO, |sum, &c| sum * clock + Sym::lift(c));
            let sum = whole.iter().rev().fold(Sym::ZERO, |sum, term| sum * Sym::lift(epsilon) + value(term));
            vec![sum]
        };
        let lower =
            Lower { dimension: 1, lift: Arc::new(lift), rates: Arc::new(|_, _: &[Sym]| vec![Sym::int(1)]), kept: None };
        let loss = Loss::Small { parameter: "eps (k1/rho0 + k2) t/rho0" };
        Rung::new(name, "the powers of the small parameter beyond", loss, lower, vec![0.0])
    };
    ORDERS.into_iter().filter_map(rung).collect()
}
