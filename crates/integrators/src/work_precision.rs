//! Work against precision: every method at every tolerance, errors against a reference, times taken side by side.

use std::time::{Duration, Instant};

use crate::{Failure, Method, Record, Reference, Span, System, Tolerance, Work, integrate};

/// The shortest time that is measured: a faster run is repeated within one measurement.
const SHORTEST: Duration = Duration::from_micros(200);

/// Measurements after which a median is settled.
const ENOUGH: usize = 15;

/// One run on the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub method: Method,
    /// None for a method with a constant step.
    pub tolerance: Option<f64>,
    /// The largest error at the reference's times relative to each component's size, or why there is none.
    pub error: Result<f64, Failure>,
    pub work: Work,
    /// The median over the measurements; none for a run that failed.
    pub seconds: Option<f64>,
    /// How many measurements the median is of.
    pub measurements: usize,
}

/// Runs every method at every tolerance, a method with a constant step once. The methods take turns in every round, so
/// that a slow moment of the machine meets them all, and the rounds end with the time allowed. The first runs, which give
/// the errors, have half of it: each may take its equal share of what the ones before have left.
///
/// The reference must be one of the same span: same start, same outputs.
pub fn work_precision(
    system: &dyn System,
    span: &Span<'_, f64>,
    methods: &[Method],
    tolerances: &[f64],
    reference: &Reference,
    allowed: Duration,
) -> Vec<Point> {
    let end = Instant::now() + allowed;
    let mut trials: Vec<Trial> = tolerances
        .iter()
        .enumerate()
        .flat_map(|(index, tolerance)| methods.iter().map(move |method| (index, *tolerance, *method)))
        .filter(|(index, _, method)| method.traits().adaptive || *index == 0)
        .map(|(_, tolerance, method)| Trial::new(method, Tolerance::scaled(tolerance, &reference.sizes)))
        .collect();
    let half = end - allowed / 2;
    let count = trials.len();
    for (index, trial) in trials.iter_mut().enumerate() {
        let share = half.saturating_duration_since(Instant::now()) / (count - index) as u32;
        trial.judge(system, span, reference, share);
    }
    for _ in 0..ENOUGH {
        for trial in &mut trials {
            trial.measure(system, span, end);
        }
    }
    trials.into_iter().map(Trial::point).collect()
}

/// A method at a tolerance, with its times so far.
struct Trial {
    method: Method,
    tolerance: Tolerance,
    error: Result<f64, Failure>,
    work: Work,
    first: Duration,
    seconds: Vec<f64>,
}

impl Trial {
    fn new(method: Method, tolerance: Tolerance) -> Self {
        let (error, work, first, seconds) = (Ok(f64::NAN), Work::default(), Duration::ZERO, Vec::new());
        Trial { method, tolerance, error, work, first, seconds }
    }

    /// The first run, for its error.
    fn judge(&mut self, system: &dyn System, span: &Span<'_, f64>, reference: &Reference, share: Duration) {
        let mut record = Record::new();
        let begin = Instant::now();
        let outcome = integrate(system, self.method, &self.tolerance, &bare(span, begin + share), &mut record);
        self.first = begin.elapsed();
        self.work = outcome.work;
        self.error = match outcome.failure() {
            Some(failure) => Err(failure),
            None => Ok(reference.error(&record)),
        };
    }

    /// One measurement, if the run succeeds and there is time for it.
    fn measure(&mut self, system: &dyn System, span: &Span<'_, f64>, end: Instant) {
        if self.error.is_err() || Instant::now() + self.first > end {
            return;
        }
        let span = bare(span, end);
        let (begin, mut runs) = (Instant::now(), 0);
        while runs == 0 || begin.elapsed() < SHORTEST {
            if !integrate(system, self.method, &self.tolerance, &span, &mut ()).reached() {
                return;
            }
            runs += 1;
        }
        self.seconds.push(begin.elapsed().as_secs_f64() / f64::from(runs));
    }

    fn point(mut self) -> Point {
        self.seconds.sort_by(f64::total_cmp);
        let median = self.seconds.get(self.seconds.len() / 2).copied();
        let seconds = median.or_else(|| self.error.is_ok().then_some(self.first.as_secs_f64()));
        let tolerance = self.method.traits().adaptive.then_some(self.tolerance.relative);
        let (method, error, work, measurements) = (self.method, self.error, self.work, self.seconds.len());
        Point { method, tolerance, error, work, seconds, measurements }
    }
}

/// The same span without monitors, to be done by a moment.
fn bare(span: &Span<'_, f64>, deadline: Instant) -> Span<'static, f64> {
    let deadline = span.budget.deadline.map_or(deadline, |own| own.min(deadline));
    let bare = Span::new(span.start, span.end, &span.state).with_outputs(&span.outputs);
    bare.with_evaluations(span.budget.evaluations).with_deadline(deadline)
}
