//! Runs sampled at the instants at which errors are measured, by an explicit or, for stiff laws, an implicit method.

use integrators::{Failure, Method, Observer, Record, Span, System, Tolerance, integrate};

/// Output instants after the start: those of the references.
pub const INSTANTS: usize = 8;
/// Evaluations after which a run is given up: the law is stiff, or the motion too long.
const PATIENCE: u64 = 100_000;
/// The relative tolerance of a run that gives sizes or pilots a choice.
pub const COARSE: f64 = 1e-5;

/// Instants after the start at which an error is evaluated, besides every step of the run that propagates it. They include the
/// instants of the references.
pub const LOOKS: usize = 64;

/// The output instants, s, of a run from time zero.
pub fn instants(span: f64) -> impl Iterator<Item = f64> {
    even(span, INSTANTS)
}

/// The instants, s, at which an error is evaluated.
pub(super) fn looks(span: f64) -> impl Iterator<Item = f64> {
    even(span, LOOKS)
}

fn even(span: f64, count: usize) -> impl Iterator<Item = f64> {
    (1..=count).map(move |k| span * (k as f64 / count as f64))
}

/// A run sampled at the instants, by an explicit method, or by an implicit one where the explicit one fails.
///
/// # Errors
/// The failure of the implicit method.
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
/// The failure of the implicit method.
pub fn followed_at(
    law: &dyn System,
    tolerance: &Tolerance,
    times: &[f64],
    start: &[f64],
) -> Result<(Record<f64>, u64), Failure> {
    followed_while(law, tolerance, 0.0, times, start, &mut false, &mut |_, _| true)
}

/// A run from a time to the last output, as long as `goes_on` holds; it is called at outputs and steps, and from the beginning
/// anew when the implicit method starts.
/// With `stiff` the explicit method is not tried; `stiff` is set when the implicit one succeeds.
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
