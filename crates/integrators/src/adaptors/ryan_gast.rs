//! Verner's pairs, Radau5 and Kvaerno's pair from Ryan Gast's crate `differential-equations`, taken step by step.
//!
//! Its dense output is good to 1e-6 only, so the steps land on the outputs. A step that must be cut for it is the first
//! of a new run: the crate's Radau5 goes on with the factors of the uncut step, and takes too few iterations with them. Tolerances are given by component: with a scalar its Radau5 transforms the one number once for
//! every component. The crate's Radau5 needs arrays of static size, so a state is padded with components at rest to the
//! next size; its Jacobian is ours.

use std::cell::RefCell;

use differential_equations::error::Error;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{DiagonallyImplicitRungeKutta, ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::stats::Evals;
use differential_equations::status::Status;

use crate::drive::first_step;
use crate::jacobian::Jacobian;
use crate::meter::Meter;
use crate::watch::Watch;
use crate::{Failure, Outcome, Refusal, System, Tolerance};

/// Which of the crate's methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Choice {
    Verner6,
    Verner9,
    Radau5,
    Kvaerno5,
}

/// The largest state that is padded.
const MOST: usize = 64;

/// Rejections in a row after which no shorter step is tried.
const MOST_REJECTIONS: u32 = 60;

/// Runs one method to the end of the span, or to its failure.
pub(crate) fn run(
    choice: Choice,
    system: &dyn System,
    tolerance: &Tolerance,
    meter: &Meter<f64>,
    watch: Watch<'_, '_, f64>,
) -> Outcome<f64> {
    macro_rules! dispatch {
        ($($n:literal)*) => {
            match meter.dimension() {
                $(0..=$n => in_size::<$n>(choice, system, tolerance, meter, watch),)*
                dimension => watch.fail(Failure::Refused(Refusal::TooLarge { dimension, most: MOST }), meter),
            }
        };
    }
    // every size is compiled by itself, for four methods
    dispatch!(2 4 8 10 16 32 64)
}

/// The law in the crate's form, padded to N components.
struct Law<'l, const N: usize> {
    meter: &'l Meter<'l, f64>,
    jacobian: RefCell<(Jacobian<'l>, Vec<f64>)>,
}

impl<const N: usize> ODE<f64, [f64; N]> for Law<'_, N> {
    fn diff(&self, tau: f64, y: &[f64; N], dy: &mut [f64; N]) {
        let n = self.meter.dimension();
        self.meter.rates(tau, &y[..n], &mut dy[..n]);
        dy[n..].fill(0.0);
    }

    fn jacobian(&self, tau: f64, y: &[f64; N], matrix: &mut Matrix<f64>) {
        let n = self.meter.dimension();
        let (jacobian, buffer) = &mut *self.jacobian.borrow_mut();
        jacobian.matrix(self.meter.time(tau), &y[..n], buffer);
        self.meter.count_jacobian();
        for i in 0..N {
            for j in 0..N {
                matrix[(i, j)] = if i < n && j < n { self.meter.direction * buffer[i * n + j] } else { 0.0 };
            }
        }
    }
}

fn in_size<const N: usize>(
    choice: Choice,
    system: &dyn System,
    tolerance: &Tolerance,
    meter: &Meter<f64>,
    mut watch: Watch<'_, '_, f64>,
) -> Outcome<f64> {
    let n = meter.dimension();
    let law = Law::<N> { meter, jacobian: RefCell::new((Jacobian::of(system), vec![0.0; n * n])) };
    let relative = [tolerance.relative; N];
    let absolute: [f64; N] = std::array::from_fn(|i| if i < n { tolerance.absolute(i) } else { 1.0 });
    let finest = absolute.iter().copied().fold(1.0, f64::min);
    let order = if choice == Choice::Verner9 { 9 } else { 5 };
    let mut step = first_step(meter, watch.state(), tolerance, order, watch.length());
    while watch.goes_on() {
        let first = step.min(watch.stop() - watch.tau());
        if first <= f64::EPSILON * watch.tau().max(f64::EPSILON * watch.length()) {
            let at = watch.time();
            return watch.fail(Failure::LeftTheNumbers { at }, meter);
        }
        let result = match choice {
            Choice::Verner6 => {
                let method = ExplicitRungeKutta::rkv655e().h0(first).max_steps(usize::MAX).max_rejects(usize::MAX);
                stretch(method.rtol(relative).atol(absolute), &law, &mut watch)
            }
            Choice::Verner9 => {
                let method = ExplicitRungeKutta::rkv988e().h0(first).max_steps(usize::MAX).max_rejects(usize::MAX);
                stretch(method.rtol(relative).atol(absolute), &law, &mut watch)
            }
            Choice::Radau5 => {
                let method = ImplicitRungeKutta::radau5().h0(first).max_steps(usize::MAX).max_rejects(usize::MAX);
                let method = method.newton_tol(radau5_newton(tolerance.relative));
                stretch(method.rtol(relative).atol(absolute), &law, &mut watch)
            }
            Choice::Kvaerno5 => {
                let method =
                    DiagonallyImplicitRungeKutta::kvaerno745().h0(first).max_steps(usize::MAX).max_rejects(usize::MAX);
                let method = method.newton_tol(0.1 * finest);
                stretch(method.rtol(relative).atol(absolute), &law, &mut watch)
            }
        };
        match result {
            Ok(next) if first < step && next.clean => step = step.max(next.step),
            Ok(next) => step = next.step,
            Err(failure) => return watch.fail(failure, meter),
        }
    }
    let end = watch.end();
    watch.finish(end, meter)
}

/// What Newton may leave in units of Radau5's inner tolerance, 0.1 relative^(2/3): Hairer's rule, which the crate replaces
/// by a constant.
fn radau5_newton(relative: f64) -> f64 {
    let inner = 0.1 * relative.powf(2.0 / 3.0);
    inner.sqrt().min(0.03).max(10.0 * f64::EPSILON / inner)
}

/// How to go on after some steps.
struct Next {
    step: f64,
    /// No step was rejected.
    clean: bool,
}

/// Steps up to an output, to where a step must be cut to land on one, or to a step that left the numbers.
fn stretch<const N: usize, M: OrdinaryNumericalMethod<f64, [f64; N]>>(
    mut method: M,
    law: &Law<'_, N>,
    watch: &mut Watch<'_, '_, f64>,
) -> Result<Next, Failure> {
    let (meter, n, stop) = (law.meter, law.meter.dimension(), watch.stop());
    let mut y = [0.0; N];
    y[..n].copy_from_slice(watch.state());
    let started = method.init(law, watch.tau(), stop, &y);
    started.map_err(|error| name(&error, meter, watch.time(), method.h()))?;
    method.set_status(Status::Solving);
    let (mut rejections, mut clean, mut fresh) = (0, true, true);
    while watch.tau() < stop && watch.goes_on() {
        let (at, remaining, step) = (watch.time(), stop - watch.tau(), method.h());
        let lands = step >= remaining * (1.0 - 1e-10);
        if lands && !fresh {
            return Ok(Next { step, clean });
        }
        let collapsed = !lands && step <= 4.0 * f64::EPSILON * at.abs().max(watch.tau());
        let stuck = rejections > MOST_REJECTIONS || collapsed || !step.is_finite();
        if stuck && meter.was_undefined() {
            return Err(Failure::LeftTheNumbers { at });
        } else if stuck {
            return Err(Failure::StepCollapsed { at, step });
        }
        let result: Result<Evals, _> = method.step(law);
        fresh = false;
        if let Some(failure) = meter.exhausted(at) {
            return Err(failure);
        }
        let work = result.map_err(|error| name(&error, meter, at, step))?;
        for _ in 0..work.decompositions.max(work.solves.min(work.jacobian)) {
            meter.count_factorisation();
        }
        if matches!(method.status(), Status::RejectedStep) {
            watch.reject();
            (rejections, clean) = (rejections + 1, false);
            continue;
        }
        // the crate's explicit pairs take an undefined error for none: back to the last good state
        if !method.y().iter().all(|y| y.is_finite()) {
            watch.reject();
            return Ok(Next { step: 0.25 * step, clean: false });
        }
        meter.was_undefined();
        rejections = 0;
        watch.accept(if lands { stop } else { method.t() }, &method.y()[..n]);
    }
    Ok(Next { step: method.h(), clean })
}

/// The crate's errors by our names.
fn name<const N: usize>(error: &Error<f64, [f64; N]>, meter: &Meter<f64>, at: f64, step: f64) -> Failure {
    match error {
        _ if meter.was_undefined() => Failure::LeftTheNumbers { at },
        Error::LinearAlgebra { .. } => Failure::Singular { at },
        _ => Failure::StepCollapsed { at, step },
    }
}
