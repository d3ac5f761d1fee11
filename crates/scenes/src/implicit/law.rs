//! Equations with unknowns as methods run them: with series and a Jacobian.

use super::slopes::ImplicitSlopes;
use super::{Implicit, recurrence};
use field::{DoubleDouble, Scalar};
use integrators::{JacobianFn, Ode, System, TaylorSeries, Variations};
use simulation::LawSeries;
use std::sync::Arc;

/// The law of a system whose accelerations are solved for.
#[derive(Debug)]
pub(crate) struct ImplicitLaw {
    pub equations: Arc<Implicit>,
    series: LawSeries,
}

impl ImplicitLaw {
    pub fn new(equations: Implicit) -> Self {
        let model = Arc::clone(&equations.model);
        ImplicitLaw { equations: Arc::new(equations), series: LawSeries::by(move || recurrence(&model, 0)) }
    }
}

impl<S: Scalar> Ode<S> for ImplicitLaw
where
    Implicit: Ode<S>,
{
    fn dimension(&self) -> usize {
        Ode::<S>::dimension(&*self.equations)
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        self.equations.rates(t, y, dy);
    }
}

impl System for ImplicitLaw {
    fn code_size(&self) -> Option<usize> {
        self.equations.terms.code_size()
    }

    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.series.plain()
    }

    fn taylor_variations(&self) -> Option<Box<dyn TaylorSeries<Variations> + '_>> {
        self.series.directed()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.series.exact()
    }

    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        Some(Box::new(ImplicitSlopes::new(&self.equations)))
    }
}
