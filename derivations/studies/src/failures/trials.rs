//! Every method on a scene under a budget, and what became of each.

use integrators::{End, Failure, Method, Outcome, Record, Span, System, Tolerance, beside, integrate};
use simulation::{Problem, methods};
use std::fmt;

/// What became of a method.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It comes out as it should.
    Holds,
    /// It reaches its end off by more than was asked, and says nothing.
    Wrong,
    /// It does that, and shorter steps show that it does not follow its law.
    Told(&'static str),
    /// It stops, and gives this reason.
    Stops(String),
    /// A number that is none came out: never.
    Undefined,
}

/// Something that was tried.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trial {
    /// A method as the command line reads it, or a formulation.
    pub by: String,
    pub fate: Fate,
}

/// The evaluations that a method may usually spend: no clock, whose answer would be the
/// machine's.
pub const BUDGET: u64 = 200_000;

/// The law that methods run.
#[derive(Clone, Copy)]
pub enum Running<'a> {
    /// Everywhere.
    Alone(&'a dyn System),
    /// Across its events, or to its end.
    Problem(&'a Problem),
}

/// A problem that every method is to try.
pub struct Tried<'a> {
    pub law: Running<'a>,
    pub state: &'a [f64],
    /// s
    pub span: f64,
    pub tolerance: f64,
    /// Of the methods with a constant step.
    pub steps: u32,
    /// Instants at which the result is looked at.
    pub outputs: usize,
    /// Evaluations that a method may spend.
    pub budget: u64,
}

/// Every method by the name that the command line reads, those of constant step with so many.
pub fn every_method(steps: u32) -> impl Iterator<Item = (String, Method)> {
    methods::list().filter_map(move |(written, _)| {
        let name = written.replace("STEPS", &steps.to_string());
        methods::method(&name).ok().map(|method| (name, method))
    })
}

impl<'a> Tried<'a> {
    /// A problem, seen at four instants, with a thousand steps where they are constant.
    pub fn of(problem: &'a Problem, tolerance: f64) -> Self {
        let (law, Problem { state, span, .. }) = (Running::Problem(problem), problem);
        Tried { law, state, span: *span, tolerance, steps: 1_000, outputs: 4, budget: BUDGET }
    }

    /// One method: how it ended, what it showed, and why the law ended where it did.
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

    /// What is right, by a collocation of high order.
    pub fn right(&self) -> Record<f64> {
        self.run(Method::RadauIIA { stages: 7 }).1
    }

    /// All methods that accept the law; of one that reached its end `holds` says whether it came out as it should.
    pub fn all(&self, holds: impl Fn(&Record<f64>) -> bool) -> Vec<Trial> {
        let one = |(by, method): (String, Method)| {
            let (outcome, record, left) = self.run(method);
            let accepted = !matches!(outcome.failure(), Some(Failure::Refused(_)));
            accepted.then(|| {
                let told = match fate(&outcome, &record, left, &holds) {
                    Fate::Wrong => beside(method, &record, |shorter| self.run(shorter)).map(|beside| beside.parting),
                    fate => return Trial { by, fate },
                };
                let told = told.filter(|parting| parting.parts()).map(|parting| Fate::Told(parting.name()));
                Trial { by, fate: told.unwrap_or(Fate::Wrong) }
            })
        };
        every_method(self.steps).filter_map(one).collect()
    }
}

/// What became of a run.
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
    /// In tables: what holds first, then what errs silently.
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
            Fate::Wrong => f.write_str("off, and says nothing"),
            Fate::Told(why) => write!(f, "off, and says so: {why}"),
            Fate::Stops(why) => write!(f, "stops: {why}"),
            Fate::Undefined => f.write_str("no number"),
        }
    }
}

/// The share of the largest component below which one is nothing.
const ROUNDING: f64 = 1e-9;

/// Whether a run is near another in every component, relative to its size there.
pub fn near(record: &Record<f64>, right: &Record<f64>, share: f64) -> bool {
    let count = right.states.first().map_or(0, Vec::len);
    let size = |i: usize| right.states.iter().map(|state| state[i].abs()).fold(f64::MIN_POSITIVE, f64::max);
    let sizes: Vec<f64> = (0..count).map(size).collect();
    // what stays zero is rounding
    let least = ROUNDING * sizes.iter().copied().fold(0.0, f64::max);
    let sizes: Vec<f64> = sizes.into_iter().map(|size| size.max(least)).collect();
    let close =
        |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).zip(&sizes).all(|((a, b), s)| (a - b).abs() <= share * s);
    record.times == right.times && record.states.iter().zip(&right.states).all(close)
}

/// A method on a problem across its events: `None` where it does not accept the law.
pub fn across_events(
    problem: &Problem,
    (method, tolerance): (Method, f64),
    holds: impl Fn(&Record<f64>) -> bool,
) -> Option<Fate> {
    let span = Span::new(0.0, problem.span, &problem.state).with_even_outputs(1).with_evaluations(BUDGET);
    let mut record = Record::new();
    let (outcome, left) = problem.integrate(method, &Tolerance::both(tolerance), &span, &mut record);
    let accepted = !matches!(outcome.failure(), Some(Failure::Refused(_)));
    // the first clause: what follows explains it
    let left = left.and_then(|why| why.split(':').next());
    accepted.then(|| fate(&outcome, &record, left, holds))
}
