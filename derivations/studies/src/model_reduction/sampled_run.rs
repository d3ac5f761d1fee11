//! Runs sampled at the times at which errors are measured, by an explicit or, for stiff laws, an implicit method.

use integrators::{Failure, Method, Observer, Record, Span, System, Tolerance, integrate};

/// The number of output times after the start, equal to that of references.
pub const INSTANTS: usize = 8;
/// The largest number of evaluations of a run, which is not reached unless the law is stiff or the motion too long.
const PATIENCE: u64 = 100_000;
/// The relative tolerance of a run that determines sizes, or of a pilot run.
pub const COARSE: f64 = 1e-5;

/// The number of times after the start at which an error is evaluated, besides every step of the run that propagates
/// it. They include the output times of references.
pub const LOOKS: usize = 64;

/// The output times of a run from time zero, s.
pub fn instants(span: f64) -> impl Iterator<Item = f64> {
    even(span, INSTANTS)
}

/// The times at which an error is evaluated, s.
pub(super) fn looks(span: f64) -> impl Iterator<Item = f64> {
    even(span, LOOKS)
}

fn even(span: f64, count: usize) -> impl Iterator<Item = f64> {
    (1..=count).map(move |k| span * (k as f64 / count as f64))
}

/// A run sampled at the output times, by an explicit method, or by an implicit one if the explicit one fails. Returns
/// also the number of evaluations.
///
/// # Errors
/// [`Failure`] of the implicit method.
pub fn followed(
    law: &dyn System,
    tolerance: &Tolerance,
    span: f64,
    start: &[f64],
) -> Result<(Record<f64>, u64), Failure> {
    followed_at(law, tolerance, &instants(span).collect::<Vec<_>>(), start)
}

/// A run from time zero sampled at these times, the last of which is the end.
///
/// # Errors
/// [`Failure`] of the implicit method.
pub fn followed_at(
    law: &dyn System,
    tolerance: &Tolerance,
    times: &[f64],
    start: &[f64],
) -> Result<(Record<f64>, u64), Failure> {
    followed_while(law, tolerance, 0.0, times, start, &mut false, &mut |_, _| true)
}

/// A run from a time to the last output, as long as `goes_on` returns true; it is called at outputs and steps, and
/// again from the beginning when the implicit method starts. With `stiff` the explicit method is not tried; `stiff` is
/// set when the implicit one succeeds.
pub(super) fn followed_while(
    law: &dyn System,
    tolerance: &Tolerance,
    from: f64,
    outputs: &[f64],
    start: &[f64],
    stiff: &mut bool,
    goes_on: &mut dyn FnMut(f64, &[f64]) -> bool,
) -> Result<(Record<f64>, u64), Failure> {
    let to = outputs.last().copied().unwrap_or(from);
    let mut run = |method: Method| {
        let mut seen = Seen { record: Record::new(), goes_on: &mut *goes_on, over: false };
        let times = Span::new(from, to, start).with_outputs(outputs).with_evaluations(PATIENCE);
        let outcome = integrate(law, method, tolerance, &times, &mut seen);
        let evaluations = outcome.work.rates + outcome.work.jacobians * start.len() as u64;
        (outcome.failure().map_or(Ok(seen.record), Err), evaluations)
    };
    let mut spent = 0;
    if !*stiff {
        let (explicit, evaluations) = run(Method::DormandPrince8);
        if let Ok(record) = explicit {
            return Ok((record, evaluations));
        }
        spent = evaluations;
    }
    let (implicit, evaluations) = run(Method::RadauIIA { stages: 3 });
    *stiff |= implicit.is_ok();
    implicit.map(|record| (record, spent + evaluations))
}

/// An observer that records outputs until the run is stopped.
struct Seen<'a> {
    record: Record<f64>,
    goes_on: &'a mut dyn FnMut(f64, &[f64]) -> bool,
    over: bool,
}

impl Observer<f64> for Seen<'_> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        if !self.over {
            self.record.sample(time, state);
            self.over = !(self.goes_on)(time, state);
        }
    }

    fn step(&mut self, time: f64, state: &[f64]) {
        self.over = self.over || !(self.goes_on)(time, state);
    }

    fn enough(&self) -> bool {
        self.over
    }
}
