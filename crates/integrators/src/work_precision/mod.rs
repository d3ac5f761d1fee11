//! Work-precision measurements: methods at several tolerances, with errors against a reference and interleaved timing.

mod front;
mod interleaved_timing;
mod regret;

pub use front::{excess, front};
pub use interleaved_timing::{Median, interleaved};
pub use regret::{Regrets, Trial, cost};

use std::time::{Duration, Instant};

use crate::{Attempt, Failure, Means, Record, Span, Tolerance, Work};
use interleaved_timing::at_most;

/// One run: a point of a work-precision chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub means: Means,
    /// The tolerance; `None` for a method with a constant step.
    pub tolerance: Option<f64>,
    /// The error by the benchmark's error function, or the failure of the run.
    pub error: Result<f64, Failure>,
    pub work: Work,
    /// The work in evaluations: see [`Attempt::evaluations`].
    pub evaluations: u64,
    /// The time; `None` for a run that failed or was not timed.
    pub time: Option<Median>,
}

/// A problem for the comparison of methods, with its error measure.
#[derive(Clone, Copy)]
pub struct Benchmark<'a> {
    pub span: &'a Span<'a, f64>,
    /// The size of each component of the state.
    pub sizes: &'a [f64],
    /// The error of a record of the states at the outputs of the span.
    pub error: &'a dyn Fn(&Record<f64>) -> f64,
}

/// Runs every attempt at every tolerance (a method with a constant step once), without timing, so that several problems
/// can be evaluated in parallel. The time `allowed` is shared among the runs.
pub fn judge(attempts: &[Attempt<'_>], course: &Benchmark<'_>, tolerances: &[f64], allowed: Duration) -> Vec<Point> {
    let end = Instant::now() + allowed;
    let tried: Vec<(f64, &Attempt<'_>)> = tolerances
        .iter()
        .enumerate()
        .flat_map(|(index, tolerance)| attempts.iter().map(move |attempt| (index, *tolerance, attempt)))
        .filter(|(index, _, attempt)| attempt.means().steps().is_none() || *index == 0)
        .map(|(_, tolerance, attempt)| (tolerance, attempt))
        .collect();
    let count = tried.len();
    let judged = tried.into_iter().enumerate().map(|(index, (relative, attempt))| {
        let left = end.saturating_duration_since(Instant::now());
        let share = left / MOST_SHARES.min(count - index) as u32;
        let tolerance = Tolerance::scaled(relative, course.sizes);
        let mut record = Record::new();
        let outcome = attempt.run(&tolerance, &bare(course.span, Instant::now() + share), &mut record);
        // the error is NaN if the record has other times than the reference
        let compared = |error: f64| match error.is_nan() {
            true => Err(Failure::OtherCourse { at: outcome.time }),
            false => Ok(error),
        };
        let error = outcome.failure().map_or_else(|| compared((course.error)(&record)), Err);
        let means = attempt.means();
        let tolerance = means.steps().is_none().then_some(relative);
        let evaluations = attempt.evaluations(&outcome.work);
        Point { means, tolerance, error, work: outcome.work, evaluations, time: None }
    });
    judged.collect()
}

/// A run may take the remaining time divided by the number of remaining runs, or by this number if that is smaller.
const MOST_SHARES: usize = 8;

/// A run that reached its end, to be timed.
pub struct Timed<'a> {
    pub attempt: Attempt<'a>,
    pub span: &'a Span<'a, f64>,
    pub tolerance: Tolerance,
    pub error: f64,
    pub evaluations: u64,
}

/// A run with at most this cost relative to the Pareto front is measured until its median is settled.
const NEAR: f64 = 2.0;
/// The number of measurements of all other runs.
const FEW: usize = 3;

/// The times of runs that reached their ends, measured in turns. Runs near the Pareto front get more measurements. The
/// cheapest runs come first, so that the most expensive ones are skipped if the time is short: these have `None`.
pub fn measure(runs: &[Timed<'_>], allowed: Duration) -> Vec<Option<Median>> {
    let deadline = Instant::now() + allowed;
    // outputs do not affect the steps and are not timed
    let timed = |run: &Timed<'_>| bare(run.span, deadline).with_outputs(&[run.span.end]);
    let spans: Vec<Span<'static, f64>> = runs.iter().map(timed).collect();
    let go = |at: usize| runs[at].attempt.run(&runs[at].tolerance, &spans[at], &mut ()).reached();
    let mut order: Vec<usize> = (0..runs.len()).collect();
    order.sort_by_key(|&at| runs[at].evaluations);
    let mut times: Vec<Option<Median>> = vec![None; runs.len()];
    for (at, time) in order.iter().zip(at_most(FEW, runs.len(), allowed * 3 / 5, |turn| go(order[turn]))) {
        times[*at] = time;
    }
    let measured = |(run, time): (&Timed<'_>, &Option<Median>)| (time.map_or(f64::NAN, |time| time.seconds), run.error);
    let excess = excess(&runs.iter().zip(&times).map(measured).collect::<Vec<_>>());
    let near: Vec<usize> = (0..runs.len()).filter(|&at| excess[at] <= NEAR).collect();
    let left = deadline.saturating_duration_since(Instant::now());
    for (at, time) in near.iter().zip(interleaved(near.len(), left, |turn| go(near[turn]))) {
        times[*at] = time.filter(|time| time.measurements >= FEW).or(times[*at]);
    }
    times
}

/// The span without monitors, with a deadline.
fn bare(span: &Span<'_, f64>, deadline: Instant) -> Span<'static, f64> {
    let deadline = span.budget.deadline.map_or(deadline, |own| own.min(deadline));
    let bare = Span::new(span.start, span.end, &span.state).with_outputs(&span.outputs);
    bare.with_evaluations(span.budget.evaluations).with_deadline(deadline)
}
