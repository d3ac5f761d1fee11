//! Runs at the instants at which errors are taken, by whatever method reaches their end.

use integrators::{Failure, Method, Observer, Record, Span, System, Tolerance, integrate};

/// Instants beside the start: those of the references.
pub const INSTANTS: usize = 8;
/// Evaluations after which an explicit method has met stiffness, or a motion that is not worth following.
const PATIENCE: u64 = 100_000;
/// Relative, of a run that is to show sizes or pilot a choice.
pub const COARSE: f64 = 1e-5;

/// Instants beside the start at which an error is looked at, besides every step of the run that carries it. The instants
/// of the references are among them.
pub const LOOKS: usize = 64;

/// The instants of a run from time zero.
pub fn instants(span: f64) -> impl Iterator<Item = f64> {
    even(span, INSTANTS)
}

/// The instants at which an error is looked at.
pub(super) fn looks(span: f64) -> impl Iterator<Item = f64> {
    even(span, LOOKS)
}

fn even(span: f64, count: usize) -> impl Iterator<Item = f64> {
    (1..=count).map(move |k| span * (k as f64 / count as f64))
}

/// A run at the instants, by an explicit method, or where that meets stiffness by an implicit one.
///
/// # Errors
/// Where neither reaches the end.
pub fn followed(
    law: &dyn System,
    tolerance: &Tolerance,
    span: f64,
    start: &[f64],
) -> Result<(Record<f64>, u64), Failure> {
    followed_at(law, tolerance, &instants(span).collect::<Vec<_>>(), start)
}

/// The same from time zero at these times, the last of which is the end.
///
/// # Errors
/// Where neither method reaches the end.
pub fn followed_at(
    law: &dyn System,
    tolerance: &Tolerance,
    times: &[f64],
    start: &[f64],
) -> Result<(Record<f64>, u64), Failure> {
    followed_while(law, tolerance, 0.0, times, start, &mut false, &mut |_, _| true)
}

/// The same from a time to the last of these, as long as it may go on: asked at the outputs and at every step, and from the
/// beginning anew where the implicit method begins anew.
/// What is known to be stiff is not tried by the explicit one, and is known after it.
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

/// Keeps what is shown until that is enough.
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
