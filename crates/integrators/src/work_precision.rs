//! Work against precision: every method at every tolerance, errors against a reference, times taken side by side.

use std::time::{Duration, Instant};

use crate::{Failure, Median, Method, Record, Reference, Span, System, Tolerance, Work, integrate, taking_turns};

/// One run on the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub method: Method,
    /// None for a method with a constant step.
    pub tolerance: Option<f64>,
    /// The largest error at the reference's times relative to each component's size, or why there is none.
    pub error: Result<f64, Failure>,
    pub work: Work,
    /// The time; none for a run that failed, or that was not measured.
    pub time: Option<Median>,
}

/// Runs every method at every tolerance, a method with a constant step once, without times: problems may be judged at the
/// same time. Each run may take its equal share of what the ones before have left of the time allowed.
///
/// The reference must be one of the same span: same start, same outputs.
pub fn judge(
    system: &dyn System,
    span: &Span<'_, f64>,
    methods: &[Method],
    tolerances: &[f64],
    reference: &Reference,
    allowed: Duration,
) -> Vec<Point> {
    let end = Instant::now() + allowed;
    let tried: Vec<(f64, Method)> = tolerances
        .iter()
        .enumerate()
        .flat_map(|(index, tolerance)| methods.iter().map(move |method| (index, *tolerance, *method)))
        .filter(|(index, _, method)| method.traits().adaptive || *index == 0)
        .map(|(_, tolerance, method)| (tolerance, method))
        .collect();
    let count = tried.len();
    let judged = tried.into_iter().enumerate().map(|(index, (relative, method))| {
        let share = end.saturating_duration_since(Instant::now()) / (count - index) as u32;
        let tolerance = Tolerance::scaled(relative, &reference.sizes);
        let mut record = Record::new();
        let outcome = integrate(system, method, &tolerance, &bare(span, Instant::now() + share), &mut record);
        let error = outcome.failure().map_or_else(|| Ok(reference.error(&record)), Err);
        let tolerance = method.traits().adaptive.then_some(relative);
        Point { method, tolerance, error, work: outcome.work, time: None }
    });
    judged.collect()
}

/// Takes the times of the points that reached the end, side by side, within the time allowed: while nothing else runs.
pub fn measure(
    system: &dyn System,
    span: &Span<'_, f64>,
    points: &mut [Point],
    reference: &Reference,
    allowed: Duration,
) {
    let reached: Vec<usize> = (0..points.len()).filter(|index| points[*index].error.is_ok()).collect();
    let span = bare(span, Instant::now() + allowed);
    let runs: Vec<(Method, Tolerance)> = reached
        .iter()
        .map(|index| &points[*index])
        // a constant step follows no tolerance
        .map(|point| (point.method, Tolerance::scaled(point.tolerance.unwrap_or(f64::EPSILON), &reference.sizes)))
        .collect();
    let times = taking_turns(runs.len(), allowed, |index| {
        let (method, tolerance) = &runs[index];
        integrate(system, *method, tolerance, &span, &mut ()).reached()
    });
    reached.into_iter().zip(times).for_each(|(index, time)| points[index].time = time);
}

/// The same span without monitors, to be done by a moment.
fn bare(span: &Span<'_, f64>, deadline: Instant) -> Span<'static, f64> {
    let deadline = span.budget.deadline.map_or(deadline, |own| own.min(deadline));
    let bare = Span::new(span.start, span.end, &span.state).with_outputs(&span.outputs);
    bare.with_evaluations(span.budget.evaluations).with_deadline(deadline)
}
