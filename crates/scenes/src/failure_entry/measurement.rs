//! Runs of a catalogue entry with one number varied.

use super::{FailureEntry, MARGIN, Varied};
use crate::scene::ModelScene;
use simulation::{Axes, Choice, IvpScene, Problem, RunFailure, Trajectory};
use std::ops::ControlFlow;

/// A run of an entry.
pub struct TriedEntry {
    /// Whether it holds.
    pub holds: bool,
    /// All failures of the run.
    pub failures: Vec<RunFailure>,
    /// The reason for which the run stopped early, where it did.
    pub stopped: Option<String>,
    /// The last law of the run, where its law changes.
    pub last_law: Option<String>,
}

impl FailureEntry {
    /// The run with a value of the number that is varied; none where there is no such scene, or where it is broken off.
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

    /// The problem with a value of the number that is varied, with what its scene chooses.
    pub fn problem(&self, value: f64) -> Option<(Problem, Choice)> {
        let scene = self.with(value)?;
        Some((scene.problem(Axes::First), scene.run.choice()))
    }

    /// Whether a row of the outputs keeps `while` positive.
    pub fn keeps_row(&self, names: &[String], row: &[f64]) -> bool {
        let place = names.iter().position(|name| name == MARGIN);
        place.is_none_or(|place| row[place] > 0.0)
    }

    fn keeps(&self, names: &[String], rows: &[Vec<f64>], trajectory: &Trajectory) -> bool {
        rows.iter().skip(1).chain([&trajectory.last]).all(|row| self.keeps_row(names, row))
    }

    /// The scene with a value of the number that is varied.
    fn with(&self, value: f64) -> Option<ModelScene> {
        let span = match &self.varies {
            Varied::Value(name) => return self.scene.varied(&[(name, value)]).ok(),
            Varied::Span => value,
            Varied::Step => value * f64::from(self.scene.run.method.steps()?),
        };
        Some(self.scene.with_span(span))
    }
}
