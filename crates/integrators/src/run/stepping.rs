//! The loop around the steps of this crate's methods.

use crate::run::brink::Brink;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::watch::Watch;
use crate::{Failure, Outcome, Real, Tolerance};

/// The outcome of an attempted step, and the length of the next one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Attempt {
    Accepted {
        next: f64,
    },
    Rejected {
        next: f64,
        cause: Cause,
    },
    /// Accepted, and stability limits the steps of the method, not accuracy: the problem is stiff.
    Limited {
        next: f64,
    },
}

/// The number of remaining steps up to which an explicit method follows a stiff problem to its end: they cost the user less than another
/// method.
const FEW: f64 = 5_000.0;

/// An interval of so many roundings of the time is not divided.
const AT_ONCE: f64 = 16.0;

/// Why a step was rejected: if no shorter one succeeds, why the run failed.
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
    /// Tries one step from `before` at tau; a step that is accepted has its result in `after`.
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt;

    /// The longest next step, where the method has it before the step.
    fn reach(&mut self, _tau: S, _before: &[S], _meter: &BudgetedRhs<S>) -> Option<f64> {
        None
    }

    /// The constant step of a method without error control.
    fn fixed(&self) -> Option<S> {
        None
    }

    /// Whether [`Stepper::between`] is as accurate as the steps: then these need not land on the outputs.
    fn reads_between(&self) -> bool {
        false
    }

    /// The state at `passed` after the beginning of the last accepted step.
    fn between(&self, _passed: S, _state: &mut [S]) {}
}

/// Runs a method to the end of the span, or to its failure.
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
    // the longest step from here that may end in finite values, for a series of any radius
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

/// Equal steps to the next time at which a step must end: their length does not change on the way, and the time is not
/// computed as their sum, whose rounding would grow with their number.
struct Even<S> {
    plan: Option<(S, S, S)>,
    all: u64,
    done: u64,
}

impl<S: Real> Even<S> {
    /// The length of the steps from `tau` to `stop`, near a given one.
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

    /// Whether the coming step is the last of them.
    fn lands(&self) -> bool {
        self.plan.is_some() && self.done + 1 >= self.all
    }

    /// The end of the step just made, if it is one of them.
    fn next(&mut self) -> Option<S> {
        self.done += 1;
        self.plan.map(|(from, _, step)| from + S::lift(self.done as f64) * step)
    }
}

/// The proposed step, or the rest, or half of the rest where a sliver would remain.
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

/// A state below so many times its tolerance, as where a run begins anew at a zero, is small beside its rate: their quotient
/// gives no step size.
const SMALL: f64 = 10.0;

/// A first step size for a method of order p (Gladwell, Shampine and Brankin 1987; Hairer, Norsett and Wanner, II.4),
/// from the rates and their change over a trial Euler step, in units of the tolerance. Within an accepted step, the
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
