//! Equations with unknowns as methods run them: with series and a Jacobian.

use super::slopes::ImplicitSlopes;
use super::{Implicit, recurrence};
use derivations::recorded::Recorded;
use field::{DoubleDouble, Scalar};
use integrators::{Directions, Ode, Slopes, System, TaylorSeries};
use std::sync::Arc;

/// The law of a system whose accelerations are solved for.
#[derive(Debug)]
pub(crate) struct ImplicitLaw {
    pub equations: Arc<Implicit>,
    recorded: Recorded<Implicit>,
}

impl ImplicitLaw {
    pub fn new(equations: Implicit) -> Self {
        let equations = Arc::new(equations);
        ImplicitLaw {
            recorded: Recorded::by(Arc::clone(&equations), |implicit| recurrence(&implicit.model)),
            equations,
        }
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
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.recorded.taylor()
    }

    fn taylor_directions(&self) -> Option<Box<dyn TaylorSeries<Directions> + '_>> {
        self.recorded.taylor_directions()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.recorded.taylor_exact()
    }

    fn slopes(&self) -> Option<Box<dyn Slopes + '_>> {
        Some(Box::new(ImplicitSlopes::new(&self.equations)))
    }
}
