//! A system with the pieces of its law, for the splitting methods.

use crate::machines::Programs;
use crate::recorded::Recorded;
use crate::taped::Running;
use field::{DoubleDouble, Scalar};
use integrators::{Composed, Directions, Ode, Pieces, Real, Splitting, System, TaylorSeries, compose};
use std::sync::{Arc, OnceLock};
use symbolic::Sym;

/// A law that is a sum of fields whose flows are known.
pub trait Separable {
    /// The programs by which the pieces run.
    fn programs(&self) -> Programs;

    /// The pieces over a field, by these programs or law by law; none where the law cannot be taken apart.
    fn pieces_by<'a, S: Real + Running>(&'a self, programs: Option<&'a Programs>) -> Option<impl Pieces<S> + 'a>;

    /// The pieces law by law.
    fn pieces<S: Real + Running>(&self) -> Option<impl Pieces<S>> {
        self.pieces_by(None)
    }
}

/// A law recorded for the Taylor method, and taken apart for the splitting methods.
#[derive(Clone, Debug)]
pub struct Separated<L> {
    law: Arc<L>,
    recorded: Recorded<L>,
    /// Made when they are first asked for.
    programs: OnceLock<Programs>,
}

impl<L: Ode<Sym> + Sync> Separated<L> {
    /// Records an autonomous system.
    pub fn new(law: Arc<L>) -> Self {
        Separated { recorded: Recorded::new(Arc::clone(&law)), law, programs: OnceLock::new() }
    }
}

impl<L: Separable> Separated<L> {
    fn composed_in<S: Real + Running>(&self, splitting: Splitting) -> Option<Box<dyn Composed<S> + '_>> {
        let programs = self.programs.get_or_init(|| self.law.programs());
        Some(compose(self.law.pieces_by(Some(programs))?, splitting))
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

impl<L: Separable + Ode<Sym> + Ode<f64> + Ode<Directions> + Ode<DoubleDouble> + Sync> System for Separated<L> {
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
        self.composed_in(splitting)
    }

    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        self.composed_in(splitting)
    }
}
