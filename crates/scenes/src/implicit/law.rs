//! Equations with unknowns as methods run them: with series and a Jacobian.

use super::slopes::ImplicitSlopes;
use super::{Implicit, recurrence};
use derivations::recorded::Recorded;
use field::{DoubleDouble, Scalar};
use integrators::{Directions, Ode, Slopes, System, TaylorSeries};
use model::Model;
use std::sync::{Arc, OnceLock};

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

/// A law whose accelerations are written down, with a Jacobian by solves.
pub(crate) struct SolvedSlopes<L> {
    law: L,
    model: Arc<Model>,
    /// Made when a method first asks for it; none where it cannot be.
    equations: OnceLock<Option<Implicit>>,
}

impl<L> SolvedSlopes<L> {
    pub fn new(law: L, model: &Arc<Model>) -> Self {
        SolvedSlopes { law, model: Arc::clone(model), equations: OnceLock::new() }
    }
}

impl<S: Scalar, L: Ode<S>> Ode<S> for SolvedSlopes<L> {
    fn dimension(&self) -> usize {
        self.law.dimension()
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        self.law.rates(t, y, dy);
    }
}

impl<L: System> System for SolvedSlopes<L> {
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.law.taylor()
    }

    fn taylor_directions(&self) -> Option<Box<dyn TaylorSeries<Directions> + '_>> {
        self.law.taylor_directions()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.law.taylor_exact()
    }

    fn slopes(&self) -> Option<Box<dyn Slopes + '_>> {
        let equations = self.equations.get_or_init(|| Implicit::of(&self.model).ok()).as_ref()?;
        Some(Box::new(ImplicitSlopes::new(equations)))
    }
}
