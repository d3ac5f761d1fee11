//! Constraint stabilisation methods compared for one mechanism: drift of the constraint, error of the motion, cost.
//!
//! # Overview
//! * `goal`: the motion, its exact solution, and errors of a run;
//! * `run`: one run of one treatment;
//! * `scan`: drift and error as functions of the gain;
//! * `timed`: computing times.

mod goal;
mod run;
mod scan;
mod timed;

pub use goal::{Goal, SPAN};
pub use run::Measured;
pub use scan::{Measure, Scan};
pub use timed::times;

use super::schemes::Scheme;
use integrators::Failure;
use run::Run;
use simulation::work_precision::Formulation;

/// The treatment of a constraint f = 0 in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Treatment {
    /// Lagrange's multipliers, f'' = 0, without stabilisation.
    IndexReduction,
    /// f'' = -b f' - k f with the gains of the fastest decay for the method and its step size.
    Fastest,
    /// f'' = -b f' - k f, critically damped with the rate [`MODERATE`] for every step size.
    Moderate,
    /// f'' = -b f' - k f, critically damped with the rate, 1/s, for which a scan found the smallest error of this
    /// method with this step size.
    MostAccurate { rate: f64 },
    /// Lagrange's multipliers; after each step the state is projected onto f = 0 and f' = 0, along the reactions.
    Projected,
    /// Gear, Gupta and Leimkuhler: multipliers for f = 0 and for f' = 0. Half-explicit methods correspond to the
    /// explicit ones, Radau IIA to backward Euler, projected Gauss to the midpoint rule.
    GearGuptaLeimkuhler,
    /// A minimal coordinate, in which the constraint holds identically.
    Minimal,
}

impl Treatment {
    /// All treatments that need no scan.
    pub const PLAIN: [Treatment; 6] = [
        Treatment::IndexReduction,
        Treatment::Fastest,
        Treatment::Moderate,
        Treatment::Projected,
        Treatment::GearGuptaLeimkuhler,
        Treatment::Minimal,
    ];

    /// The name in tables.
    pub fn name(self) -> String {
        match self {
            Treatment::IndexReduction => "index reduction".into(),
            Treatment::Fastest => "stabilised, fastest decay".into(),
            Treatment::Moderate => format!("stabilised, w = {MODERATE}/s"),
            Treatment::MostAccurate { rate } => format!("stabilised, least error: w = {rate:.2}/s"),
            Treatment::Projected => "projection, place and velocity".into(),
            Treatment::GearGuptaLeimkuhler => "Gear-Gupta-Leimkuhler".into(),
            Treatment::Minimal => "minimal coordinates".into(),
        }
    }
}

/// A line of the comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    pub scheme: Scheme,
    pub steps: u32,
    pub treatment: Treatment,
    /// `None` where the combination does not exist; a failure if the run failed.
    pub measured: Option<Result<Measured, Failure>>,
}

/// The decay rate of a violation with moderate gains, 1/s.
pub const MODERATE: f64 = Formulation::RATE;

/// Every method with a number of steps, and with twice as many.
pub const RUNS: [(Scheme, u32); 8] = [
    (Scheme::Euler, 20_000),
    (Scheme::Euler, 40_000),
    (Scheme::RungeKutta4, 1_000),
    (Scheme::RungeKutta4, 2_000),
    (Scheme::ImplicitMidpoint, 1_000),
    (Scheme::ImplicitMidpoint, 2_000),
    (Scheme::BackwardEuler, 2_000),
    (Scheme::BackwardEuler, 4_000),
];

/// Measures one treatment; `None` where the combination does not exist, a failure if the run failed.
pub fn measure(scheme: Scheme, steps: u32, treatment: Treatment, goal: &Goal) -> Option<Result<Measured, Failure>> {
    Run::new(scheme, steps, treatment).map(|run| run.measure(goal))
}

/// Measures one method with one step size and every treatment.
pub fn compare(scheme: Scheme, steps: u32, scan: &Scan, goal: &Goal) -> Vec<Line> {
    let mut treatments = Treatment::PLAIN.to_vec();
    treatments.splice(3..3, scan.best().map(|best| Treatment::MostAccurate { rate: best.rate }));
    let line = |treatment| Line { scheme, steps, treatment, measured: measure(scheme, steps, treatment, goal) };
    treatments.into_iter().map(line).collect()
}
