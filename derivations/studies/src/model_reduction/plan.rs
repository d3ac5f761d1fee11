//! The cheapest method and form for a law at an error, by two pilot runs of those that may be.
//!
//! The first pilots of all methods go in rounds, each allowed more: who reaches the end in a round needs no more than the
//! others, which are left out, an implicit method already where an explicit one does. Of these only the cheapest have a second pilot, and are tried in the other form. The error of the coarser pilot is its distance from the finer; errors are taken to go with the tolerance, evaluations with
//! a power of it (those of Taylor's method grow less, and are then overrated). So the tolerance for an error and the cost
//! there are told before the run. Both are estimates.

use super::outputs::Watched;
use super::run_rows::{Along, Run};
use super::sampled_run::instants;
use integrators::{Method, Span, Tolerance, integrate};
use simulation::{Axes, Law};
use std::sync::Arc;

/// What is tried: one of each family that the atlas finds on its fronts.
const METHODS: [Method; 4] =
    [Method::DormandPrince8, Method::Taylor, Method::GraggBulirschStoer, Method::RadauIIA { stages: 5 }];
pub(super) const PILOTS: [f64; 2] = [1e-4, 1e-6];
/// Evaluations of the first pilots, round by round: so many that what is lost in those before does not matter.
const ROUNDS: [u64; 4] = [800, 3_200, 12_800, 50_000];
/// A method whose first pilot costs so much more than the cheapest one's is not the cheapest: an evaluation costs more in
/// some methods than in others, but not that much.
const DEARER: f64 = 3.0;
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
}

/// A run by a method, at a tolerance, within so many evaluations, with rows at its steps and at these times, the last of which
/// is its end; and the evaluations that it took. Without rows where it does not reach its end.
pub type Go<'a> = dyn Fn(Method, f64, u64, &[f64]) -> (Option<Run>, u64) + 'a;

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
    /// Its own pilots.
    pub pilots: [Run; 2],
}

impl Plan {
    /// The run at a tolerance, where a pilot was that.
    pub fn known(&self, tolerance: f64) -> Option<&Run> {
        let same = |(pilot, _): &(f64, &Run)| (tolerance / pilot - 1.0).abs() < 1e-9;
        PILOTS.into_iter().zip(&self.pilots).find(same).map(|(_, run)| run)
    }
}

impl<'a> Runnable<'a> {
    /// What runs by itself.
    pub fn new(axes: Axes, span: f64, go: impl Fn(Method, f64, u64, &[f64]) -> (Option<Run>, u64) + 'a) -> Self {
        Runnable { axes, span, go: Box::new(go) }
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
        Self::new(axes, span, move |method, tolerance, most, times| {
            let span = Span::new(0.0, span, &start).with_outputs(times).with_evaluations(most);
            let mut along = Along::within(&row, &outside);
            let outcome = integrate(&*law, method, &Tolerance::both(tolerance), &span, &mut along);
            let evaluations = outcome.work.rates + outcome.work.jacobians * start.len() as u64;
            ((outcome.reached() && !along.left()).then(|| along.run(evaluations)), evaluations)
        })
    }

    /// A run, with rows at its steps and at these times or, where there are none, at the instants.
    pub fn run(&self, method: Method, tolerance: f64, most: u64, times: Option<&[f64]>) -> (Option<Run>, u64) {
        let instants = || instants(self.span).collect::<Vec<_>>();
        (self.go)(method, tolerance, most, times.map_or_else(instants, <[f64]>::to_vec).as_slice())
    }

    /// The first pilot of each method that reaches the end in the first round in which some do.
    fn first(&self, methods: &[Method], spent: &mut u64) -> Vec<(Method, Run)> {
        let mut ended = Vec::new();
        for most in ROUNDS {
            for &method in methods {
                // where steps are not kept short by stiffness nobody solves for them
                if method.traits().implicit && !ended.is_empty() {
                    continue;
                }
                let (run, evaluations) = self.run(method, PILOTS[0], most, None);
                *spent += evaluations;
                ended.extend(run.map(|run| (method, run)));
            }
            if !ended.is_empty() {
                break;
            }
        }
        let least = ended.iter().map(|(_, run)| run.evaluations).min().unwrap_or(0) as f64;
        ended.retain(|(_, run)| run.evaluations as f64 <= DEARER * least);
        ended
    }

    /// The plan for an error by one method; none where the second pilot does not reach its end.
    fn plan(&self, method: Method, coarse: &Run, watched: &Watched, error: f64, spent: &mut u64) -> Option<Plan> {
        let times = coarse.times();
        let (fine, evaluations) = self.run(method, PILOTS[1], PATIENCE * coarse.evaluations.max(1), Some(&times));
        *spent += evaluations;
        let fine = fine?;
        let off = coarse.apart(&fine, watched)?.max(1e-16);
        let tolerance = two_digits((PILOTS[0] * error / off).clamp(FINEST, PILOTS[0])).max(FINEST);
        let slope = (fine.evaluations as f64 / coarse.evaluations as f64).ln() / (PILOTS[0] / PILOTS[1]).ln();
        let foretold = coarse.evaluations as f64 * (PILOTS[0] / tolerance).powf(slope.max(0.0));
        let error = (off * tolerance / PILOTS[0]).max(1e-15);
        Some(Plan { axes: self.axes, method, tolerance, error, foretold, spent: 0, pilots: [coarse.clone(), fine] })
    }
}

/// Plans for an error, the cheapest foretold first.
pub fn plans(forms: &[Runnable<'_>], watched: &Watched, error: f64) -> Vec<Plan> {
    let mut spent = 0;
    let mut methods = METHODS.to_vec();
    let mut found: Vec<Plan> = Vec::new();
    for form in forms {
        let ended = form.first(&methods, &mut spent);
        let plans = ended.iter().filter_map(|(method, run)| form.plan(*method, run, watched, error, &mut spent));
        found.extend(plans.collect::<Vec<_>>());
        // what is not worth a second pilot in one form is not in the other
        methods = ended.into_iter().map(|(method, _)| method).collect();
    }
    found.iter_mut().for_each(|plan| plan.spent = spent);
    found.sort_by(|a, b| a.foretold.total_cmp(&b.foretold));
    found
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
