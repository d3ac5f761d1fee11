//! One run with one treatment, with its errors and cost.

use super::Treatment;
use super::goal::{Goal, SPAN, START, reduced, span, whole};
use crate::stabilisation::law::{BothHeld, Stabilised};
use crate::stabilisation::regions::MECHANISM;
use crate::stabilisation::schemes::Scheme;
use integrators::{
    Failure, Index2Method, Observer, Outcome, Tolerance, integrate, integrate_index2, integrate_projected,
};
use systems::crank_slider::CrankSlider;

/// Errors and cost of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The largest |f| after a step, m^2.
    pub drift: f64,
    /// The largest |f'| after a step, m^2/s.
    pub rate_drift: f64,
    /// The largest error of (q, q') at the outputs, each component relative to its size.
    pub error: f64,
    /// The number of evaluations of the equations of motion; a Jacobian counts as one for each column.
    pub evaluations: u64,
    /// The number of evaluations of the constraint alone, for projections of coordinates and velocities.
    pub corrections: u64,
}

/// A treatment with its gains, ready to run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Run {
    pub scheme: Scheme,
    pub steps: u32,
    pub way: Keeping,
}

/// The treatment of the constraint, with its gains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Keeping {
    /// Stabilised: f'' = -b f' - k f with (h b, h^2 k).
    Led(f64, f64),
    Projected,
    BothHeld,
    Minimal,
}

impl Run {
    /// `None` where the method has no such gains.
    pub fn new(scheme: Scheme, steps: u32, treatment: Treatment) -> Option<Self> {
        let h = SPAN / f64::from(steps);
        let critical = |rate: f64| Keeping::Led(2.0 * rate * h, (rate * h).powi(2));
        let way = match treatment {
            Treatment::IndexReduction => Keeping::Led(0.0, 0.0),
            Treatment::Fastest => scheme.best().map(|(beta, kappa)| Keeping::Led(beta, kappa))?,
            Treatment::Moderate => critical(super::MODERATE),
            Treatment::MostAccurate { rate } => critical(rate),
            Treatment::Projected => Keeping::Projected,
            Treatment::GearGuptaLeimkuhler => Keeping::BothHeld,
            Treatment::Minimal => Keeping::Minimal,
        };
        Some(Run { scheme, steps, way })
    }

    /// Runs from the start to the end of the span.
    pub fn go(&self, observer: &mut dyn Observer<f64>) -> Outcome<f64> {
        let (method, h) = (self.scheme.method(self.steps), SPAN / f64::from(self.steps));
        let law = |beta: f64, kappa: f64| Stabilised::<CrankSlider<f64>, 2, 1> {
            system: &MECHANISM,
            damping: beta / h,
            stiffness: kappa / (h * h),
        };
        let (held, span_of_all) = (BothHeld::<CrankSlider<f64>, 2, 1>(&MECHANISM), span(&whole(&START)));
        // methods with a constant step size ignore the tolerance
        let tolerance = Tolerance::both(1e-9);
        match self.way {
            Keeping::Led(beta, kappa) => integrate(&law(beta, kappa), method, &tolerance, &span_of_all, observer),
            Keeping::Projected => integrate_projected(&law(0.0, 0.0), &held, method, &span_of_all, observer),
            Keeping::BothHeld => integrate_index2(&held, self.holding(), &span_of_all, observer),
            Keeping::Minimal => integrate(&reduced(), method, &tolerance, &span(&START), observer),
        }
    }

    /// The method of the scheme for the equations with f = 0 and f' = 0.
    fn holding(&self) -> Index2Method {
        let steps = self.steps;
        match self.scheme {
            Scheme::Euler => Index2Method::HalfExplicitEuler { steps },
            Scheme::RungeKutta4 => Index2Method::HalfExplicitRungeKutta4 { steps },
            Scheme::BackwardEuler => Index2Method::RadauIIA { stages: 1, steps },
            Scheme::ImplicitMidpoint => Index2Method::ProjectedGauss { stages: 1, steps },
        }
    }

    /// Runs and compares with the exact motion.
    pub fn measure(&self, goal: &Goal) -> Result<Measured, Failure> {
        let mut watch = goal.watch(self.way == Keeping::Minimal);
        let outcome = self.go(&mut watch);
        if let Some(failure) = outcome.failure() {
            return Err(failure);
        }
        let (drift, rate_drift, error) = (watch.drift, watch.rate_drift, watch.error);
        let columns = match self.way {
            Keeping::Led(..) | Keeping::Projected => 4,
            Keeping::BothHeld => 6,
            Keeping::Minimal => 2,
        };
        let evaluations = outcome.work.rates + columns * outcome.work.jacobians;
        Ok(Measured { drift, rate_drift, error, evaluations, corrections: outcome.work.constraints })
    }
}
