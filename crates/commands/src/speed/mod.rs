//! Errors and costs of all methods on one scene: pictures, Pareto fronts as tables, advice.
//!
//! # Overview
//! * [`Series`]: the runs of one method on one formulation with one model;
//! * [`Counted`]: the measure of the cost of a run;
//! * [`pictures`], [`tables`], [`advice`].

pub mod advice;
pub mod pictures;
pub mod tables;

use integrators::{Index2Method, Means, Method, Point, Trial};
use simulation::Atlas;
use simulation::work_precision::{Configuration, Standing};

/// The measure of the cost of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counted {
    Evaluations,
    /// The measured time in seconds.
    Time,
}

impl Counted {
    pub const ALL: [Counted; 2] = [Counted::Evaluations, Counted::Time];

    pub fn name(self) -> &'static str {
        match self {
            Counted::Evaluations => "evaluations",
            Counted::Time => "time",
        }
    }

    /// The cost of a run; NaN where it was not measured.
    pub fn of(self, point: &Point) -> f64 {
        match self {
            Counted::Evaluations => point.evaluations as f64,
            Counted::Time => point.time.map_or(f64::NAN, |time| time.seconds),
        }
    }
}

/// The largest relative error of a useful result; runs with a larger error are on no Pareto front.
pub const ANSWER: f64 = 0.1;

/// The runs of one method on one configuration.
pub struct Series<'a> {
    pub way: &'a Configuration,
    pub family: String,
    pub points: Vec<&'a Point>,
}

impl Series<'_> {
    /// The name in legends, such as `Taylor, second form, equivalent windings`.
    pub fn name(&self) -> String {
        let parts = [self.family.clone(), self.way.formulation.name().to_owned(), model(self.way)];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
    }

    /// The name in sentences, such as `Taylor in the second form with equivalent windings`.
    pub fn said(&self) -> String {
        let with = if self.way.model.is_empty() { String::new() } else { format!(" with {}", model(self.way)) };
        format!("{} {}{with}", self.family, self.way.formulation.said())
    }

    /// Whether the model is exact, or at least one run has an error that is small enough for a useful result.
    pub fn is_near(&self) -> bool {
        self.way.is_exact() || self.points.iter().any(|point| point.error.is_ok_and(|error| error <= ANSWER))
    }

    /// The costs and errors of the runs, for [`integrators::cost`].
    pub fn trials(&self, counted: Counted) -> Vec<Trial> {
        self.points.iter().map(|point| Trial { cost: counted.of(point), error: point.error.ok() }).collect()
    }
}

/// All series of an atlas, ordered by configuration.
pub fn series(atlas: &Atlas) -> Vec<Series<'_>> {
    let mut all: Vec<Series> = Vec::new();
    for explored in &atlas.explored {
        let first = all.len();
        for point in &explored.points {
            let family = family(point.means);
            match all[first..].iter_mut().find(|known| known.family == family) {
                Some(known) => known.points.push(point),
                None => all.push(Series { way: &explored.way, family, points: vec![point] }),
            }
        }
    }
    all
}

/// The name of the model in a configuration, with `(approximate)` or `(exact)` for a reduced model; empty for the model of the scene.
pub fn model(way: &Configuration) -> String {
    let name = way.model.replace('_', " ");
    match way.standing {
        Standing::Approximate => format!("{name} (approximate)"),
        Standing::Exact if !name.is_empty() => format!("{name} (exact)"),
        _ => name,
    }
}

/// The name of a method without its number of steps.
pub fn family(means: Means) -> String {
    match means {
        Means::Integrated(method) => of_method(method),
        Means::Held(Index2Method::HalfExplicitEuler { .. }) => "half-explicit Euler".to_owned(),
        Means::Held(Index2Method::HalfExplicitRungeKutta4 { .. }) => "half-explicit Runge-Kutta 4".to_owned(),
        Means::Held(Index2Method::RadauIIA { stages, .. }) => format!("Radau IIA, {stages} stages, constant step"),
        Means::Held(Index2Method::ProjectedGauss { stages, .. }) => format!("Gauss, {stages} stages, constant step"),
    }
}

fn of_method(method: Method) -> String {
    match method {
        Method::RungeKutta4 { .. } => "Runge-Kutta 4, constant step".to_owned(),
        Method::Euler { .. } => "Euler, constant step".to_owned(),
        Method::BackwardEuler { .. } => "backward Euler, constant step".to_owned(),
        Method::ImplicitMidpoint { .. } => "implicit midpoint, constant step".to_owned(),
        Method::Split { splitting, .. } => format!("{} splitting, constant step", splitting.name()),
        other => other.to_string(),
    }
}
