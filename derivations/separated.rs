//! A system with the pieces of its law, for the splitting methods.

use crate::recorded::Recorded;
use field::{DoubleDouble, Scalar};
use integrators::{Composed, Directions, Ode, Pieces, Real, Splitting, System, TaylorSeries, compose};
use std::sync::Arc;
use symbolic::Sym;

/// A law that is a sum of fields whose flows are known.
pub trait Separable {
    /// The pieces over a field; none where the law cannot be taken apart.
    fn pieces<S: Real>(&self) -> Option<impl Pieces<S>>;
}

/// A law recorded for the Taylor method, and taken apart for the splitting methods.
#[derive(Clone, Debug)]
pub struct Separated<L> {
    law: Arc<L>,
    recorded: Recorded<L>,
}

impl<L: Ode<Sym>> Separated<L> {
    /// Records an autonomous system.
    pub fn new(law: Arc<L>) -> Self {
        Separated { recorded: Recorded::new(Arc::clone(&law)), law }
    }
}

impl<S: Scalar, L: Ode<S>> Ode<S> for Separated<L> {
    fn dimension(&self) -> usize {
        self.law.dimension()
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        self.law.rates(t, y, dy);
    }
}

impl<L: Separable + Ode<Sym> + Ode<f64> + Ode<Directions> + Ode<DoubleDouble>> System for Separated<L> {
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.recorded.taylor()
    }

    fn taylor_directions(&self) -> Option<Box<dyn TaylorSeries<Directions> + '_>> {
        self.recorded.taylor_directions()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.recorded.taylor_exact()
    }

    fn composed(&self, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        Some(compose(self.law.pieces()?, splitting))
    }

    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        Some(compose(self.law.pieces()?, splitting))
    }
}
