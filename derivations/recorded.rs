//! A system with its laws recorded as straight-line code, for the Taylor method.

use field::{DoubleDouble, Scalar};
use integrators::{Directions, Ode, System, TaylorSeries};
use std::sync::Arc;
use symbolic::{Series, Sym, Tape};

/// A system and the tape of its right-hand side: the same laws, evaluated once over expressions. The data of the
/// system are in it as exact constants.
#[derive(Clone, Debug)]
pub struct Recorded<L> {
    law: Arc<L>,
    /// `None` where a law cannot be recorded; then there is no Taylor method.
    tape: Option<Tape>,
}

impl<L: Ode<Sym>> Recorded<L> {
    /// Records an autonomous system.
    pub fn new(law: Arc<L>) -> Self {
        let state: Vec<Sym> = (0..law.dimension()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
        let mut rates = vec![Sym::ZERO; state.len()];
        law.rates(Sym::ZERO, &state, &mut rates);
        let tape = Tape::record(&state, &rates).ok();
        Recorded { law, tape }
    }

    fn series<S: integrators::Real>(&self) -> Option<Box<dyn TaylorSeries<S> + '_>> {
        Some(Box::new(Expansion { tape: self.tape.as_ref()?, series: None }))
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

/// The series of a tape, with room made for the order that is asked for.
struct Expansion<'a, S> {
    tape: &'a Tape,
    series: Option<Series<'a, S>>,
}

impl<S: integrators::Real> TaylorSeries<S> for Expansion<'_, S> {
    fn coefficients(&mut self, _t: S, y: &[S], order: usize, out: &mut [S]) {
        if self.series.as_ref().is_none_or(|series| series.order() != order) {
            self.series = self.tape.series(order).ok();
        }
        if let Some(series) = &mut self.series {
            series.expand(y, &[], out);
        }
    }
}
