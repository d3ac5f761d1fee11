//! The cheapest method and form for a law at an error, by two pilot runs of those that may be.
//!
//! The first pilot is a run by an explicit method; by an implicit one first where the law is stiff at the start, or where the
//! explicit one does not reach its end. The explicit method is Taylor's where the law has series: it takes the fewest evaluations on
//! smooth problems that are not stiff; else it is a Runge-Kutta method. The second pilot has the tolerance that usually serves. The
//! error of the coarser pilot is its distance from the finer one; errors are taken to go with a power of the tolerance below one.
//! So the tolerance for an error is told before the run, and often a pilot has been it. These are estimates.

use super::outputs::Watched;
use super::run_rows::{Along, Run, Serves};
use super::sampled_run::looks;
use integrators::{Jacobian, Method, Span, Tolerance, integrate, spectrum};
use nalgebra::Complex;
use simulation::{Axes, Law};
use std::sync::Arc;

/// The explicit methods that are tried, one where those before it have refused the law.
const EXPLICIT: [Method; 2] = [Method::Taylor, Method::DormandPrince8];
const IMPLICIT: Method = Method::RadauIIA { stages: 5 };
/// The tolerance of the first pilot.
pub(super) const COARSE: f64 = 1e-4;
/// The loosest tolerance of the second one.
const FINE: f64 = 1e-5;
/// The tolerance that usually serves for an error, as a share of it.
const USUAL: f64 = 0.1;
/// Evaluations of a first pilot, of the method that is tried first and, after both have failed, once more: what is lost in the
/// first round is little beside what a run beyond it takes.
const ROUNDS: [u64; 2] = [20_000, 500_000];
/// The last of them.
pub(super) const LAST: u64 = ROUNDS[1];
/// Evaluations that an explicit method needs at the least for a transient that fades so many times in the run.
const STABLE: f64 = 2.0;
/// Evaluations of an implicit method for a run of any stiffness.
const STIFF: f64 = 1_000.0;
/// A law is slower where its fastest motion has at most this share of the rate of another one's.
pub(super) const SLOWER: f64 = 0.3;
/// The error at a tolerance is at most so many times that at a coarser one times this power of their ratio.
const SAFETY: f64 = 3.0;
const POWER: f64 = 0.75;
/// A run tells the errors of another one whose tolerance is so many times its own.
const APART: f64 = 0.1;
/// Between the instants at which runs are compared an error may be so many times as large: by an explicit method, and by an
/// implicit one, whose values between steps are of a lower order.
const BETWEEN: [f64; 2] = [2.0, 5.0];
/// A tolerance between those of the pilots is worth a run of its own where it saves more than this share.
const SAVED: f64 = 0.2;
/// The finest tolerance that double precision leaves room for.
pub(super) const FINEST: f64 = 1e-13;
/// Evaluations of a second pilot, over those of the first.
const PATIENCE: u64 = 20;

/// A model in a form, as rows of the scene's own outputs.
pub struct Runnable<'a> {
    pub axes: Axes,
    /// The end of its runs, from time zero.
    pub span: f64,
    go: Box<Go<'a>>,
    /// A run that was made before, by its method and tolerance.
    known: Option<(Method, f64, Run)>,
}

/// A run by a method, at a tolerance, within so many evaluations, with rows at its steps and at these times, the last of which
/// is its end, as long as it serves; and the evaluations that it took. Without rows where it does not reach its end.
pub type Go<'a> = dyn Fn(Method, f64, u64, &[f64], &Serves<'_>) -> (Option<Run>, u64) + 'a;

/// How to run it.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    pub axes: Axes,
    pub method: Method,
    pub tolerance: f64,
    /// The method's own error, foretold.
    pub error: f64,
    /// Evaluations, foretold.
    pub foretold: f64,
    /// Evaluations that the pilots took.
    pub spent: u64,
    /// Its own pilots, the coarser one first.
    pub pilots: [Pilot; 2],
    /// The distance of the pilots: the error of the coarser one.
    pub apart: f64,
}

/// A run that tells what others will need.
#[derive(Clone, Debug, PartialEq)]
pub struct Pilot {
    pub tolerance: f64,
    pub run: Run,
}

impl Plan {
    /// The run at a tolerance, where a pilot was that.
    pub fn known(&self, tolerance: f64) -> Option<&Run> {
        let same = |pilot: &&Pilot| (tolerance / pilot.tolerance - 1.0).abs() < 1e-9;
        self.pilots.iter().find(same).map(|pilot| &pilot.run)
    }

    /// The error at a tolerance that is not finer than that of the finer pilot, by the distance of the pilots.
    pub fn error_at(&self, tolerance: f64) -> f64 {
        error_at(self.apart, tolerance / self.pilots[0].tolerance)
    }
}

/// The largest error of the whole run over that at the instants at which runs are compared.
pub(super) fn between(method: Method) -> f64 {
    BETWEEN[usize::from(method.traits().implicit)]
}

/// The error at a share of a tolerance at which it is known.
pub(super) fn error_at(known: f64, share: f64) -> f64 {
    if share < 1.0 { (SAFETY * known * share.powf(POWER)).min(known) } else { known }
}

impl<'a> Runnable<'a> {
    /// What runs by itself.
    pub fn new(
        axes: Axes,
        span: f64,
        go: impl Fn(Method, f64, u64, &[f64], &Serves<'_>) -> (Option<Run>, u64) + 'a,
    ) -> Self {
        Runnable { axes, span, go: Box::new(go), known: None }
    }

    /// A law from a state over a span, with what is shown of a state and whether it is outside of the law.
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

    /// A run that was made before, and costs nothing now.
    pub fn knows(&mut self, method: Method, tolerance: f64, run: Run) {
        self.known = Some((method, tolerance, run));
    }

    /// A run, with rows at its steps and at these times or, where there are none, at even instants.
    pub fn run(&self, method: Method, tolerance: f64, most: u64, times: Option<&[f64]>) -> (Option<Run>, u64) {
        if let (Some((by, at, run)), None) = (&self.known, times)
            && (*by, *at) == (method, tolerance)
        {
            return (Some(run.clone()), 0);
        }
        // between its steps a method of few steps may be further off than at them
        let looks = || looks(self.span).collect::<Vec<_>>();
        let times = times.map_or_else(looks, <[f64]>::to_vec);
        (self.go)(method, tolerance, most, &times, &|_, _| true)
    }

    /// A run with rows at these times, as long as it serves.
    pub fn run_while(
        &self,
        (method, tolerance, most): (Method, f64, u64),
        times: &[f64],
        serves: &Serves<'_>,
    ) -> (Option<Run>, u64) {
        (self.go)(method, tolerance, most, times, serves)
    }

    /// The first pilot that reaches the end, within so many evaluations where there is such a limit.
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

    /// The plan for an error by one method; none where the second pilot does not reach its end.
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
            // a run of nearly the same tolerance would share the errors of the finer pilot, and not tell them
            served => two_digits(served.min(APART * finer).max(FINEST)).max(FINEST),
        };
        let foretold = foretold(tolerance);
        let error = error_at(apart, tolerance / COARSE).max(1e-15);
        let pilots = [Pilot { tolerance: COARSE, run: coarse }, Pilot { tolerance: finer, run: fine }];
        Some(Plan { axes: self.axes, method, tolerance, error, foretold, spent: 0, pilots, apart })
    }
}

/// The method of the first of these runs that reaches its end.
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

/// A run by an explicit method, or by the implicit one.
pub(super) fn by_kind<T>(implicit: bool, mut run: impl FnMut(Method) -> (Option<T>, u64)) -> Option<(Method, T)> {
    let methods: &[Method] = if implicit { &[IMPLICIT] } else { &EXPLICIT };
    for &method in methods {
        let (found, evaluations) = run(method);
        if let Some(found) = found {
            return Some((method, found));
        }
        // a law without series may be as smooth as any
        if evaluations > 0 {
            break;
        }
    }
    None
}

/// Whether an implicit method is worth trying first: transients at the start fade so fast that explicit steps would be short.
pub(super) fn is_stiff_at(law: &dyn Law, start: &[f64], span: f64) -> bool {
    let fastest = eigenvalues_at(law, start).iter().map(|value| -value.re).fold(0.0, f64::max);
    STABLE * fastest * span > STIFF
}

/// The largest rate of a motion at a start, 1/s: of one that fades, or swings.
pub(super) fn fastest_at(law: &dyn Law, start: &[f64]) -> f64 {
    eigenvalues_at(law, start).iter().map(|value| value.norm()).fold(0.0, f64::max)
}

/// The eigenvalues of a law at a start; none where it has no derivatives there, or they are not found.
fn eigenvalues_at(law: &dyn Law, start: &[f64]) -> Vec<Complex<f64>> {
    let n = start.len();
    let mut rows = vec![0.0; n * n];
    Jacobian::of(law).matrix(0.0, start, &mut rows);
    spectrum(n, &rows).unwrap_or_default()
}

/// The plan for an error in the form whose first pilot is the cheapest; the evaluations of all pilots are among what it has spent.
pub fn plan(forms: &[Runnable<'_>], watched: &Watched, error: f64) -> Option<Plan> {
    let mut spent = 0;
    let mut is_stiff = watched.stiff;
    let mut coarse: Vec<(&Runnable<'_>, Method, Run)> = Vec::new();
    for form in forms {
        // a form that takes more than the best so far is not the one, and need not be run to its end
        let most = coarse.iter().map(|(.., run)| run.evaluations).min();
        let Some((method, run)) = form.first(is_stiff, most, &mut spent) else { continue };
        // the best kind of method in one form is so in the other
        is_stiff = method.traits().implicit;
        coarse.push((form, method, run));
    }
    coarse.sort_by_key(|(.., run)| run.evaluations);
    let found = coarse.into_iter().find_map(|(form, method, run)| form.plan(method, run, watched, error, &mut spent));
    found.map(|plan| Plan { spent, ..plan })
}

/// A positive number that is written with two digits, at most so large: the tolerance that is printed is the one that was run.
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
