//! Reference solutions: two methods of different families in double-double, and the digits on which they agree.
//!
//! The first is Gauss collocation. The second is, where the problem is not stiff, the system's own Taylor series or
//! Gragg-Bulirsch-Stoer extrapolation; where it is, Radau IIA collocation with other nodes, another order and its own
//! steps. The digits are those that both share.
//!
//! A problem that is stiff at a coarse tolerance need not be stiff at the tightest one, whose steps are short in any case: an
//! explicit method gives up a circuit with diodes at 1e-7, but at 5e-31 its series takes only three times as many steps as Gauss.
//! The run itself therefore decides. Collocation estimates the error of a step at one of its ends; where a long step ends at the
//! knee of a diode, its error is up to 5e6 tolerances with 11 stages of Radau IIA, 6e5 with 12 of Gauss (each step beside the
//! series from its own start; the median is below a tenth of a tolerance). Two collocations share 24.8 digits there, the series
//! and Gauss 26.3, while a change of the start grows 70-fold in 5 s: the digits are lost by the methods, not by the motion.

mod step_halving_check;

pub use step_halving_check::{ShorterRun, StepHalvingCheck, StepHalvingVerdict, check_by_step_halving};

use field::{DoubleDouble, Over};

use crate::methods::integrate::collocate_gauss;
use crate::{
    Failure, Method, Outcome, Record, Refusal, Sizes, Span, System, Tolerance, Work, Working, integrate, integrate_in,
};

/// The least number of digits of a reference.
pub const ENOUGH_DIGITS: f64 = 20.0;

/// The tightest useful tolerance: five times below it rounding keeps Newton's iteration from its end.
pub const TIGHTEST: f64 = 5e-31;

/// Factor on the difference of the two solutions: errors of one sign may differ by less than either. Closed forms show true
/// errors up to 1.2 of the difference.
const KEPT_BACK: f64 = 3.0;

/// Evaluations of an explicit method in a coarse run after which an implicit one is asked.
const COARSE_EVALUATIONS: u64 = 1_000_000;

/// The product of Gauss' step size and the spectral radius, on average, above which stability, not accuracy, would limit the
/// step of an explicit method: a series of 60 terms, at the tightest tolerance, bears 23 in a step. Diodes come to 36, stiff
/// windings to 500 and more.
const STIFF_STEP: f64 = 100.0;

/// The share of the largest size below which a size may be rounding of a component that stays zero.
const ROUNDED: f64 = 1e-10;

/// The relative size in double-double below which such a component is rounding; a component that moves keeps its size.
const LEFT: f64 = 1e-6;

/// A solution accurate enough to measure the errors of others.
#[derive(Clone, Debug)]
pub struct Reference {
    pub times: Vec<f64>,
    /// One state for each time.
    pub states: Vec<Vec<DoubleDouble>>,
    /// -log10 of three times the largest difference of the two methods, relative to the size of each component.
    pub digits: f64,
    /// The largest magnitude of each component along the motion, 1 for one that stays zero.
    pub sizes: Vec<f64>,
    /// The two methods, the first of which gave the states.
    pub methods: [Method; 2],
    pub work: [Work; 2],
}

impl Reference {
    /// Whether the two methods agree on at least [`ENOUGH_DIGITS`].
    pub fn is_trusted(&self) -> bool {
        self.digits >= ENOUGH_DIGITS
    }

    /// The largest error of a trajectory at the reference's times, relative to the size of each component.
    /// NaN where the times differ.
    pub fn error(&self, record: &Record<f64>) -> f64 {
        if record.times != self.times {
            return f64::NAN;
        }
        let states = record.states.iter().map(|state| state.iter().map(|y| DoubleDouble::lift(*y)).collect());
        difference(&states.collect::<Vec<Vec<_>>>(), &self.states, &self.sizes)
    }
}

/// Computes a reference at the outputs of a span, within the span's budget for each of the two methods.
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

/// The largest magnitude of each component along a coarse run, 1 for one that stays zero, up to rounding.
///
/// # Errors
/// Where neither an explicit nor an implicit method reached the end.
pub fn survey(system: &dyn System, span: &Span<'_, f64>) -> Result<Vec<f64>, Failure> {
    let implicit = Method::RadauIIA { stages: 3 };
    let explicit = coarse(system, span, Method::DormandPrince8, COARSE_EVALUATIONS);
    let (method, mut sizes) = match explicit {
        // the explicit method that runs in double-double
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

/// The largest magnitudes in double-double; `None` where the run does not reach its end.
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

/// The run of a method of another family: the first that reaches the end.
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

/// The digits that two solutions with this largest relative difference share.
pub fn shared_digits(difference: f64) -> f64 {
    -(KEPT_BACK * difference).max(1e-32).log10()
}

/// The largest difference of two trajectories, relative to the sizes of the components.
pub fn difference(a: &[Vec<DoubleDouble>], b: &[Vec<DoubleDouble>], sizes: &[f64]) -> f64 {
    let state = |(a, b): (&Vec<DoubleDouble>, &Vec<DoubleDouble>)| {
        a.iter().zip(b).zip(sizes).map(|((a, b), size)| (*a - *b).hi().abs() / size).fold(0.0, f64::max)
    };
    a.iter().zip(b).map(state).fold(0.0, f64::max)
}
