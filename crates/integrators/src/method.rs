//! The methods by name, and the one entry to all of them.

use std::fmt;

use crate::adaptors::dormand_prince::{self, Pair};
use crate::adaptors::ryan_gast::{self, Choice};
use crate::classical::{Euler, RungeKutta4};
use crate::collocation::Family;
use crate::drive::{drive, first_step};
use crate::gragg::GraggBulirschStoer;
use crate::implicit::Implicit;
use crate::meter::Meter;
use crate::rosenbrock::Rodas4;
use crate::taylor::Taylor;
use crate::watch::Watch;
use crate::{End, Failure, Observer, Outcome, Real, Refusal, Span, System, Tolerance, Work, Working};

/// The most stages of a collocation method: tested to 30 digits up to here.
pub const MOST_STAGES: u8 = 20;

/// The most unknowns of one implicit step: its dense matrix has this number squared.
const MOST_UNKNOWNS: usize = 4000;

/// A method, by inventor and stages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// Explicit Euler with so many equal steps over the span.
    Euler { steps: u32 },
    /// The classical Runge-Kutta method of order 4 with so many equal steps over the span.
    RungeKutta4 { steps: u32 },
    /// Dormand-Prince 5(4), crate `ode_solvers`.
    DormandPrince5,
    /// Dormand-Prince 8(5,3), crate `ode_solvers`.
    DormandPrince8,
    /// Verner's 6(5), crate `differential-equations`.
    Verner6,
    /// Verner's 9(8), crate `differential-equations`.
    Verner9,
    /// Hairer and Wanner's Radau5, crate `differential-equations`.
    Radau5,
    /// Kvaerno's ESDIRK 5(4) with 7 stages, crate `differential-equations`.
    Kvaerno5,
    /// Gragg-Bulirsch-Stoer extrapolation, variable order.
    GraggBulirschStoer,
    /// Gauss collocation, order 2s.
    Gauss { stages: u8 },
    /// Radau IIA collocation, order 2s - 1.
    RadauIIA { stages: u8 },
    /// Hairer and Wanner's Rosenbrock pair 4(3) with 6 stages.
    Rodas4,
    /// Taylor's method after Jorba and Zou, for systems that offer their coefficients.
    Taylor,
}

/// What is known of a method before it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Traits {
    /// The order in the step; none where it varies with the tolerance.
    pub order: Option<u32>,
    /// Solves equations in each step: takes stiff problems.
    pub implicit: bool,
    /// Follows a tolerance; a method that does not has a constant step.
    pub adaptive: bool,
    /// Runs in double-double too.
    pub exact: bool,
    /// Lands its steps on the outputs; otherwise reads them off its own polynomial.
    pub lands: bool,
}

impl Method {
    /// The method's properties.
    pub fn traits(self) -> Traits {
        let adaptive = Traits { order: None, implicit: false, adaptive: true, exact: true, lands: true };
        match self {
            Method::Euler { .. } => Traits { order: Some(1), adaptive: false, ..adaptive },
            Method::RungeKutta4 { .. } => Traits { order: Some(4), adaptive: false, ..adaptive },
            Method::DormandPrince5 => Traits { order: Some(5), exact: false, ..adaptive },
            Method::DormandPrince8 => Traits { order: Some(8), exact: false, ..adaptive },
            Method::Verner6 => Traits { order: Some(6), exact: false, ..adaptive },
            Method::Verner9 => Traits { order: Some(9), exact: false, ..adaptive },
            Method::Radau5 | Method::Kvaerno5 => Traits { order: Some(5), exact: false, implicit: true, ..adaptive },
            Method::GraggBulirschStoer => adaptive,
            Method::Gauss { stages } => Traits { order: Some(2 * u32::from(stages)), implicit: true, ..adaptive },
            Method::RadauIIA { stages } => {
                Traits { order: Some((2 * u32::from(stages)).saturating_sub(1)), implicit: true, ..adaptive }
            }
            Method::Rodas4 => Traits { order: Some(4), exact: false, implicit: true, ..adaptive },
            Method::Taylor => Traits { lands: false, ..adaptive },
        }
    }

    /// What no run of this method could work with.
    fn check(self, dimension: usize) -> Result<(), Refusal> {
        match self {
            Method::Euler { steps: 0 } | Method::RungeKutta4 { steps: 0 } => Err(Refusal::Steps { given: 0 }),
            Method::Gauss { stages } | Method::RadauIIA { stages } if !(1..=MOST_STAGES).contains(&stages) => {
                Err(Refusal::Stages { given: stages.into(), least: 1, most: MOST_STAGES.into() })
            }
            Method::Gauss { stages } | Method::RadauIIA { stages }
                if dimension > MOST_UNKNOWNS / usize::from(stages) =>
            {
                Err(Refusal::TooLarge { dimension, most: MOST_UNKNOWNS / usize::from(stages) })
            }
            Method::Rodas4 if dimension > MOST_UNKNOWNS => Err(Refusal::TooLarge { dimension, most: MOST_UNKNOWNS }),
            _ => Ok(()),
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Method::Euler { steps } => write!(f, "Euler, {steps} steps"),
            Method::RungeKutta4 { steps } => write!(f, "Runge-Kutta 4, {steps} steps"),
            Method::DormandPrince5 => write!(f, "Dormand-Prince 5(4)"),
            Method::DormandPrince8 => write!(f, "Dormand-Prince 8(5,3)"),
            Method::Verner6 => write!(f, "Verner 6(5)"),
            Method::Verner9 => write!(f, "Verner 9(8)"),
            Method::Radau5 => write!(f, "Radau5"),
            Method::Kvaerno5 => write!(f, "Kvaerno 5(4)"),
            Method::GraggBulirschStoer => write!(f, "Gragg-Bulirsch-Stoer"),
            Method::Gauss { stages } => write!(f, "Gauss, {stages} stages"),
            Method::RadauIIA { stages } => write!(f, "Radau IIA, {stages} stages"),
            Method::Rodas4 => write!(f, "Rodas4"),
            Method::Taylor => write!(f, "Taylor"),
        }
    }
}

/// Integrates a system over a span. The tolerance is ignored by a method with a constant step.
///
/// Never panics, never answers with a number that is not one: what goes wrong is the outcome's end.
pub fn integrate(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    span: &Span<'_, f64>,
    observer: &mut dyn Observer<f64>,
) -> Outcome<f64> {
    let run = |meter: &Meter<f64>, watch: Watch<'_, '_, f64>| match method {
        Method::DormandPrince5 => dormand_prince::run(Pair::Five, tolerance, meter, watch),
        Method::DormandPrince8 => dormand_prince::run(Pair::Eight, tolerance, meter, watch),
        Method::Verner6 => ryan_gast::run(Choice::Verner6, system, tolerance, meter, watch),
        Method::Verner9 => ryan_gast::run(Choice::Verner9, system, tolerance, meter, watch),
        Method::Radau5 => ryan_gast::run(Choice::Radau5, system, tolerance, meter, watch),
        Method::Kvaerno5 => ryan_gast::run(Choice::Kvaerno5, system, tolerance, meter, watch),
        Method::Rodas4 => {
            let first = first_step(meter, watch.state(), tolerance, 4, watch.length());
            drive(&mut Rodas4::new(system, tolerance, meter.dimension()), first, meter, watch)
        }
        _ => run_own(system, method, tolerance, meter, watch),
    };
    prepared(system, method, tolerance, span, observer, run)
}

/// Integrates in any working field: the methods that are `exact` by their [`Traits`], the others are refused.
pub fn integrate_in<S: Working>(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    span: &Span<'_, S>,
    observer: &mut dyn Observer<S>,
) -> Outcome<S> {
    let run = |meter: &Meter<S>, watch: Watch<'_, '_, S>| run_own(system, method, tolerance, meter, watch);
    prepared(system, method, tolerance, span, observer, run)
}

/// Gauss collocation with the integral of the spectral radius along its way: how much there was to follow.
pub(crate) fn collocate_gauss<S: Working>(
    system: &dyn System,
    stages: u8,
    tolerance: &Tolerance,
    span: &Span<'_, S>,
    observer: &mut dyn Observer<S>,
) -> (Outcome<S>, f64) {
    let mut turns = 0.0;
    let run = |meter: &Meter<S>, watch: Watch<'_, '_, S>| {
        let outcome;
        (outcome, turns) = collocate(system, Family::Gauss, stages.into(), tolerance, meter, watch);
        outcome
    };
    let outcome = prepared(system, Method::Gauss { stages }, tolerance, span, observer, run);
    (outcome, turns)
}

/// Checks the data, then runs.
fn prepared<S: Working>(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    span: &Span<'_, S>,
    observer: &mut dyn Observer<S>,
    run: impl FnOnce(&Meter<S>, Watch<'_, '_, S>) -> Outcome<S>,
) -> Outcome<S> {
    let law = S::law(system);
    let followed = method.traits().adaptive.then_some(tolerance);
    let refuse = |refusal| Outcome {
        end: End::Stopped(Failure::Refused(refusal)),
        time: span.start,
        state: span.state.clone(),
        work: Work::default(),
        deviations: Vec::new(),
    };
    if let Err(refusal) = span.check(law.dimension(), followed).and_then(|()| method.check(law.dimension())) {
        return refuse(refusal);
    }
    let mut rates = vec![S::zero(); law.dimension()];
    law.rates(S::lift(span.start), &span.state, &mut rates);
    if let Some(component) = rates.iter().position(|rate| !rate.finite()) {
        return refuse(Refusal::RatesNotFinite { component });
    }
    run(&Meter::new(law, span), Watch::new(span, observer))
}

/// The methods of this crate, over any field.
fn run_own<S: Working>(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    meter: &Meter<S>,
    watch: Watch<'_, '_, S>,
) -> Outcome<S> {
    let (n, length) = (meter.dimension(), watch.length());
    let first = |order| first_step(meter, watch.state(), tolerance, order, length.approx());
    match method {
        Method::Euler { steps } => drive(&mut Euler::new(length / S::int(steps.into()), n), 0.0, meter, watch),
        Method::RungeKutta4 { steps } => {
            drive(&mut RungeKutta4::new(length / S::int(steps.into()), n), 0.0, meter, watch)
        }
        Method::GraggBulirschStoer => {
            let mut stepper = GraggBulirschStoer::new(tolerance, n);
            let first = first(stepper.first_order());
            drive(&mut stepper, first, meter, watch)
        }
        Method::Gauss { stages } => collocate(system, Family::Gauss, stages.into(), tolerance, meter, watch).0,
        Method::RadauIIA { stages } => collocate(system, Family::RadauIIA, stages.into(), tolerance, meter, watch).0,
        Method::Taylor => match S::series(system) {
            Some(source) => {
                let mut stepper = Taylor::new(source, tolerance, n);
                let reach = stepper.look_ahead(S::zero(), watch.state(), meter);
                drive(&mut stepper, reach.min(length.approx()), meter, watch)
            }
            None => watch.fail(Failure::Refused(Refusal::NoSeries), meter),
        },
        Method::DormandPrince5
        | Method::DormandPrince8
        | Method::Verner6
        | Method::Verner9
        | Method::Radau5
        | Method::Kvaerno5
        | Method::Rodas4 => watch.fail(Failure::Refused(Refusal::Field), meter),
    }
}

/// A collocation method, and the integral of the spectral radius along its way.
fn collocate<S: Real>(
    system: &dyn System,
    family: Family,
    stages: usize,
    tolerance: &Tolerance,
    meter: &Meter<S>,
    watch: Watch<'_, '_, S>,
) -> (Outcome<S>, f64) {
    let mut stepper = Implicit::new(family, stages, system, tolerance, meter.dimension());
    // the stages alone must follow the first step: their order, not the higher one at its end
    let first = first_step(meter, watch.state(), tolerance, stages as u32, watch.length().approx());
    let outcome = drive(&mut stepper, first, meter, watch);
    (outcome, stepper.turns)
}
