//! Methods for DAEs of index 2: y' = f(t, y) + B(t, y) z, 0 = g(t, y), with g_y B regular.
//!
//! | method | order of y | a step |
//! |---|---|---|
//! | half-explicit Euler, Runge-Kutta 4 | 1, 3 | the multipliers of a stage are such that the next stage satisfies the constraint |
//! | Radau IIA with s stages (s = 1: backward Euler) | 2s - 1 | every stage satisfies the constraint, and the last stage is the end |
//! | Gauss with s stages (s = 1: the midpoint rule), projected | 2s | every stage satisfies the constraint, then the end is projected onto it along B |
//!
//! Without the projection, Gauss has the order s + 1 for odd s and s for even s, and the ends of steps violate the
//! constraint: for s = 1, y_1 - y_0 is twice the displacement of the midpoint, and the error in the constraint
//! alternates in sign instead of decaying.
//!
//! Sources: Hairer, Lubich, Roche: The numerical solution of differential-algebraic systems by Runge-Kutta methods (1989);
//! Ascher, Petzold: Projected implicit Runge-Kutta methods for differential-algebraic equations (1991).

mod collocation;
mod half_explicit;
mod onto;
mod projection;

use crate::law::jacobian::Jacobian;
use crate::methods::implicit::collocation::Family;
use crate::methods::integrate::{constant, refused};
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::drive;
use crate::run::watch::Watch;
use crate::run::within::Within;
use crate::{
    Dual8, Index2Dae, Index2DaeSystem, MOST_STAGES, Method, Observer, Ode, Outcome, Refusal, Span, System, Working,
};
use collocation::Collocated;
use field::Scalar;
use half_explicit::HalfExplicit;
use onto::Onto;
use projection::Projected;
use std::fmt;

/// A method for DAEs of index 2, with the number of equal steps over the span.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Index2Method {
    HalfExplicitEuler { steps: u32 },
    HalfExplicitRungeKutta4 { steps: u32 },
    RadauIIA { stages: u8, steps: u32 },
    ProjectedGauss { stages: u8, steps: u32 },
}

impl Index2Method {
    /// The order of convergence of y.
    pub fn order(self) -> u32 {
        match self {
            Index2Method::HalfExplicitEuler { .. } => 1,
            Index2Method::HalfExplicitRungeKutta4 { .. } => 3,
            Index2Method::RadauIIA { stages, .. } => (2 * u32::from(stages)).saturating_sub(1),
            Index2Method::ProjectedGauss { stages, .. } => 2 * u32::from(stages),
        }
    }

    /// The number of steps over the span.
    pub fn steps(self) -> u32 {
        match self {
            Index2Method::HalfExplicitEuler { steps }
            | Index2Method::HalfExplicitRungeKutta4 { steps }
            | Index2Method::RadauIIA { steps, .. }
            | Index2Method::ProjectedGauss { steps, .. } => steps,
        }
    }

    /// The method with a single step over the span.
    fn once(self) -> Self {
        match self {
            Index2Method::HalfExplicitEuler { .. } => Index2Method::HalfExplicitEuler { steps: 1 },
            Index2Method::HalfExplicitRungeKutta4 { .. } => Index2Method::HalfExplicitRungeKutta4 { steps: 1 },
            Index2Method::RadauIIA { stages, .. } => Index2Method::RadauIIA { stages, steps: 1 },
            Index2Method::ProjectedGauss { stages, .. } => Index2Method::ProjectedGauss { stages, steps: 1 },
        }
    }

    fn check(self) -> Result<(), Refusal> {
        match self {
            _ if self.steps() == 0 => Err(Refusal::Steps { given: 0 }),
            Index2Method::RadauIIA { stages, .. } | Index2Method::ProjectedGauss { stages, .. }
                if !(1..=MOST_STAGES).contains(&stages) =>
            {
                Err(Refusal::Stages { given: stages.into(), least: 1, most: MOST_STAGES.into() })
            }
            _ => Ok(()),
        }
    }
}

impl fmt::Display for Index2Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Index2Method::HalfExplicitEuler { steps } => write!(f, "half-explicit Euler, {steps} steps"),
            Index2Method::HalfExplicitRungeKutta4 { steps } => write!(f, "half-explicit Runge-Kutta 4, {steps} steps"),
            Index2Method::RadauIIA { stages, steps } => write!(f, "Radau IIA, {stages} stages, {steps} steps"),
            Index2Method::ProjectedGauss { stages, steps } => {
                write!(f, "projected Gauss, {stages} stages, {steps} steps")
            }
        }
    }
}

/// Integrates a DAE of index 2 over a span; the state is y. The start may violate the constraint: the first step
/// removes the violation.
///
/// Never panics and never returns NaN: a failure is the `end` of the outcome.
pub fn integrate_index2<S: Working>(
    system: &dyn Index2DaeSystem,
    method: Index2Method,
    span: &Span<'_, S>,
    observer: &mut dyn Observer<S>,
) -> Outcome<S> {
    let law = S::held(system);
    let (n, m) = law.sizes();
    if let Err(refusal) = span.check(n, None).and_then(|()| method.check()) {
        return refused(span, refusal);
    }
    let whole = Whole { law, n, m };
    let (mut start, mut rates) = (span.state.clone(), vec![S::zero(); n + m]);
    start.resize(n + m, S::zero());
    whole.rates(S::lift(span.start), &start, &mut rates);
    if let Some(component) = rates.iter().position(|rate| !rate.finite()) {
        return refused(span, Refusal::RatesNotFinite { component });
    }
    let again = |span: &Span<'_, S>| integrate_index2(system, method.once(), span, &mut ());
    let (meter, watch) = (BudgetedRhs::new(&whole, span), Watch::new(span, observer, Within::new(&again, None)));
    let step = watch.length() / S::int(method.steps().into());
    let onto = Onto::new(law, system);
    let slopes = Whole { law: system as &dyn Index2Dae<Dual8>, n, m };
    match method {
        Index2Method::HalfExplicitEuler { .. } => {
            drive(&mut HalfExplicit::new(half_explicit::EULER, step, onto), 0.0, &meter, watch)
        }
        Index2Method::HalfExplicitRungeKutta4 { .. } => {
            drive(&mut HalfExplicit::new(half_explicit::RUNGE_KUTTA_4, step, onto), 0.0, &meter, watch)
        }
        Index2Method::RadauIIA { stages, .. } => {
            drive(&mut Collocated::new(Family::RadauIIA, stages.into(), step, &slopes, onto), 0.0, &meter, watch)
        }
        Index2Method::ProjectedGauss { stages, .. } => {
            drive(&mut Collocated::new(Family::Gauss, stages.into(), step, &slopes, onto), 0.0, &meter, watch)
        }
    }
}

/// Integrates a system with a constant step, and projects the state onto the constraint of `held` along its B after
/// each step. A method with step size control is refused.
pub fn integrate_projected<S: Working>(
    system: &dyn System,
    held: &dyn Index2DaeSystem,
    method: Method,
    span: &Span<'_, S>,
    observer: &mut dyn Observer<S>,
) -> Outcome<S> {
    let law = S::law(system);
    let n = law.dimension();
    let expected = S::held(held).sizes().0;
    let fits = if n == expected { Ok(()) } else { Err(Refusal::Dimension { expected, found: n }) };
    if let Err(refusal) = span.check(n, None).and_then(|()| method.check(n)).and(fits) {
        return refused(span, refusal);
    }
    let again = |span: &Span<'_, S>| integrate_projected(system, held, method.once(), span, &mut ());
    let (meter, watch) = (BudgetedRhs::new(law, span), Watch::new(span, observer, Within::new(&again, None)));
    match constant(|| Jacobian::of(system), method, watch.length(), n) {
        Some(inner) => drive(&mut Projected::new(inner, Onto::new(S::held(held), held)), 0.0, &meter, watch),
        None => refused(span, Refusal::FollowsTolerance),
    }
}

/// The function (f + B z, g) of (y, z), whose Jacobian has all derivatives for Newton's iteration.
struct Whole<'a, S> {
    law: &'a dyn Index2Dae<S>,
    n: usize,
    m: usize,
}

impl<S: Scalar> Ode<S> for Whole<'_, S> {
    fn dimension(&self) -> usize {
        self.n + self.m
    }

    fn rates(&self, t: S, u: &[S], du: &mut [S]) {
        let ((y, z), (dy, g)) = (u.split_at(self.n), du.split_at_mut(self.n));
        self.law.rates(t, y, z, dy);
        self.law.constraints(t, y, g);
    }
}
