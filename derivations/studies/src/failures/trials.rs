//! Trials: the result of every method on a scene with a budget of evaluations.

use integrators::{End, Failure, Method, Outcome, Record, Span, System, Tolerance, check_by_step_halving, integrate};
use simulation::{Problem, methods};
use std::fmt;

/// The result of a method in a trial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fate {
    /// The result satisfies the condition.
    Holds,
    /// The run reaches its end, the result violates the condition, and no warning is given.
    Wrong,
    /// As `Wrong`, but step halving shows that the run does not follow its law.
    Told(&'static str),
    /// The run stops for this reason.
    Stops(String),
    /// The result is NaN: this must never happen.
    Undefined,
}

/// A method or formulation with its result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trial {
    /// The name of a method on the command line, or a formulation.
    pub by: String,
    pub fate: Fate,
}

/// The default budget of evaluations. A time limit would make results depend on the machine.
pub const BUDGET: u64 = 200_000;

/// The law that the methods integrate.
#[derive(Clone, Copy)]
pub enum Running<'a> {
    /// A law without events, over the whole span.
    Alone(&'a dyn System),
    /// A problem, across its events, or to the end of the validity of its law.
    Problem(&'a Problem),
}

/// A problem for trials of all methods.
pub struct Tried<'a> {
    pub law: Running<'a>,
    pub state: &'a [f64],
    /// The length of the run, s.
    pub span: f64,
    pub tolerance: f64,
    /// The number of steps of the methods with constant step size.
    pub steps: u32,
    /// The number of output times at which the result is checked.
    pub outputs: usize,
    /// The budget of evaluations of a method.
    pub budget: u64,
}

/// Every method with its name on the command line; methods with a constant step size make `steps` steps.
pub fn every_method(steps: u32) -> impl Iterator<Item = (String, Method)> {
    methods::list().filter_map(move |(written, _)| {
        let name = written.replace("STEPS", &steps.to_string());
        methods::method(&name).ok().map(|method| (name, method))
    })
}

impl<'a> Tried<'a> {
    /// A problem with default settings: four output times, a thousand steps for methods with a constant step size.
    pub fn of(problem: &'a Problem, tolerance: f64) -> Self {
        let (law, Problem { state, span, .. }) = (Running::Problem(problem), problem);
        Tried { law, state, span: *span, tolerance, steps: 1_000, outputs: 4, budget: BUDGET }
    }

    /// Runs one method: the outcome, the record of its outputs, and the reason if the validity of the law ended.
    pub fn run(&self, method: Method) -> (Outcome<f64>, Record<f64>, Option<&'static str>) {
        let span = Span::new(0.0, self.span, self.state).with_even_outputs(self.outputs).with_evaluations(self.budget);
        let mut record = Record::new();
        let tolerance = Tolerance::both(self.tolerance);
        let (outcome, left) = match self.law {
            Running::Alone(law) => (integrate(law, method, &tolerance, &span, &mut record), None),
            Running::Problem(problem) => problem.integrate(method, &tolerance, &span, &mut record),
        };
        (outcome, record, left)
    }

    /// The reference, by Radau IIA with seven stages.
    pub fn right(&self) -> Record<f64> {
        self.run(Method::RadauIIA { stages: 7 }).1
    }

    /// Trials of all methods that accept the law; `holds` checks a run that reached its end.
    pub fn all(&self, holds: impl Fn(&Record<f64>) -> bool) -> Vec<Trial> {
        let one = |(by, method): (String, Method)| {
            let (outcome, record, left) = self.run(method);
            let accepted = !matches!(outcome.failure(), Some(Failure::Refused(_)));
            accepted.then(|| {
                let told = match fate(&outcome, &record, left, &holds) {
                    Fate::Wrong => {
                        check_by_step_halving(method, &record, |shorter| self.run(shorter)).map(|beside| beside.verdict)
                    }
                    fate => return Trial { by, fate },
                };
                let told = told.filter(|verdict| verdict.departs()).map(|verdict| Fate::Told(verdict.name()));
                Trial { by, fate: told.unwrap_or(Fate::Wrong) }
            })
        };
        every_method(self.steps).filter_map(one).collect()
    }
}

/// The result of a run.
pub fn fate(
    outcome: &Outcome<f64>,
    record: &Record<f64>,
    left: Option<&'static str>,
    holds: impl Fn(&Record<f64>) -> bool,
) -> Fate {
    let numbers = record.states.iter().flatten().chain(&outcome.state);
    if !outcome.time.is_finite() || numbers.into_iter().any(|y| !y.is_finite()) {
        return Fate::Undefined;
    }
    match outcome.end {
        _ if left.is_some() => Fate::Stops(left.unwrap_or_default().to_owned()),
        End::Stopped(failure) => Fate::Stops(failure.name().to_owned()),
        End::Reached | End::Halted if holds(record) => Fate::Holds,
        End::Reached | End::Halted => Fate::Wrong,
    }
}

impl Fate {
    /// The order in tables: successful methods first, then those that fail silently.
    pub fn rank(&self) -> u8 {
        match self {
            Fate::Holds => 0,
            Fate::Wrong => 1,
            Fate::Told(_) => 2,
            Fate::Stops(_) => 3,
            Fate::Undefined => 4,
        }
    }
}

impl fmt::Display for Fate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fate::Holds => f.write_str("holds"),
            Fate::Wrong => f.write_str("wrong, without a message"),
            Fate::Told(why) => write!(f, "wrong, with a message: {why}"),
            Fate::Stops(why) => write!(f, "stops: {why}"),
            Fate::Undefined => f.write_str("NaN"),
        }
    }
}

/// A component below this fraction of the largest counts as zero.
const ROUNDING: f64 = 1e-9;

/// Whether a run is close to the reference in every component, relative to the component's size.
pub fn near(record: &Record<f64>, right: &Record<f64>, share: f64) -> bool {
    let count = right.states.first().map_or(0, Vec::len);
    let size = |i: usize| right.states.iter().map(|state| state[i].abs()).fold(f64::MIN_POSITIVE, f64::max);
    let sizes: Vec<f64> = (0..count).map(size).collect();
    // for components that are zero within rounding
    let least = ROUNDING * sizes.iter().copied().fold(0.0, f64::max);
    let sizes: Vec<f64> = sizes.into_iter().map(|size| size.max(least)).collect();
    let close =
        |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).zip(&sizes).all(|((a, b), s)| (a - b).abs() <= share * s);
    record.times == right.times && record.states.iter().zip(&right.states).all(close)
}

/// The result of a method on a problem with events; `None` where the method does not accept the law.
pub fn across_events(
    problem: &Problem,
    (method, tolerance): (Method, f64),
    holds: impl Fn(&Record<f64>) -> bool,
) -> Option<Fate> {
    let span = Span::new(0.0, problem.span, &problem.state).with_even_outputs(1).with_evaluations(BUDGET);
    let mut record = Record::new();
    let (outcome, left) = problem.integrate(method, &Tolerance::both(tolerance), &span, &mut record);
    let accepted = !matches!(outcome.failure(), Some(Failure::Refused(_)));
    // only the first clause: the others explain it
    let left = left.and_then(|why| why.split(':').next());
    accepted.then(|| fate(&outcome, &record, left, holds))
}
