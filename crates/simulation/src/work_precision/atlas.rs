//! Work-precision results of a scene: runs of all formulations by all methods, with errors, work and times.

use super::configuration::{Configuration, Standing, Treated};
use super::measured::Trials;
use crate::problem::Row;
use integrators::{Attempt, Benchmark, Method, Point, Record, Reference, Timed, Tolerance, judge, measure};
use std::time::{Duration, Instant};

/// A quantity that is compared between configurations, with its size along the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    pub name: String,
    pub size: f64,
}

/// The exact motion, in the compared quantities.
#[derive(Clone, Debug)]
pub struct Goal {
    pub observed: Vec<Observed>,
    times: Vec<f64>,
    rows: Vec<Vec<f64>>,
}

impl Goal {
    /// The exact motion from a reference of the scene's own problem, whose rows have these columns.
    pub fn of(columns: &[String], shown: &Row, reference: &Reference, observed: Vec<Observed>) -> Self {
        let places = places(&observed, columns);
        let row = |(time, state): (&f64, &Vec<field::DoubleDouble>)| {
            let state: Vec<f64> = state.iter().map(|y| y.hi()).collect();
            let row = shown(*time, &state);
            places.iter().map(|place| place.map_or(f64::NAN, |place| row[place])).collect()
        };
        let rows = reference.times.iter().zip(&reference.states).map(row).collect();
        Goal { times: reference.times.clone(), rows, observed }
    }

    /// The largest error of a run of a configuration over the compared quantities that it has, each relative to its
    /// size; NaN where its output times differ.
    pub fn error(&self, way: &Configuration, record: &Record<f64>) -> f64 {
        if record.times != self.times {
            return f64::NAN;
        }
        let places = places(&self.observed, &way.columns);
        let at = |(goal, (time, state)): (&Vec<f64>, (&f64, &Vec<f64>))| {
            let row = (way.row)(*time, state);
            let compared = goal.iter().zip(&self.observed).zip(&places);
            compared
                .filter_map(|((goal, observed), place)| Some((row[(*place)?] - goal).abs() / observed.size))
                .fold(0.0, f64::max)
        };
        self.rows.iter().zip(record.times.iter().zip(&record.states)).map(at).fold(0.0, f64::max)
    }
}

/// The indices of the quantities in a row.
fn places(observed: &[Observed], columns: &[String]) -> Vec<Option<usize>> {
    observed.iter().map(|one| columns.iter().position(|name| *name == one.name)).collect()
}

/// The runs of a configuration.
pub struct Explored {
    pub way: Configuration,
    pub points: Vec<Point>,
    /// The error of the model itself, from an accurate run; `None` where the configuration is exact, or there is no
    /// such run.
    pub floor: Option<f64>,
}

/// The runs of all formulations of a scene by all methods, and their reference.
pub struct Atlas {
    pub reference: Reference,
    pub explored: Vec<Explored>,
    span: f64,
}

impl Atlas {
    /// Runs every configuration by every method at every tolerance, without timing, so that several scenes can run in
    /// parallel. The reference belongs to the first configuration.
    pub fn judged(ways: Vec<Configuration>, reference: Reference, goal: &Goal, span: f64, trials: &Trials) -> Self {
        let end = Instant::now() + trials.allowed;
        let mut explored = Vec::new();
        for (place, mut way) in ways.into_iter().enumerate() {
            let left = end.saturating_duration_since(Instant::now());
            way.measure_itself(span, (place == 0).then_some(&reference));
            explored.push(explore(way, goal, span, trials, left));
        }
        Atlas { reference, explored, span }
    }

    /// Times all runs that reached their end. Nothing else should run meanwhile.
    pub fn take_times(&mut self, trials: &Trials, allowed: Duration) {
        let spans: Vec<_> = self.explored.iter().map(|one| one.way.span(self.span, trials.evaluations)).collect();
        let (mut runs, mut places) = (Vec::new(), Vec::new());
        for (at, (one, span)) in self.explored.iter().zip(&spans).enumerate() {
            let attempts = one.way.attempts(trials);
            for (place, point) in one.points.iter().enumerate() {
                let attempt = attempts.iter().find(|attempt| attempt.means() == point.means);
                let (Ok(error), Some(attempt)) = (&point.error, attempt) else { continue };
                let tolerance = Tolerance::scaled(point.tolerance.unwrap_or(f64::EPSILON), &one.way.sizes);
                runs.push(Timed { attempt: *attempt, span, tolerance, error: *error, evaluations: point.evaluations });
                places.push((at, place));
            }
        }
        let times = measure(&runs, allowed);
        for ((at, place), time) in places.into_iter().zip(times) {
            self.explored[at].points[place].time = time;
        }
    }

    /// All runs, with their configurations.
    pub fn points(&self) -> impl Iterator<Item = (&Configuration, &Point)> {
        self.explored.iter().flat_map(|one| one.points.iter().map(move |point| (&one.way, point)))
    }
}

/// Tolerances below this fraction of the error of a model are not tried.
const BELOW_FLOOR: f64 = 1e-3;

fn explore(way: Configuration, goal: &Goal, span: f64, trials: &Trials, allowed: Duration) -> Explored {
    let from = way.span(span, trials.evaluations);
    let error = |record: &Record<f64>| goal.error(&way, record);
    let course = Benchmark { span: &from, sizes: &way.sizes, error: &error };
    let (mut floor, mut tolerances) = (None, trials.tolerances.clone());
    if let (Standing::Approximate, Treated::Free(law)) = (way.standing, &way.law) {
        let accurate = |method| {
            let found = judge(&[Attempt::Integrated(&**law, method)], &course, &[ACCURATE], allowed / 4);
            found.into_iter().find_map(|point| point.error.ok())
        };
        floor = accurate(Method::DormandPrince8).or_else(|| accurate(Method::RadauIIA { stages: 5 }));
        let enough = floor.unwrap_or(0.0) * BELOW_FLOOR;
        tolerances.retain(|tolerance| *tolerance >= enough.min(trials.tolerances[0]));
    }
    let points = judge(&way.attempts(trials), &course, &tolerances, allowed);
    Explored { way, points, floor }
}

/// The tolerance of the run that gives the error of a model.
const ACCURATE: f64 = 1e-10;
