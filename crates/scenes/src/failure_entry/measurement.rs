//! Runs of an entry of the catalogue of failures, with one number varied.

use super::{FailureEntry, MARGIN, Varied};
use crate::scene::ModelScene;
use simulation::{Axes, Choice, IvpScene, Problem, RunFailure, Trajectory};
use std::ops::ControlFlow;

/// The result of one run of an entry.
pub struct TriedEntry {
    /// True if the run was complete, kept the condition `while`, and did not show the expected failure.
    pub holds: bool,
    /// All failures of the run.
    pub failures: Vec<RunFailure>,
    /// The reason for an early stop, if the run stopped early.
    pub stopped: Option<String>,
    /// A text on the last change of the law during the run: time (s), event, new law.
    pub last_law: Option<String>,
}

impl FailureEntry {
    /// Runs the entry with a value of the varied number. `None` if this value gives no scene, or `goes_on` stops the run.
    pub fn tried(&self, value: f64, goes_on: &dyn Fn() -> ControlFlow<()>) -> Option<TriedEntry> {
        let scene = self.with(value)?;
        let choice = scene.run.choice();
        let trajectory = scene.metered(Axes::First).simulate_while(&choice, |_| goes_on());
        if trajectory.broken_off() {
            return None;
        }
        let failures = scene.told(&choice, &trajectory).failures;
        let shows = self.expects.is_some_and(|kind| failures.iter().any(|failure| failure.kind == kind));
        let stopped = trajectory.stopped();
        let holds = stopped.is_none() && !shows && self.keeps(&trajectory.names, &trajectory.rows, &trajectory);
        let last_law = trajectory.passages.iter().rev().find_map(|passage| {
            let then = passage.then.as_ref().filter(|then| !then.is_empty())?;
            Some(format!("t = {:.9} s: {}: {then}", passage.time, passage.what))
        });
        Some(TriedEntry { holds, failures, stopped, last_law })
    }

    /// The problem with a value of the varied number, and the choices of its run; `None` if this value gives no scene.
    pub fn problem(&self, value: f64) -> Option<(Problem, Choice)> {
        let scene = self.with(value)?;
        Some((scene.problem(Axes::First), scene.run.choice()))
    }

    /// True if the condition `while` is positive in a row of outputs, or the entry has none.
    pub fn keeps_row(&self, names: &[String], row: &[f64]) -> bool {
        let place = names.iter().position(|name| name == MARGIN);
        place.is_none_or(|place| row[place] > 0.0)
    }

    fn keeps(&self, names: &[String], rows: &[Vec<f64>], trajectory: &Trajectory) -> bool {
        rows.iter().skip(1).chain([&trajectory.last]).all(|row| self.keeps_row(names, row))
    }

    /// The scene with a value of the varied number: a quantity, the time span (s), or the step size (s).
    fn with(&self, value: f64) -> Option<ModelScene> {
        let span = match &self.varies {
            Varied::Value(name) => return self.scene.varied(&[(name, value)]).ok(),
            Varied::Span => value,
            Varied::Step => value * f64::from(self.scene.run.method.steps()?),
        };
        Some(self.scene.with_span(span))
    }
}
