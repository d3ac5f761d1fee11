//! Reference solutions: the digits on which two methods of different families agree in double-double.
//!
//! The first method is Gauss collocation. The second one is, for nonstiff problems, the system's Taylor series or
//! Gragg-Bulirsch-Stoer extrapolation; for stiff problems, Radau IIA collocation, which has other nodes, another order
//! and other steps.
//!
//! A problem that is stiff at a coarse tolerance need not be stiff at the tightest one, where steps are short in any
//! case: for a circuit with diodes an explicit method fails as stiff at 1e-7, but at 5e-31 its series takes only three
//! times as many steps as Gauss. The choice is therefore made by the run at the tight tolerance. An explicit second
//! method is preferred because collocation estimates the error of a step at one of its ends. Where a long step ends at
//! the knee of a diode characteristic, the true error was up to 5e6 tolerances for Radau IIA with 11 stages, and 6e5
//! for Gauss with 12 (the median is below a tenth of a tolerance). Two collocation methods share 24.8 digits there, the
//! series and Gauss 26.3; the motion itself amplifies errors only 70-fold in 5 s.

mod step_halving_check;

pub use step_halving_check::{ShorterRun, StepHalvingCheck, StepHalvingVerdict, check_by_step_halving};

use field::{DoubleDouble, Over};

use crate::methods::integrate::collocate_gauss;
use crate::{
    Failure, Method, Outcome, Record, Refusal, Sizes, Span, System, Tolerance, Work, Working, integrate, integrate_in,
};

/// The smallest number of digits of a trusted reference.
pub const ENOUGH_DIGITS: f64 = 20.0;

/// The tightest useful tolerance: at a fifth of it rounding prevents convergence of Newton's iteration.
pub const TIGHTEST: f64 = 5e-31;

/// Safety factor for the difference of the two solutions: errors of equal sign partly cancel in the difference. In
/// problems with closed forms the true error was up to 1.2 times the difference.
const KEPT_BACK: f64 = 3.0;

/// The budget of evaluations of the explicit method in a coarse run; an implicit method is tried after that.
const COARSE_EVALUATIONS: u64 = 1_000_000;

/// The problem counts as stiff if the average product of step size of Gauss and spectral radius is above this. A series
/// of 60 terms, at the tightest tolerance, allows a product of 23 per step. Diodes reach 36, stiff windings 500 and
/// more.
const STIFF_STEP: f64 = 100.0;

/// A component smaller than this fraction of the largest component may be rounding only.
const ROUNDED: f64 = 1e-10;

/// A component counts as zero if its magnitude in double-double is smaller than in `f64` by this factor.
const LEFT: f64 = 1e-6;

/// A solution in double-double, accurate enough to measure the errors of runs in `f64`.
#[derive(Clone, Debug)]
pub struct Reference {
    pub times: Vec<f64>,
    /// One state for each time.
    pub states: Vec<Vec<DoubleDouble>>,
    /// The digits of agreement: -log10 of three times the largest difference of the two methods, relative to `sizes`.
    pub digits: f64,
    /// The largest magnitude of each component along the motion; 1 for a component that stays zero.
    pub sizes: Vec<f64>,
    /// The two methods; the states are those of the first.
    pub methods: [Method; 2],
    pub work: [Work; 2],
}

impl Reference {
    /// Whether the two methods agree to at least [`ENOUGH_DIGITS`] digits.
    pub fn is_trusted(&self) -> bool {
        self.digits >= ENOUGH_DIGITS
    }

    /// The largest error of a record at the reference's times, relative to the size of each component; NaN where the
    /// times differ.
    pub fn error(&self, record: &Record<f64>) -> f64 {
        if record.times != self.times {
            return f64::NAN;
        }
        let states = record.states.iter().map(|state| state.iter().map(|y| DoubleDouble::lift(*y)).collect());
        difference(&states.collect::<Vec<Vec<_>>>(), &self.states, &self.sizes)
    }
}

/// Computes a reference at the outputs of a span. Each of the two methods may spend the budget of the span.
///
/// # Errors
/// [`Failure`] where the span has no output, or a method does not reach its end.
pub fn reference(system: &dyn System, span: &Span<'_, f64>) -> Result<Reference, Failure> {
    if span.outputs.is_empty() {
        let (start, end) = (span.start, span.end);
        return Err(Failure::Refused(Refusal::Output { index: 0, time: f64::NAN, start, end }));
    }
    let sizes = survey(system, span)?;
    let lifted: Vec<DoubleDouble> = span.state.iter().map(|y| DoubleDouble::lift(*y)).collect();
    let mut exact = Span::new(span.start, span.end, &lifted).with_outputs(&span.outputs);
    exact.budget = span.budget;
    let stages = if span.state.len() > 6 { 12 } else { 16 };
    let tolerance = Tolerance::scaled(TIGHTEST, &sizes);
    let mut first = Record::new();
    let (outcome, turns) = collocate_gauss(system, stages, &tolerance, &exact, &mut first);
    let one = reached(outcome)?;
    let stiff = turns / one.steps as f64 > STIFF_STEP;
    let (method, other, second) = second_opinion(system, stiff, stages, &tolerance, &exact)?;
    let digits = shared_digits(difference(&first.states, &second.states, &sizes));
    let methods = [Method::Gauss { stages }, method];
    Ok(Reference { times: first.times, states: first.states, digits, sizes, methods, work: [one, other] })
}

/// The largest magnitude of each component along a coarse run; 1 for a component that is zero up to rounding.
///
/// # Errors
/// [`Failure`] where neither an explicit nor an implicit method reached the end.
pub fn survey(system: &dyn System, span: &Span<'_, f64>) -> Result<Vec<f64>, Failure> {
    let implicit = Method::RadauIIA { stages: 3 };
    let explicit = coarse(system, span, Method::DormandPrince8, COARSE_EVALUATIONS);
    let (method, mut sizes) = match explicit {
        // an explicit method that exists in double-double
        Ok(sizes) => (Method::GraggBulirschStoer, sizes),
        Err(refused @ Failure::Refused(_)) => return Err(refused),
        Err(_) => (implicit, coarse(system, span, implicit, span.budget.evaluations)?),
    };
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    let is_small = |size: f64| size <= ROUNDED * largest;
    if sizes.iter().any(|size| is_small(*size))
        && let Some(exact) = coarse_exact(system, span, method)
    {
        let all = sizes.iter_mut().zip(exact);
        all.filter(|(size, exact)| is_small(**size) && *exact <= LEFT * **size).for_each(|(size, _)| *size = 1.0);
    }
    Ok(sizes)
}

/// The largest magnitudes in a double-double run; `None` where it does not reach the end.
fn coarse_exact(system: &dyn System, span: &Span<'_, f64>, method: Method) -> Option<Vec<f64>> {
    let lifted: Vec<DoubleDouble> = span.state.iter().map(|y| DoubleDouble::lift(*y)).collect();
    let mut plain = Span::new(span.start, span.end, &lifted).with_outputs(&span.outputs);
    plain.budget = span.budget;
    let mut sizes = vec![0.0_f64; lifted.len()];
    let mut record = Record::new();
    reached(integrate_in(system, method, &Tolerance::both(1e-7), &plain, &mut record)).ok()?;
    for state in &record.states {
        sizes.iter_mut().zip(state).for_each(|(size, part)| *size = size.max(part.hi().abs()));
    }
    Some(sizes)
}

fn coarse(system: &dyn System, span: &Span<'_, f64>, method: Method, evaluations: u64) -> Result<Vec<f64>, Failure> {
    let mut plain = Span::new(span.start, span.end, &span.state).with_outputs(&span.outputs);
    plain.budget = span.budget;
    plain.budget.evaluations = evaluations.min(span.budget.evaluations);
    let mut sizes = Sizes(span.state.iter().map(|y| y.abs()).collect());
    reached(integrate(system, method, &Tolerance::both(1e-7), &plain, &mut sizes))?;
    Ok(sizes.0.into_iter().map(|size| if size > 0.0 { size } else { 1.0 }).collect())
}

/// The run of the first method of another family that reaches the end.
fn second_opinion(
    system: &dyn System,
    stiff: bool,
    stages: u8,
    tolerance: &Tolerance,
    span: &Span<'_, DoubleDouble>,
) -> Result<(Method, Work, Record<DoubleDouble>), Failure> {
    let implicit = Method::RadauIIA { stages: stages - 1 };
    let explicit = if DoubleDouble::series(system).is_some() { Method::Taylor } else { Method::GraggBulirschStoer };
    let run = |method| {
        let mut record = Record::new();
        reached(integrate_in(system, method, tolerance, span, &mut record)).map(|work| (method, work, record))
    };
    if stiff { run(implicit) } else { run(explicit).or_else(|_| run(implicit)) }
}

fn reached<S>(outcome: Outcome<S>) -> Result<Work, Failure> {
    outcome.failure().map_or(Ok(outcome.work), Err)
}

/// The number of digits that two solutions with this largest relative difference share.
pub fn shared_digits(difference: f64) -> f64 {
    -(KEPT_BACK * difference).max(1e-32).log10()
}

/// The largest difference of two trajectories, each a list of states at the same times, relative to the sizes of their
/// components.
pub fn difference(a: &[Vec<DoubleDouble>], b: &[Vec<DoubleDouble>], sizes: &[f64]) -> f64 {
    let state = |(a, b): (&Vec<DoubleDouble>, &Vec<DoubleDouble>)| {
        a.iter().zip(b).zip(sizes).map(|((a, b), size)| (*a - *b).hi().abs() / size).fold(0.0, f64::max)
    };
    a.iter().zip(b).map(state).fold(0.0, f64::max)
}
