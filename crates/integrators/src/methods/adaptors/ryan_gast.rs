//! Verner's pairs, Radau5 and Kvaerno's pair from Ryan Gast's crate `differential-equations`, called step by step.
//!
//! Tolerances are passed by component: with a scalar tolerance the crate's Radau5 transforms the scalar repeatedly. The
//! Jacobian is computed by this crate.
//!
//! A fault of the crate's Radau5: after it has reused its factorisations for a step of equal length, it reuses them for
//! steps of other lengths too. Newton's iteration then converges slowly and at tight tolerances not within its limit.
//! After a step that reused the factorisations, and before the last step, which is shortened to end at the span's end,
//! a new run is therefore begun unless the step length is unchanged.
//!
//! Newton's iteration ends at a size of its corrections that may be below rounding. If steps are rejected repeatedly,
//! that size is enlarged [tenfold](LOOSER), up to the tolerance of a step.
//!
//! The crate's methods own their state and give only read access. Where states are projected onto invariants, the
//! method continues from its own state z, and the law is evaluated at the [shifted](Shift) state: z' = f(t, z + c),
//! where c is the sum of all projections so far.

use std::cell::RefCell;

use differential_equations::error::Error;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{DiagonallyImplicitRungeKutta, ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::stats::Evals;
use differential_equations::status::Status;

use super::components::{Components, Vector};
use crate::law::jacobian::Jacobian;
use crate::run::brink::Brink;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::first_step;
use crate::run::watch::Watch;
use crate::{Failure, Outcome, System, Tolerance};

/// The methods of the crate that are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Choice {
    Verner6,
    Verner9,
    Radau5,
    Kvaerno5,
}

/// States with at most this number of components are padded to arrays, which makes the explicit pairs twice as fast as
/// a state on the heap. The implicit methods are not padded: their matrices would become larger.
const SMALL: usize = 8;
const SMALLEST: usize = 4;

/// The run ends after this many rejections in a row.
const MOST_REJECTIONS: u32 = 60;

/// After this many rejections in a row Newton's iteration counts as limited by rounding.
const STALLED: u32 = 12;

/// The number of attempts in a window, and the fraction of rejected ones among them from which Newton's iteration also
/// counts as limited by rounding.
const WINDOW: u32 = 200;
const MOSTLY: f64 = 0.3;

/// The factor by which the final size of Newton's corrections is enlarged in this case.
const LOOSER: f64 = 10.0;

/// The growth factor of the state after which the final size of the corrections is computed again.
const GROWN: f64 = 2.0;

/// Runs one method to the end of the span, or to its failure.
pub(crate) fn run(
    choice: Choice,
    system: &dyn System,
    tolerance: &Tolerance,
    meter: &BudgetedRhs<f64>,
    watch: Watch<'_, '_, f64>,
) -> Outcome<f64> {
    let is_explicit = matches!(choice, Choice::Verner6 | Choice::Verner9);
    match meter.dimension() {
        ..=SMALLEST if is_explicit => in_form::<[f64; SMALLEST]>(choice, system, tolerance, meter, watch),
        ..=SMALL if is_explicit => in_form::<[f64; SMALL]>(choice, system, tolerance, meter, watch),
        _ => in_form::<Vector>(choice, system, tolerance, meter, watch),
    }
}

/// The law as a type of the crate.
struct Law<'l> {
    meter: &'l BudgetedRhs<'l, f64>,
    jacobian: RefCell<(Jacobian<'l>, Vec<f64>)>,
    /// The shift of the state; `None` where states are not projected.
    shift: Option<RefCell<Shift>>,
}

/// The difference between the state of the law and that of the method.
struct Shift {
    by: Vec<f64>,
    /// The state of the law.
    state: Vec<f64>,
}

impl Shift {
    fn none(n: usize) -> Self {
        Shift { by: vec![0.0; n], state: vec![0.0; n] }
    }

    /// The state of the law for the method's state z.
    fn of(&mut self, z: &[f64]) -> &mut Vec<f64> {
        self.state.iter_mut().zip(z).zip(&self.by).for_each(|((state, z), by)| *state = z + by);
        &mut self.state
    }

    /// Sets the shift from a state of the method and the corresponding state of the law.
    fn between(&mut self, z: &[f64], state: &[f64]) {
        self.by.iter_mut().zip(state).zip(z).for_each(|((by, state), z)| *by = state - z);
    }
}

impl Law<'_> {
    /// Calls `show` with the state of the law for the method's state z.
    fn at<R>(&self, z: &[f64], show: impl FnOnce(&[f64]) -> R) -> R {
        match &self.shift {
            Some(shift) => show(shift.borrow_mut().of(z)),
            None => show(z),
        }
    }

    /// Reports the state of the method after an accepted step.
    fn accept(&self, watch: &mut Watch<'_, '_, f64>, tau: f64, z: &[f64]) {
        let Some(shift) = &self.shift else { return watch.accept(tau, z) };
        let mut shift = shift.borrow_mut();
        if watch.take(tau, shift.of(z)) {
            shift.between(z, watch.state());
        }
    }
}

impl<Y: Components> ODE<f64, Y> for Law<'_> {
    fn diff(&self, tau: f64, y: &Y, dy: &mut Y) {
        let (rates, at_rest) = dy.values_mut().split_at_mut(self.meter.dimension());
        self.at(&y.values()[..rates.len()], |y| self.meter.rates(tau, y, rates));
        at_rest.fill(0.0);
    }

    fn jacobian(&self, tau: f64, y: &Y, matrix: &mut Matrix<f64>) {
        let n = self.meter.dimension();
        let (jacobian, buffer) = &mut *self.jacobian.borrow_mut();
        self.at(&y.values()[..n], |y| jacobian.matrix(self.meter.time(tau), y, buffer));
        self.meter.count_jacobian();
        for (i, row) in buffer.chunks_exact(n).enumerate() {
            for (j, slope) in row.iter().enumerate() {
                matrix[(i, j)] = self.meter.direction * slope;
            }
        }
    }
}

fn in_form<Y: Components>(
    choice: Choice,
    system: &dyn System,
    tolerance: &Tolerance,
    meter: &BudgetedRhs<f64>,
    mut watch: Watch<'_, '_, f64>,
) -> Outcome<f64> {
    let n = meter.dimension();
    let jacobian = RefCell::new((Jacobian::of(system), vec![0.0; n * n]));
    let law = Law { meter, jacobian, shift: watch.projects().then(|| RefCell::new(Shift::none(n))) };
    Vector::set_length(n);
    let padded = Y::of(watch.state()).len();
    let relative = vec![tolerance.relative; padded];
    let absolute: Vec<f64> = (0..padded).map(|i| if i < n { tolerance.absolute(i) } else { 1.0 }).collect();
    let order = if choice == Choice::Verner9 { 9 } else { 5 };
    let mut step = first_step(meter, watch.state(), tolerance, order, watch.length());
    let (mut looser, mut brink) = (1.0, Brink::default());
    while watch.goes_on() {
        let first = meter.longest(watch.tau(), step).min(watch.landing() - watch.tau());
        if first <= f64::EPSILON * watch.tau().max(f64::EPSILON * watch.length()) {
            let at = watch.time();
            return watch.fail(Failure::LeftTheNumbers { at }, meter);
        }
        let left = Left::by_newton(choice, tolerance, watch.state(), looser);
        let (relative, absolute) = (relative.clone(), absolute.clone());
        let result = match choice {
            Choice::Verner6 => {
                let method = ExplicitRungeKutta::rkv655e().h0(first).max_steps(usize::MAX).max_rejects(usize::MAX);
                stretch::<Y, _>(method.rtol(relative).atol(absolute), &law, left, (&mut watch, &mut brink))
            }
            Choice::Verner9 => {
                let method = ExplicitRungeKutta::rkv988e().h0(first).max_steps(usize::MAX).max_rejects(usize::MAX);
                stretch::<Y, _>(method.rtol(relative).atol(absolute), &law, left, (&mut watch, &mut brink))
            }
            Choice::Radau5 => {
                let method = ImplicitRungeKutta::radau5().h0(first).max_steps(usize::MAX).max_rejects(usize::MAX);
                let method = method.newton_tol(left.size);
                stretch::<Y, _>(method.rtol(relative).atol(absolute), &law, left, (&mut watch, &mut brink))
            }
            Choice::Kvaerno5 => {
                let method =
                    DiagonallyImplicitRungeKutta::kvaerno745().h0(first).max_steps(usize::MAX).max_rejects(usize::MAX);
                let method = method.newton_tol(left.size);
                stretch::<Y, _>(method.rtol(relative).atol(absolute), &law, left, (&mut watch, &mut brink))
            }
        };
        match result {
            Ok(next) => {
                step = if first < step && next.clean { step.max(next.step) } else { next.step };
                looser *= if next.stalled { LOOSER } else { 1.0 };
            }
            Err(failure) => return watch.fail(failure, meter),
        }
    }
    let end = watch.end();
    watch.finish(end, meter)
}

/// The final size of the corrections of Newton's iteration.
#[derive(Clone, Copy)]
struct Left {
    choice: Choice,
    /// The final size, in the units of the crate.
    size: f64,
    /// Whether the tolerance allows a larger size.
    may_grow: bool,
    /// The magnitude of the state for which the size was computed, where it depends on the state.
    scale: Option<f64>,
}

impl Left {
    /// For Radau5: in units of its inner tolerance, 0.1 relative^(2/3) (Hairer's rule, which the crate replaces by a
    /// constant). For Kvaerno's pair: the largest component, a tenth of the smallest absolute tolerance or ten
    /// roundings of the state.
    fn by_newton(choice: Choice, tolerance: &Tolerance, state: &[f64], looser: f64) -> Self {
        let scale = state.iter().fold(0.0_f64, |scale, y| scale.max(y.abs()));
        let (least, most) = match choice {
            Choice::Verner6 | Choice::Verner9 => (0.0, 0.0),
            Choice::Radau5 => {
                let inner = 0.1 * tolerance.relative.powf(2.0 / 3.0);
                let least = inner.sqrt().min(0.03).max(10.0 * f64::EPSILON / inner);
                (least, least.max(tolerance.relative / inner))
            }
            Choice::Kvaerno5 => {
                let finest = (0..state.len()).map(|i| tolerance.absolute(i)).fold(1.0, f64::min);
                let least = (0.1 * finest).max(10.0 * f64::EPSILON * scale);
                (least, least.max(finest + tolerance.relative * scale))
            }
        };
        let size = (looser * least).min(most);
        let scale = (choice == Choice::Kvaerno5).then_some(scale);
        Left { choice, size, may_grow: size < most, scale }
    }

    /// Whether the state has grown too large for the size.
    fn outgrown(&self, state: &[f64]) -> bool {
        self.scale.is_some_and(|scale| state.iter().any(|y| y.abs() > GROWN * scale.max(1.0)))
    }
}

/// The result of a sequence of steps.
struct Next {
    step: f64,
    /// Whether no step was rejected.
    clean: bool,
    /// Whether Newton's iteration is limited by rounding.
    stalled: bool,
}

/// Makes steps to the end, or until a step must be shortened to end there, a state is not finite, or the method must be
/// started again.
fn stretch<Y: Components, M: OrdinaryNumericalMethod<f64, Y>>(
    mut method: M,
    law: &Law<'_>,
    left: Left,
    (watch, brink): (&mut Watch<'_, '_, f64>, &mut Brink),
) -> Result<Next, Failure> {
    let (meter, n, stop) = (law.meter, law.meter.dimension(), watch.landing());
    // a method is started at the state of the law
    if let Some(shift) = &law.shift {
        shift.borrow_mut().by.fill(0.0);
    }
    let y = Y::of(watch.state());
    let started = method.init(law, watch.tau(), stop, &y);
    started.map_err(|error| name(&error, meter, watch.time(), method.h()))?;
    method.set_status(Status::Solving);
    let (mut rejections, mut clean, mut fresh) = (0, true, true);
    let (mut attempts, mut rejected) = (0, 0);
    while watch.tau() < stop && watch.goes_on() {
        let (at, remaining, step) = (watch.time(), stop - watch.tau(), method.h());
        let lands = step >= remaining * (1.0 - 1e-10);
        let is_too_long = meter.longest(watch.tau(), step) < step;
        if (lands || is_too_long) && !fresh {
            return Ok(Next { step, clean, stalled: false });
        }
        let mostly = attempts >= WINDOW && f64::from(rejected) > MOSTLY * f64::from(attempts);
        if attempts >= WINDOW {
            (attempts, rejected) = (0, 0);
        }
        let stalled = left.may_grow && (rejections >= STALLED || mostly) && step.is_finite();
        let collapsed = !lands && step <= 4.0 * f64::EPSILON * at.abs().max(watch.tau());
        let stuck = rejections > MOST_REJECTIONS || collapsed || !step.is_finite();
        if stuck || stalled {
            match meter.was_undefined() {
                true if stuck => return Err(Failure::LeftTheNumbers { at }),
                false if stalled => return Ok(Next { step, clean: false, stalled }),
                false => return Err(Failure::StepCollapsed { at, step }),
                true => (),
            }
        }
        Vector::set_length(n);
        let result: Result<Evals, _> = method.step(law);
        fresh = false;
        if let Some(failure) = meter.exhausted(at) {
            return Err(failure);
        }
        let work = result.map_err(|error| name(&error, meter, at, step))?;
        for _ in 0..work.decompositions.max(work.solves.min(work.jacobian)) {
            meter.count_factorisation();
        }
        attempts += 1;
        let is_rejected = matches!(method.status(), Status::RejectedStep);
        let is_spoilt = !method.y().values().iter().all(|y| y.is_finite());
        if brink.creeps((is_rejected || is_spoilt) && meter.is_undefined()) {
            return Err(Failure::LeftTheNumbers { at });
        }
        let keeps_factors = left.choice == Choice::Radau5 && work.decompositions == 0;
        let is_stale = |next: f64| keeps_factors && next != step;
        if is_rejected {
            watch.reject();
            (rejections, rejected, clean) = (rejections + 1, rejected + 1, false);
            if is_stale(method.h()) && method.h().is_finite() {
                return Ok(Next { step: method.h(), clean, stalled: false });
            }
            continue;
        }
        // the crate's explicit pairs take an error of NaN for zero: return to the last valid state
        if is_spoilt {
            watch.reject();
            return Ok(Next { step: 0.25 * step, clean: false, stalled: false });
        }
        meter.was_undefined();
        rejections = 0;
        law.accept(watch, if lands { stop } else { method.t() }, &method.y().values()[..n]);
        if is_stale(method.h()) || left.outgrown(&method.y().values()[..n]) {
            break;
        }
    }
    Ok(Next { step: method.h(), clean, stalled: false })
}

/// The failure of this crate that corresponds to an error of `differential-equations`.
fn name<Y: Components>(error: &Error<f64, Y>, meter: &BudgetedRhs<f64>, at: f64, step: f64) -> Failure {
    match error {
        _ if meter.was_undefined() => Failure::LeftTheNumbers { at },
        Error::LinearAlgebra { .. } => Failure::Singular { at },
        _ => Failure::StepCollapsed { at, step },
    }
}
