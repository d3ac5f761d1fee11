//! A system with its laws recorded as straight-line code, for the Taylor method.

use field::{DoubleDouble, Scalar};
use integrators::{Directions, Ode, System, TaylorSeries};
use std::sync::Arc;
use symbolic::{Equations, Expansion, Fused, Recurrence, Sym};

/// A system and the recurrence of its right-hand side: the same laws, evaluated once over expressions. The data of the
/// system are in it as exact constants.
#[derive(Clone, Debug)]
pub struct Recorded<L> {
    law: Arc<L>,
    /// `None` where a law cannot be recorded; then there is no Taylor method.
    recurrence: Option<Recurrence>,
}

impl<L: Ode<Sym>> Recorded<L> {
    /// Records an autonomous system.
    pub fn new(law: Arc<L>) -> Self {
        let state: Vec<Sym> = (0..law.dimension()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
        let mut rates = vec![Sym::ZERO; state.len()];
        law.rates(Sym::ZERO, &state, &mut rates);
        let equations = Equations { state: &state, time: None, parameters: &[], rates: &rates };
        Recorded { law, recurrence: Recurrence::record(&equations).ok() }
    }

    fn series<S: integrators::Real + Fused>(&self) -> Option<Box<dyn TaylorSeries<S> + '_>> {
        Some(Box::new(Series::<S> { recurrence: self.recurrence.as_ref()?, expansion: None }))
    }
}

impl<S: Scalar, L: Ode<S>> Ode<S> for Recorded<L> {
    fn dimension(&self) -> usize {
        self.law.dimension()
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        self.law.rates(t, y, dy);
    }
}

impl<L: Ode<Sym> + Ode<f64> + Ode<Directions> + Ode<DoubleDouble>> System for Recorded<L> {
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.series()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.series()
    }
}

/// The series of a recurrence, with room made for the order that is asked for.
struct Series<'a, S> {
    recurrence: &'a Recurrence,
    expansion: Option<Expansion<'a, S, 8>>,
}

impl<S: integrators::Real + Fused> TaylorSeries<S> for Series<'_, S> {
    fn expand(&mut self, t: S, y: &[S], order: usize) {
        if self.expansion.as_ref().is_none_or(|expansion| expansion.order() != order) {
            self.expansion = self.recurrence.expansion(&[], order);
        }
        if let Some(expansion) = &mut self.expansion {
            expansion.expand(y, t);
        }
    }

    fn coefficients(&self, k: usize) -> &[S] {
        self.expansion.as_ref().map_or(&[], |expansion| expansion.coefficients(k))
    }
}
