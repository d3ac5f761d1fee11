//! The loop over the steps of a method of this crate.

use crate::run::brink::Brink;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::watch::Watch;
use crate::{Failure, Outcome, Real, Tolerance};

/// The result of an attempted step, and the size of the next one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Attempt {
    Accepted {
        next: f64,
    },
    Rejected {
        next: f64,
        cause: Cause,
    },
    /// The step is accepted, but stability, not accuracy, limits the step size: the problem is stiff.
    Limited {
        next: f64,
    },
}

/// An explicit method completes a stiff problem if at most this many steps remain: this is cheaper for the user than
/// another method.
const FEW: f64 = 5_000.0;

/// An interval of at most this many roundings of the time is not divided.
const AT_ONCE: f64 = 16.0;

/// The reason why a step was rejected. If no shorter step succeeds, it is the reason of the failure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Cause {
    Error,
    Newton,
    Singular,
    Undefined,
    GoesBack { back: f64, rate: f64, most: f64 },
}

impl Cause {
    pub(crate) fn failure(self, at: f64, step: f64) -> Failure {
        match self {
            Cause::Error => Failure::StepCollapsed { at, step },
            Cause::Newton => Failure::NewtonFailed { at, step },
            Cause::Singular => Failure::Singular { at },
            Cause::Undefined => Failure::LeftTheNumbers { at },
            Cause::GoesBack { back, rate, most } => Failure::GoesBack { at, step, back, rate, most },
        }
    }
}

/// A one-step method with its buffers.
pub(crate) trait Stepper<S: Real> {
    /// Attempts a step of size `step` from `before` at tau. The result of an accepted step is in `after`.
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt;

    /// The largest next step size, for methods that know it before the step.
    fn reach(&mut self, _tau: S, _before: &[S], _meter: &BudgetedRhs<S>) -> Option<f64> {
        None
    }

    /// The step size of a method without error control.
    fn fixed(&self) -> Option<S> {
        None
    }

    /// Whether the method has a dense output as accurate as its steps: steps then need not end at outputs.
    fn reads_between(&self) -> bool {
        false
    }

    /// The dense output at the time `passed` after the beginning of the last accepted step.
    fn between(&self, _passed: S, _state: &mut [S]) {}
}

/// Runs a method to the end of the span, or to a failure.
pub(crate) fn drive<S: Real>(
    stepper: &mut dyn Stepper<S>,
    first: f64,
    meter: &BudgetedRhs<S>,
    mut watch: Watch<'_, '_, S>,
) -> Outcome<S> {
    let (mut after, mut between) = (watch.state().to_vec(), watch.state().to_vec());
    let first = first.max(AT_ONCE * S::EPSILON * watch.time().abs());
    let (mut tau, mut proposed, mut last_cause) = (S::zero(), first, Cause::Error);
    let mut brink = Brink::default();
    let mut even = Even { plan: None, all: 0, done: 0 };
    // the longest step from here that may give finite values
    let mut finite = f64::INFINITY;
    while watch.goes_on() {
        let stop = if stepper.reads_between() { watch.length() } else { watch.landing() };
        let remaining = stop - tau;
        if let Some(reach) = stepper.reach(tau, watch.state(), meter) {
            proposed = reach.min(finite);
        }
        let step = match stepper.fixed() {
            Some(fixed) => even.step(tau, stop, fixed),
            // a few roundings of the time are one step
            None if remaining.approx() <= AT_ONCE * S::EPSILON * watch.time().abs() => remaining,
            None => shorten(meter.longest(tau, proposed), remaining),
        };
        let at = watch.time();
        let lands = step == remaining || even.lands();
        if !lands && (step.approx() <= 4.0 * S::EPSILON * at.abs() || tau + step == tau) || !step.finite() {
            return watch.fail(last_cause.failure(at, step.approx()), meter);
        }
        let attempt = stepper.attempt(tau, watch.state(), step, &mut after, meter);
        if let Some(failure) = meter.exhausted(at) {
            return watch.fail(failure, meter);
        }
        if brink.creeps(matches!(attempt, Attempt::Rejected { cause: Cause::Undefined, .. })) {
            return watch.fail(Failure::LeftTheNumbers { at }, meter);
        }
        match attempt {
            Attempt::Limited { .. } if (watch.length() - tau).approx() > FEW * step.approx() => {
                return watch.fail(Failure::Stiff { at }, meter);
            }
            Attempt::Accepted { next } | Attempt::Limited { next } if after.iter().all(|y| y.finite()) => {
                let end = match even.next() {
                    _ if lands => stop,
                    Some(end) => end,
                    None => tau + step,
                };
                while stepper.reads_between()
                    && let Some(output) = watch.output_up_to(end)
                    && output < end
                {
                    stepper.between(output - tau, &mut between);
                    watch.sample(&mut between);
                }
                if stepper.reads_between() {
                    watch.look_between(end, |passed, state| stepper.between(passed, state));
                }
                tau = end;
                watch.take(tau, &mut after);
                finite = f64::INFINITY;
                proposed = if lands { next.max(proposed) } else { next };
            }
            Attempt::Accepted { .. } | Attempt::Limited { .. } if stepper.fixed().is_some() => {
                return watch.fail(Failure::LeftTheNumbers { at }, meter);
            }
            Attempt::Accepted { .. } | Attempt::Limited { .. } => {
                finite = step.approx() / 4.0;
                (proposed, last_cause) = (finite, Cause::Undefined);
                watch.reject();
            }
            Attempt::Rejected { cause, .. } if stepper.fixed().is_some() => {
                return watch.fail(cause.failure(at, step.approx()), meter);
            }
            Attempt::Rejected { next, cause } => {
                (proposed, last_cause) = (next.min(step.approx() * 0.9), cause);
                watch.reject();
            }
        }
    }
    let end = watch.end();
    watch.finish(end, meter)
}

/// Equal steps up to the next time at which a step must end. Times are computed as multiples of the step, whose
/// rounding does not grow with the number of steps.
struct Even<S> {
    plan: Option<(S, S, S)>,
    all: u64,
    done: u64,
}

impl<S: Real> Even<S> {
    /// The size of the steps from `tau` to `stop`, close to `near`.
    fn step(&mut self, tau: S, stop: S, near: S) -> S {
        match self.plan {
            Some((_, known, step)) if known == stop => step,
            _ => {
                let count = (((stop - tau) / near).approx() - 1e-6).ceil().max(1.0);
                let step = (stop - tau) / S::lift(count);
                (self.plan, self.all, self.done) = (Some((tau, stop, step)), count as u64, 0);
                step
            }
        }
    }

    /// Whether the next step is the last of the equal steps.
    fn lands(&self) -> bool {
        self.plan.is_some() && self.done + 1 >= self.all
    }

    /// The end of the step just made, if it belongs to equal steps.
    fn next(&mut self) -> Option<S> {
        self.done += 1;
        self.plan.map(|(from, _, step)| from + S::lift(self.done as f64) * step)
    }
}

/// The proposed step, or the remaining interval, or half of it where a very short last step would remain.
fn shorten<S: Real>(proposed: f64, remaining: S) -> S {
    let left = remaining.approx();
    if proposed >= left * (1.0 - 1e-10) {
        remaining
    } else if proposed > 0.5 * left {
        remaining.half()
    } else {
        S::lift(proposed)
    }
}

/// A state smaller than this many tolerances, such as at a start from zero, is not used to scale the first step: it is
/// small compared with its rate.
const SMALL: f64 = 10.0;

/// The first step size for a method of order p, from the rates and their change over a trial Euler step in units of the
/// tolerance (Gladwell, Shampine and Brankin 1987; Hairer, Norsett and Wanner, II.4). Within an accepted step, the
/// whole length.
pub(crate) fn first_step<S: Real>(
    meter: &BudgetedRhs<S>,
    y: &[S],
    tolerance: &Tolerance,
    order: u32,
    length: f64,
) -> f64 {
    if meter.within_step {
        return length;
    }
    let n = y.len();
    let (mut f0, mut f1, mut y1) = (vec![S::zero(); n], vec![S::zero(); n], vec![S::zero(); n]);
    meter.rates(S::zero(), y, &mut f0);
    let size = |v: &[S]| tolerance.norm(y, y, |i| v[i].approx());
    let (d0, d1) = (size(y), size(&f0));
    let guess = if d0 < SMALL || d1 < 1e-5 { 1e-6 * length } else { 0.01 * d0 / d1 };
    let h0 = guess.min(length);
    for i in 0..n {
        y1[i] = y[i] + S::lift(h0) * f0[i];
    }
    meter.rates(S::lift(h0), &y1, &mut f1);
    let d2 = tolerance.norm(y, y, |i| (f1[i] - f0[i]).approx()) / h0;
    let steepest = d1.max(d2);
    let h1 = if steepest <= 1e-15 { h0 * 1e-3 } else { (0.01 / steepest).powf(1.0 / f64::from(order + 1)) };
    let first = h1.min(100.0 * h0).min(length);
    let first = if first.is_finite() && first > 0.0 { first } else { h0 * 1e-3 };
    meter.longest_first.map_or(first, |longest| first.min(longest))
}
