//! The cheapest method and form for a law at an error, by two pilot runs of each.
//!
//! The error of the coarser pilot is its distance from the finer; errors are taken to go with the tolerance, evaluations with
//! a power of it (those of Taylor's method grow less, and are then overrated). So the tolerance for an error and the cost
//! there are told before the run. Both are estimates.

use super::estimate::{INSTANTS, Watched};
use crate::scene::Axes;
use crate::scene::problem::Law;
use integrators::{Method, Record, Span, Tolerance, integrate};
use std::sync::Arc;

/// What is tried: one of each family that the atlas finds on its fronts.
const METHODS: [Method; 4] =
    [Method::DormandPrince8, Method::Taylor, Method::GraggBulirschStoer, Method::RadauIIA { stages: 5 }];
const PILOTS: [f64; 2] = [1e-4, 1e-6];
/// The finest tolerance that double precision leaves room for.
pub(super) const FINEST: f64 = 1e-13;
/// Evaluations of a pilot.
const PATIENCE: u64 = 50_000;

/// A law in a form, as rows of the scene's own outputs.
pub struct Runnable<'a> {
    pub axes: Axes,
    pub law: Arc<dyn Law>,
    pub start: Vec<f64>,
    pub span: f64,
    pub row: Box<Shown<'a>>,
}

/// The row of a time and a state.
pub type Shown<'a> = dyn Fn(f64, &[f64]) -> Vec<f64> + 'a;

/// How to run it.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    pub axes: Axes,
    pub method: Method,
    pub tolerance: f64,
    /// The method's own error, foretold.
    pub error: f64,
    /// Evaluations, foretold.
    pub foretold: f64,
    /// Evaluations that the pilots took.
    pub spent: u64,
}

/// A run of a plan.
#[derive(Clone, Debug)]
pub struct Run {
    pub rows: Vec<(f64, Vec<f64>)>,
    pub evaluations: u64,
}

impl Runnable<'_> {
    /// A run with rows at the instants; `None` where it does not reach its end.
    pub fn run(&self, method: Method, tolerance: f64, most: u64) -> (Option<Run>, u64) {
        let span = Span::new(0.0, self.span, &self.start).with_even_outputs(INSTANTS).with_evaluations(most);
        let mut record = Record::new();
        let outcome = integrate(&*self.law, method, &Tolerance::both(tolerance), &span, &mut record);
        let evaluations = outcome.work.rates + outcome.work.jacobians * self.start.len() as u64;
        let rows = record.times.iter().zip(&record.states).map(|(time, y)| (*time, (self.row)(*time, y)));
        let rows = outcome.reached().then(|| rows.collect());
        (rows.map(|rows| Run { rows, evaluations }), evaluations)
    }

    /// The plan for an error by one method; the pilots that did not reach their end leave none.
    fn plan(&self, method: Method, watched: &Watched, error: f64, spent: &mut u64) -> Option<Plan> {
        let [coarse, fine] = PILOTS.map(|tolerance| {
            let (run, evaluations) = self.run(method, tolerance, PATIENCE);
            *spent += evaluations;
            run
        });
        let (coarse, fine) = (coarse?, fine?);
        let off = coarse.rows.iter().zip(&fine.rows).map(|((_, a), (_, b))| watched.off(a, b)).fold(1e-16, f64::max);
        let tolerance = (PILOTS[0] * error / off).clamp(FINEST, PILOTS[0]);
        let slope = (fine.evaluations as f64 / coarse.evaluations as f64).ln() / (PILOTS[0] / PILOTS[1]).ln();
        let foretold = coarse.evaluations as f64 * (PILOTS[0] / tolerance).powf(slope.max(0.0));
        let error = (off * tolerance / PILOTS[0]).max(1e-15);
        Some(Plan { axes: self.axes, method, tolerance, error, foretold, spent: 0 })
    }
}

/// Plans for an error, the cheapest foretold first, of every method in every form.
pub fn plans(forms: &[Runnable<'_>], watched: &Watched, error: f64) -> Vec<Plan> {
    let mut spent = 0;
    let mut found: Vec<Plan> = Vec::new();
    for form in forms {
        for method in METHODS {
            found.extend(form.plan(method, watched, error, &mut spent));
        }
    }
    found.iter_mut().for_each(|plan| plan.spent = spent);
    // a Taylor step is an expansion: its evaluations are dearer, and times decide between the best
    found.sort_by(|a, b| a.foretold.total_cmp(&b.foretold));
    found
}
