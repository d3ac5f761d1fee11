//! Entry points of integration: they check the data, select the method and run it.

use crate::law::jacobian::Jacobian;
use crate::methods::adaptors::ryan_gast::{self, Choice};
use crate::methods::explicit::classical::{Euler, RungeKutta4};
use crate::methods::explicit::dormand_prince::{DormandPrince, EIGHT, FIVE, Pair};
use crate::methods::explicit::gragg::GraggBulirschStoer;
use crate::methods::implicit::bader_deuflhard::BaderDeuflhard;
use crate::methods::implicit::collocation::Family;
use crate::methods::implicit::collocation_step::Implicit;
use crate::methods::implicit::rosenbrock::Rodas4;
use crate::methods::implicit::theta::Theta;
use crate::methods::splitting::Split;
use crate::methods::taylor::TaylorStepper;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Stepper, drive, first_step};
use crate::run::watch::Watch;
use crate::run::within::Within;
use crate::{End, Failure, Method, Observer, Outcome, Real, Refusal, Span, System, Tolerance, Work, Working};

/// Integrates a system over a span. Methods with a constant step ignore the tolerance.
///
/// Never panics and never returns NaN: a failure is the `end` of the outcome.
pub fn integrate(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    span: &Span<'_, f64>,
    observer: &mut dyn Observer<f64>,
) -> Outcome<f64> {
    let run = |meter: &BudgetedRhs<f64>, watch: Watch<'_, '_, f64>| match method {
        Method::DormandPrince5 => run_pair((system, &FIVE), tolerance, meter, watch),
        Method::DormandPrince8 => run_pair((system, &EIGHT), tolerance, meter, watch),
        Method::Verner6 => ryan_gast::run(Choice::Verner6, system, tolerance, meter, watch),
        Method::Verner9 => ryan_gast::run(Choice::Verner9, system, tolerance, meter, watch),
        Method::Radau5 => ryan_gast::run(Choice::Radau5, system, tolerance, meter, watch),
        Method::Kvaerno5 => ryan_gast::run(Choice::Kvaerno5, system, tolerance, meter, watch),
        Method::Rodas4 => {
            let first = first_step(meter, watch.state(), tolerance, 4, watch.length());
            drive(&mut Rodas4::new(Jacobian::of(system), tolerance, meter.dimension()), first, meter, watch)
        }
        Method::BaderDeuflhard => {
            let mut stepper = BaderDeuflhard::new(Jacobian::of(system), tolerance, meter.dimension());
            let first = first_step(meter, watch.state(), tolerance, stepper.first_order(), watch.length());
            drive(&mut stepper, first, meter, watch)
        }
        _ => run_own(system, method, tolerance, meter, watch),
    };
    let again = |span: &Span<'_, f64>| integrate(system, method.once(), tolerance, span, &mut ());
    prepared(system, method, tolerance, span, (observer, &again), run)
}

/// Integrates in any scalar type. Only methods with `exact` in their [`Traits`](super::Traits) are accepted.
pub fn integrate_in<S: Working>(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    span: &Span<'_, S>,
    observer: &mut dyn Observer<S>,
) -> Outcome<S> {
    let run = |meter: &BudgetedRhs<S>, watch: Watch<'_, '_, S>| run_own(system, method, tolerance, meter, watch);
    let again = |span: &Span<'_, S>| integrate_in(system, method.once(), tolerance, span, &mut ());
    prepared(system, method, tolerance, span, (observer, &again), run)
}

/// Gauss collocation. Also returns the integral of the spectral radius over the run, a measure of stiffness.
pub(crate) fn collocate_gauss<S: Working>(
    system: &dyn System,
    stages: u8,
    tolerance: &Tolerance,
    span: &Span<'_, S>,
    observer: &mut dyn Observer<S>,
) -> (Outcome<S>, f64) {
    let mut turns = 0.0;
    let run = |meter: &BudgetedRhs<S>, watch: Watch<'_, '_, S>| {
        let outcome;
        (outcome, turns) = collocate(system, Family::Gauss, stages.into(), tolerance, meter, watch);
        outcome
    };
    let method = Method::Gauss { stages };
    let again = |span: &Span<'_, S>| integrate_in(system, method, tolerance, span, &mut ());
    let outcome = prepared(system, method, tolerance, span, (observer, &again), run);
    (outcome, turns)
}

/// Runs one of Dormand and Prince's pairs.
fn run_pair(
    (system, pair): (&dyn System, &'static Pair),
    tolerance: &Tolerance,
    meter: &BudgetedRhs<f64>,
    watch: Watch<'_, '_, f64>,
) -> Outcome<f64> {
    let first = first_step(meter, watch.state(), tolerance, pair.order, watch.length());
    drive(&mut DormandPrince::new(system, pair, tolerance, meter.dimension()), first, meter, watch)
}

/// Runs the method over another span, without an observer.
type Again<'a, S> = &'a dyn Fn(&Span<'_, S>) -> Outcome<S>;

/// Checks the data, then runs the method.
fn prepared<S: Working>(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    span: &Span<'_, S>,
    (observer, again): (&mut dyn Observer<S>, Again<'_, S>),
    run: impl FnOnce(&BudgetedRhs<S>, Watch<'_, '_, S>) -> Outcome<S>,
) -> Outcome<S> {
    let law = S::law(system);
    let followed = method.traits().adaptive.then_some(tolerance);
    if let Err(refusal) = span.check(law.dimension(), followed).and_then(|()| method.check(law.dimension())) {
        return refused(span, refusal);
    }
    let mut rates = vec![S::zero(); law.dimension()];
    law.rates(S::lift(span.start), &span.state, &mut rates);
    if let Some(component) = rates.iter().position(|rate| !rate.finite()) {
        return refused(span, Refusal::RatesNotFinite { component });
    }
    let watch = Watch::new(span, observer, Within::new(again, followed)).projected(S::projection(system));
    let meter = BudgetedRhs::new(law, span);
    match followed.is_some() && !span.within_step {
        true => run(&meter.bounded(system.step_bounds(span.start, span.end)), watch),
        false => run(&meter, watch),
    }
}

/// The outcome of a run with invalid data.
pub(crate) fn refused<S: Real>(span: &Span<'_, S>, refusal: Refusal) -> Outcome<S> {
    Outcome {
        end: End::Stopped(Failure::Refused(refusal)),
        time: span.start,
        state: span.state.clone(),
        work: Work::default(),
        deviations: Vec::new(),
    }
}

/// The methods with a constant step, over any scalar type; `None` for other methods.
pub(crate) fn constant<'a, S: Real>(
    jacobian: impl FnOnce() -> Jacobian<'a>,
    method: Method,
    length: S,
    n: usize,
) -> Option<Box<dyn Stepper<S> + 'a>> {
    let step = |steps: u32| length / S::int(steps.into());
    Some(match method {
        Method::Euler { steps } => Box::new(Euler::new(step(steps), n)),
        Method::RungeKutta4 { steps } => Box::new(RungeKutta4::new(step(steps), n)),
        Method::BackwardEuler { steps } => Box::new(Theta::new(step(steps), S::one(), jacobian(), n)),
        Method::ImplicitMidpoint { steps } => Box::new(Theta::new(step(steps), S::ratio(1, 2), jacobian(), n)),
        _ => return None,
    })
}

/// Runs a method of this crate, over any scalar type.
fn run_own<S: Working>(
    system: &dyn System,
    method: Method,
    tolerance: &Tolerance,
    meter: &BudgetedRhs<S>,
    watch: Watch<'_, '_, S>,
) -> Outcome<S> {
    let (n, length) = (meter.dimension(), watch.length());
    let first = |order| first_step(meter, watch.state(), tolerance, order, length.approx());
    if let Some(mut stepper) = constant(|| Jacobian::of(system), method, length, n) {
        return drive(&mut *stepper, 0.0, meter, watch);
    }
    match method {
        Method::GraggBulirschStoer => {
            let mut stepper = GraggBulirschStoer::new(tolerance, n);
            let first = first(stepper.first_order());
            drive(&mut stepper, first, meter, watch)
        }
        Method::Gauss { stages } => collocate(system, Family::Gauss, stages.into(), tolerance, meter, watch).0,
        Method::RadauIIA { stages } => collocate(system, Family::RadauIIA, stages.into(), tolerance, meter, watch).0,
        Method::Taylor => match S::series(system) {
            Some(source) => drive(&mut TaylorStepper::new(source, tolerance), length.approx(), meter, watch),
            None => watch.fail(Failure::Refused(Refusal::NoSeries), meter),
        },
        Method::Split { splitting, steps } if S::EPSILON >= f64::EPSILON || splitting.exact() => {
            match S::composed(system, splitting) {
                Some(composed) => {
                    let step = length / S::int(steps.into());
                    drive(&mut Split::new(composed, splitting, step), 0.0, meter, watch)
                }
                None => watch.fail(Failure::Refused(Refusal::NoPieces), meter),
            }
        }
        Method::Split { .. }
        | Method::Euler { .. }
        | Method::RungeKutta4 { .. }
        | Method::BackwardEuler { .. }
        | Method::ImplicitMidpoint { .. }
        | Method::DormandPrince5
        | Method::DormandPrince8
        | Method::Verner6
        | Method::Verner9
        | Method::Radau5
        | Method::Kvaerno5
        | Method::Rodas4
        | Method::BaderDeuflhard => watch.fail(Failure::Refused(Refusal::Field), meter),
    }
}

/// Runs a collocation method. Also returns the integral of the spectral radius over the run.
fn collocate<S: Real>(
    system: &dyn System,
    family: Family,
    stages: usize,
    tolerance: &Tolerance,
    meter: &BudgetedRhs<S>,
    watch: Watch<'_, '_, S>,
) -> (Outcome<S>, f64) {
    let mut stepper = Implicit::new(family, stages, Jacobian::of(system), tolerance, meter.dimension());
    // the first step is chosen for the order s of the stages, not for the higher order at the end of the step
    let first = first_step(meter, watch.state(), tolerance, stages as u32, watch.length().approx());
    let outcome = drive(&mut stepper, first, meter, watch);
    (outcome, stepper.turns)
}
