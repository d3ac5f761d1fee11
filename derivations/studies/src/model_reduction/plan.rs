//! The cheapest method, form and tolerance for a law and an allowed error, by two pilot runs.
//!
//! The first pilot is a run by an explicit method, or by an implicit one if the law is stiff at the start or the
//! explicit run does not reach its end. The explicit method is Taylor's if the law has Taylor series, since it takes
//! the fewest evaluations on smooth nonstiff problems; otherwise a Runge-Kutta method. The second pilot has the
//! tolerance that usually suffices. The error of the coarser pilot is its distance from the finer one. Errors are
//! assumed to be proportional to a power of the tolerance below one, which gives the tolerance for the run; often that
//! of a pilot suffices. All of these are estimates.

use super::outputs::Watched;
use super::run_rows::{Along, Run, Serves};
use super::sampled_run::looks;
use integrators::{Jacobian, Method, Span, Tolerance, integrate, spectrum};
use nalgebra::Complex;
use simulation::{Axes, Law};
use std::sync::Arc;

/// The explicit methods; the second is used if the first rejects the law.
const EXPLICIT: [Method; 2] = [Method::Taylor, Method::DormandPrince8];
const IMPLICIT: Method = Method::RadauIIA { stages: 5 };
/// The tolerance of the first pilot.
pub(super) const COARSE: f64 = 1e-4;
/// The loosest tolerance of the second pilot.
const FINE: f64 = 1e-5;
/// The tolerance that usually suffices for an error, as a fraction of it.
const USUAL: f64 = 0.1;
/// The budgets of a first pilot, in evaluations: both kinds of methods are tried with the first budget, then with the
/// second. The first round costs little compared with a run beyond it.
const ROUNDS: [u64; 2] = [20_000, 500_000];
/// The last budget.
pub(super) const LAST: u64 = ROUNDS[1];
/// The number of evaluations that an explicit method needs at least for each time constant of the fastest transient.
const STABLE: f64 = 2.0;
/// The typical number of evaluations of an implicit method, for a run of any stiffness.
const STIFF: f64 = 1_000.0;
/// A law is slower than another if its fastest rate is at most this fraction of the other's.
pub(super) const SLOWER: f64 = 0.3;
/// The error at a tolerance is assumed to be at most this factor times that at a coarser one times this power of their
/// ratio.
const SAFETY: f64 = 3.0;
const POWER: f64 = 0.75;
/// A run can measure the error of another if its tolerance is at most this fraction of the other's.
const APART: f64 = 0.1;
/// The factor by which an error may be larger between the times of comparison: for an explicit method, and for an
/// implicit one, whose values between steps are of lower order.
const BETWEEN: [f64; 2] = [2.0, 5.0];
/// A tolerance between those of the pilots is worth another run if it saves more than this fraction.
const SAVED: f64 = 0.2;
/// The finest tolerance in double precision.
pub(super) const FINEST: f64 = 1e-13;
/// The budget of the second pilot, relative to the evaluations of the first.
const PATIENCE: u64 = 20;

/// A model in a form, as rows of the scene's own outputs.
pub struct Runnable<'a> {
    pub axes: Axes,
    /// The end of the runs, s; they start at time zero.
    pub span: f64,
    go: Box<Go<'a>>,
    /// An earlier run, with its method and tolerance.
    known: Option<(Method, f64, Run)>,
}

/// A run by a method, tolerance and budget of evaluations, with rows at its steps and at these times, the last of which
/// is its end, stopped when it becomes unacceptable; and the number of its evaluations. `None` where it does not reach
/// its end.
pub type Go<'a> = dyn Fn(Method, f64, u64, &[f64], &Serves<'_>) -> (Option<Run>, u64) + 'a;

/// A method with its form and tolerance, and the predicted error and cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    pub axes: Axes,
    pub method: Method,
    pub tolerance: f64,
    /// The predicted error of the method.
    pub error: f64,
    /// The predicted number of evaluations.
    pub foretold: f64,
    /// Evaluations of the pilots.
    pub spent: u64,
    /// The pilots, the coarser one first.
    pub pilots: [Pilot; 2],
    /// The distance of the pilots, which estimates the error of the coarser one.
    pub apart: f64,
}

/// A run from which the error and cost of others are predicted.
#[derive(Clone, Debug, PartialEq)]
pub struct Pilot {
    pub tolerance: f64,
    pub run: Run,
}

impl Plan {
    /// The pilot run with this tolerance, if there is one.
    pub fn known(&self, tolerance: f64) -> Option<&Run> {
        let same = |pilot: &&Pilot| (tolerance / pilot.tolerance - 1.0).abs() < 1e-9;
        self.pilots.iter().find(same).map(|pilot| &pilot.run)
    }

    /// The predicted error at a tolerance no finer than that of the finer pilot.
    pub fn error_at(&self, tolerance: f64) -> f64 {
        error_at(self.apart, tolerance / self.pilots[0].tolerance)
    }
}

/// The largest error of a whole run divided by that at the times of comparison.
pub(super) fn between(method: Method) -> f64 {
    BETWEEN[usize::from(method.traits().implicit)]
}

/// The predicted error at a fraction of a tolerance whose error is known.
pub(super) fn error_at(known: f64, share: f64) -> f64 {
    if share < 1.0 { (SAFETY * known * share.powf(POWER)).min(known) } else { known }
}

impl<'a> Runnable<'a> {
    /// A model by a function that runs it.
    pub fn new(
        axes: Axes,
        span: f64,
        go: impl Fn(Method, f64, u64, &[f64], &Serves<'_>) -> (Option<Run>, u64) + 'a,
    ) -> Self {
        Runnable { axes, span, go: Box::new(go), known: None }
    }

    /// A model by its law, initial state and span, with the map from states to rows and a test of states outside the
    /// law.
    pub fn of_law(
        axes: Axes,
        law: Arc<dyn Law>,
        start: Vec<f64>,
        span: f64,
        row: impl Fn(f64, &[f64]) -> Vec<f64> + 'a,
        outside: impl Fn(f64, &[f64]) -> bool + 'a,
    ) -> Self {
        Self::new(axes, span, move |method, tolerance, most, times, serves| {
            let span = Span::new(0.0, span, &start).with_outputs(times).with_evaluations(most);
            let mut along = Along::within(&row, &outside, serves);
            let outcome = integrate(&*law, method, &Tolerance::both(tolerance), &span, &mut along);
            let evaluations = outcome.work.rates + outcome.work.jacobians * start.len() as u64;
            ((outcome.reached() && !along.left()).then(|| along.run(evaluations)), evaluations)
        })
    }

    /// Adds an earlier run, which then costs nothing.
    pub fn knows(&mut self, method: Method, tolerance: f64, run: Run) {
        self.known = Some((method, tolerance, run));
    }

    /// A run with rows at its steps and at these times or, without times, at equidistant times.
    pub fn run(&self, method: Method, tolerance: f64, most: u64, times: Option<&[f64]>) -> (Option<Run>, u64) {
        if let (Some((by, at, run)), None) = (&self.known, times)
            && (*by, *at) == (method, tolerance)
        {
            return (Some(run.clone()), 0);
        }
        // between steps a method with few steps may have larger errors than at them
        let looks = || looks(self.span).collect::<Vec<_>>();
        let times = times.map_or_else(looks, <[f64]>::to_vec);
        (self.go)(method, tolerance, most, &times, &|_, _| true)
    }

    /// A run with rows at these times, stopped when it becomes unacceptable.
    pub fn run_while(
        &self,
        (method, tolerance, most): (Method, f64, u64),
        times: &[f64],
        serves: &Serves<'_>,
    ) -> (Option<Run>, u64) {
        (self.go)(method, tolerance, most, times, serves)
    }

    /// The first pilot that reaches the end, within a budget of evaluations if one is given.
    fn first(&self, is_stiff: bool, at_most: Option<u64>, spent: &mut u64) -> Option<(Method, Run)> {
        if let Some((method, tolerance, run)) = &self.known
            && *tolerance == COARSE
        {
            return Some((*method, run.clone()));
        }
        let mut coarse = |method, most| {
            let (run, evaluations) = self.run(method, COARSE, most, None);
            *spent += evaluations;
            (run, evaluations)
        };
        match at_most {
            Some(most) => by_kind(is_stiff, |method| coarse(method, most)),
            None => first_of(is_stiff, coarse),
        }
    }

    /// The plan for an allowed error by one method; `None` where the second pilot does not reach its end.
    fn plan(&self, method: Method, coarse: Run, watched: &Watched, error: f64, spent: &mut u64) -> Option<Plan> {
        let times = coarse.times();
        let finer = two_digits((USUAL * error).clamp(FINEST, FINE)).max(FINEST);
        let (fine, evaluations) = self.run(method, finer, PATIENCE * coarse.evaluations.max(1), Some(&times));
        *spent += evaluations;
        let fine = fine?;
        let apart = between(method) * coarse.apart(&fine, watched)?.max(1e-16);
        let slope = (fine.evaluations as f64 / coarse.evaluations as f64).ln() / (COARSE / finer).ln();
        let foretold = |tolerance: f64| coarse.evaluations as f64 * (COARSE / tolerance).powf(slope.max(0.0));
        let served = COARSE * (error / (SAFETY * apart)).powf(1.0 / POWER);
        let tolerance = match served {
            _ if apart <= error => COARSE,
            served if served >= finer => {
                let between = two_digits(served).max(FINEST);
                if foretold(between) < (1.0 - SAVED) * fine.evaluations as f64 { between } else { finer }
            }
            // a run with nearly the tolerance of the finer pilot would have correlated errors
            served => two_digits(served.min(APART * finer).max(FINEST)).max(FINEST),
        };
        let foretold = foretold(tolerance);
        let error = error_at(apart, tolerance / COARSE).max(1e-15);
        let pilots = [Pilot { tolerance: COARSE, run: coarse }, Pilot { tolerance: finer, run: fine }];
        Some(Plan { axes: self.axes, method, tolerance, error, foretold, spent: 0, pilots, apart })
    }
}

/// The first of these runs that reaches its end, with its method.
pub(super) fn first_of<T>(is_stiff: bool, mut run: impl FnMut(Method, u64) -> (Option<T>, u64)) -> Option<(Method, T)> {
    let rounds = ROUNDS.into_iter().flat_map(|most| [(is_stiff, most), (!is_stiff, most)]);
    for (implicit, most) in rounds {
        let found = by_kind(implicit, |method| run(method, most));
        if found.is_some() {
            return found;
        }
    }
    None
}

/// A run by an explicit method or by the implicit one, with its method.
pub(super) fn by_kind<T>(implicit: bool, mut run: impl FnMut(Method) -> (Option<T>, u64)) -> Option<(Method, T)> {
    let methods: &[Method] = if implicit { &[IMPLICIT] } else { &EXPLICIT };
    for &method in methods {
        let (found, evaluations) = run(method);
        if let Some(found) = found {
            return Some((method, found));
        }
        // another method follows only one that rejects the law
        if evaluations > 0 {
            break;
        }
    }
    None
}

/// Whether an implicit method is tried first: initial transients decay so rapidly that explicit steps would be short.
pub(super) fn is_stiff_at(law: &dyn Law, start: &[f64], span: f64) -> bool {
    let fastest = eigenvalues_at(law, start).iter().map(|value| -value.re).fold(0.0, f64::max);
    STABLE * fastest * span > STIFF
}

/// The largest modulus of an eigenvalue at the start, 1/s.
pub(super) fn fastest_at(law: &dyn Law, start: &[f64]) -> f64 {
    eigenvalues_at(law, start).iter().map(|value| value.norm()).fold(0.0, f64::max)
}

/// The eigenvalues of a law's Jacobian at the start; empty where they are not found.
fn eigenvalues_at(law: &dyn Law, start: &[f64]) -> Vec<Complex<f64>> {
    let n = start.len();
    let mut rows = vec![0.0; n * n];
    Jacobian::of(law).matrix(0.0, start, &mut rows);
    spectrum(n, &rows).unwrap_or_default()
}

/// The plan for an allowed error in the form whose first pilot is the cheapest; `spent` counts the pilots of all forms.
pub fn plan(forms: &[Runnable<'_>], watched: &Watched, error: f64) -> Option<Plan> {
    let mut spent = 0;
    let mut is_stiff = watched.stiff;
    let mut coarse: Vec<(&Runnable<'_>, Method, Run)> = Vec::new();
    for form in forms {
        // a form that takes more than the best one so far is not run to its end
        let most = coarse.iter().map(|(.., run)| run.evaluations).min();
        let Some((method, run)) = form.first(is_stiff, most, &mut spent) else { continue };
        // the kind of method that is best in one form is best in the others
        is_stiff = method.traits().implicit;
        coarse.push((form, method, run));
    }
    coarse.sort_by_key(|(.., run)| run.evaluations);
    let found = coarse.into_iter().find_map(|(form, method, run)| form.plan(method, run, watched, error, &mut spent));
    // an implicit method passes over a fast oscillation at the coarse tolerance, and resolves it at a finer one
    let found = found.or_else(|| {
        forms.iter().find_map(|form| {
            let (method, run) = by_kind(!is_stiff, |method| {
                let (run, evaluations) = form.run(method, COARSE, LAST, None);
                spent += evaluations;
                (run, evaluations)
            })?;
            form.plan(method, run, watched, error, &mut spent)
        })
    });
    found.map(|plan| Plan { spent, ..plan })
}

/// A positive number rounded down to two digits, so that the printed tolerance is that of the run.
fn two_digits(value: f64) -> f64 {
    let power = value.log10().floor();
    let digits = (value / 10_f64.powf(power) * 10.0 * (1.0 + 1e-9)).floor();
    format!("{digits}e{}", power - 1.0).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::two_digits;

    #[test]
    fn a_tolerance_has_two_digits_and_is_not_raised() {
        for (given, found) in [(1e-4, 1e-4), (3.199e-5, 3.1e-5), (9.99e-13, 9.9e-13), (1e-13, 1e-13)] {
            assert_eq!(two_digits(given), found, "{given:e}");
        }
    }
}
