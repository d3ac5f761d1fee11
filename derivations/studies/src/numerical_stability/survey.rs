//! The survey of the report: motions of some scenes, with every method's thresholds by theory and by runs.

use super::chart::{Chart, Row};
use super::measured_thresholds::{Run, Runs};
use super::motions::Rotor;
use super::splittings::SplitRuns;
use super::tested_steps::Tested;
use super::threshold_run_length::Crossing;
use crate::scene::Scene;
use integrators::Splitting;

/// Scenes by file name, with the angular velocity of their motions about the vertical, rad/s.
pub const SCENES: [(&str, f64); 3] = [("permanent_rotation", 6.0), ("hanging_rest", 0.0), ("bench", 0.0)];

/// One motion.
#[derive(Clone, Debug)]
pub struct Surveyed {
    pub scene: String,
    /// The motion in words; `does` is its stability.
    pub motion: String,
    pub does: String,
    pub eigenvalues: String,
    pub methods: Vec<Method>,
    pub splittings: Vec<Split>,
}

/// A Runge-Kutta method with its thresholds (s), exactly and by runs; `None` where no run can measure them.
#[derive(Clone, Debug)]
pub struct Method {
    pub row: Row,
    pub edges: Vec<(f64, Option<f64>)>,
}

/// A splitting with its thresholds (s), by the derivative of its step and, if its fixed point is the law's motion, by
/// runs.
#[derive(Clone, Debug)]
pub struct Split {
    pub tested: Tested,
    pub edges: Vec<(f64, Option<f64>)>,
}

/// The step sizes at which splittings are tested, s: eight per decade.
pub fn steps() -> Vec<f64> {
    (-24..=0).map(|k| 10f64.powf(f64::from(k) / 8.0)).collect()
}

/// The motions of a scene: on a bench all of them, otherwise those with a restoring torque on the rotor.
///
/// # Errors
/// The reason why no motions are known, in words.
pub fn survey(scene: &Scene, w: f64) -> Result<Vec<Surveyed>, String> {
    let chart = Chart::of(scene, w).map_err(|reason| reason.to_string())?;
    let shown = chart
        .all
        .motions
        .iter()
        .zip(&chart.rows)
        .filter(|(motion, _)| motion.kind.is_none() || !matches!(motion.rotor, Rotor::InStep { held: false, .. }));
    let each = shown.filter_map(|(motion, rows)| {
        let spectrum = motion.spectrum.as_ref()?;
        let runs = Runs::near(scene, motion);
        let methods = rows.iter().map(|row| {
            let seen = |exact: f64, crossing| runs.threshold(Run::OneStep(row.method), exact, crossing);
            let crossing = |exact: f64| Crossing::of(row.method, spectrum, exact);
            let edge = |exact: f64| (exact, crossing(exact).and_then(|crossing| seen(exact, crossing)));
            Method { row: row.clone(), edges: row.edges().into_iter().map(|cut| edge(cut.to_f64())).collect() }
        });
        let near = SplitRuns::near(scene, motion);
        let splittings = Splitting::ALL.into_iter().map(|splitting| {
            let tested = near.course(splitting, &steps());
            let edge = |step: f64| {
                let crossing = near.crossing(splitting, step);
                (step, crossing.and_then(|crossing| runs.threshold(Run::Splitting(splitting), step, crossing)))
            };
            Split { edges: tested.edges.iter().map(|step| edge(*step)).collect(), tested }
        });
        Some(Surveyed {
            scene: scene.title.clone(),
            motion: motion.to_string(),
            does: super::chart::ChartedMotion::of(spectrum).to_string(),
            eigenvalues: chart.eigenvalues(spectrum),
            methods: methods.collect(),
            splittings: splittings.collect(),
        })
    });
    Ok(each.collect())
}
