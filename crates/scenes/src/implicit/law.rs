//! The law of a system whose accelerations are solved for numerically, with Taylor series and Jacobian.

use super::slopes::ImplicitSlopes;
use super::{Implicit, recurrence};
use field::{DoubleDouble, Scalar};
use integrators::{JacobianFn, Ode, StepBounds, System, TaylorSeries, Variations};
use simulation::{LawSeries, TimeScales};
use std::sync::{Arc, OnceLock};

/// A law whose accelerations are solved for at each evaluation.
#[derive(Debug)]
pub(crate) struct ImplicitLaw {
    /// The linear equations for the accelerations.
    pub equations: Arc<Implicit>,
    series: LawSeries,
    /// The time scales of explicit functions of time, which limit the step; `None` if time appears only linearly.
    time_scales: OnceLock<Option<TimeScales>>,
}

impl ImplicitLaw {
    /// The law of these equations.
    pub fn new(equations: Implicit) -> Self {
        let model = Arc::clone(&equations.model);
        ImplicitLaw {
            equations: Arc::new(equations),
            series: LawSeries::by(move || recurrence(&model, 0)),
            time_scales: OnceLock::new(),
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
    fn code_size(&self) -> Option<usize> {
        self.equations.terms.code_size()
    }

    fn step_bounds(&self, from: f64, to: f64) -> StepBounds {
        let made = self.time_scales.get_or_init(|| TimeScales::of(&self.equations.terms));
        made.as_ref().map_or_else(StepBounds::default, |scales| scales.bounds(from, to))
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
