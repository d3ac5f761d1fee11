//! Theoretical knowledge of a system, attached to files that refer to it by name.
//!
//! A crate registers a [`Knowledge`]. A file with the key `known_as` then has its theory and its closed form in every
//! run, its diagnosis where a run ends early, and its margins. Other crates attach further items under the same name,
//! such as reduced models.
//!
//! ```
//! use dalembert_simulation::knowledge::{Knowledge, submit};
//!
//! submit! { Knowledge {
//!     name: "pendulum",
//!     summary: "a point on a thread",
//!     parameters: &["l", "g"],
//!     columns: &["phi"],
//!     theory: |scene, _| {
//!         let [l, g] = ["l", "g"].map(|name| scene.value(name).unwrap_or(f64::NAN));
//!         vec![format!("small swings take {:.6} s", std::f64::consts::TAU * (l / g).sqrt())]
//!     },
//!     ..Knowledge::EMPTY
//! } }
//! # fn main() {}
//! ```

pub use inventory::submit;

use crate::events::Margins;
use crate::models::Modelled;
use crate::{Choice, RunNotes, Trajectory};

/// Knowledge of a system besides its equations; [`Knowledge::EMPTY`] gives the fields that are left out.
#[derive(Debug)]
pub struct Knowledge {
    /// The name in files.
    pub name: &'static str,
    /// A summary in one line, for lists.
    pub summary: &'static str,
    /// The names of the parameters that it uses.
    pub parameters: &'static [&'static str],
    /// The names of the states and outputs that it uses.
    pub columns: &'static [&'static str],
    /// Scene files of which one must have equations equal to those of the file, with the file's parameters; otherwise
    /// the knowledge does not apply. An empty list accepts any equations.
    pub equations: &'static [&'static str],
    /// Theoretical sentences on the run, computed without it.
    pub theory: fn(&dyn Modelled, &Choice) -> Vec<String>,
    /// The event that ended a run early, if its last state or its method shows it.
    pub diagnosis: fn(&Ended<'_>) -> Option<Diagnosis>,
    /// The closed form of columns at a time (s), if known.
    pub closed_form: fn(&dyn Modelled, f64) -> Option<ClosedForm>,
    /// Margins of the validity of the law that its equations do not show; the second argument has the names of the
    /// states in order. A run that reaches such a boundary has stopped, whereas a run that ends with an event of its
    /// file has reached its end. Must not call [`IvpScene::problem`](crate::IvpScene::problem) on the scene, which
    /// calls this function.
    pub margins: fn(&dyn Modelled, &[String]) -> Option<Box<Margins>>,
}

/// A run that stopped, or that ended with an event before its span.
#[derive(Clone, Copy, Debug)]
pub struct Ended<'a> {
    pub scene: &'a dyn Modelled,
    pub choice: &'a Choice,
    pub trajectory: &'a Trajectory,
}

/// The diagnosed end of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// A sentence on the end, without full stop.
    pub what: String,
    /// The time of the end by the closed form, s.
    pub at: Option<f64>,
}

/// The closed form of columns at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    /// The name in the line `closed form` of a run.
    pub what: &'static str,
    /// The values, by column name.
    pub values: Vec<(&'static str, f64)>,
}

inventory::collect!(Knowledge);

/// All registered knowledge, sorted by name.
pub fn entries() -> Vec<&'static Knowledge> {
    let mut all: Vec<&Knowledge> = inventory::iter::<Knowledge>().collect();
    all.sort_by_key(|knowledge| knowledge.name);
    all
}

impl Knowledge {
    /// The default: no knowledge.
    pub const EMPTY: Self = Knowledge {
        name: "",
        summary: "",
        parameters: &[],
        columns: &[],
        equations: &[],
        theory: |_, _| Vec::new(),
        diagnosis: |_| None,
        closed_form: |_, _| None,
        margins: |_, _| None,
    };

    /// The notes on a run.
    pub fn told(&self, scene: &dyn Modelled, choice: &Choice, trajectory: &Trajectory) -> RunNotes {
        let ended = Ended { scene, choice, trajectory };
        let is_early = trajectory.has_begun() && ended.is_early();
        let diagnosis = is_early.then(|| (self.diagnosis)(&ended)).flatten();
        RunNotes {
            theory: (self.theory)(scene, choice),
            diagnosis: diagnosis.map(|diagnosis| diagnosis.sentence(trajectory.outcome.time)),
            closed_form: self.distance(scene, trajectory),
            failures: Vec::new(),
        }
    }

    /// The name of the closed form, and the largest relative distance of the rows from it; `None` where there is no
    /// closed form.
    fn distance(&self, scene: &dyn Modelled, trajectory: &Trajectory) -> Option<(&'static str, f64)> {
        let mut found: Option<(&'static str, f64)> = None;
        for (&time, row) in trajectory.times.iter().zip(&trajectory.rows) {
            let Some(ClosedForm { what, values }) = (self.closed_form)(scene, time) else { continue };
            let off = |(name, exact): (&str, f64)| {
                let value = trajectory.column(name).map_or(f64::NAN, |place| row[place]);
                (exact - value).abs() / exact.abs().max(f64::MIN_POSITIVE)
            };
            let before = found.map_or(0.0, |(_, largest)| largest);
            found = Some((what, values.into_iter().map(off).fold(before, larger)));
        }
        found
    }
}

/// The larger of two numbers; NaN where one of them is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

impl Ended<'_> {
    fn is_early(&self) -> bool {
        self.trajectory.stopped().is_some() || self.trajectory.ends_before(self.span())
    }

    /// The requested span of the run, s.
    pub fn span(&self) -> f64 {
        self.scene.run().span
    }

    /// The time of the last valid state, s.
    pub fn time(&self) -> f64 {
        self.trajectory.outcome.time
    }

    /// A column at the last valid state; NaN where there is no such column.
    pub fn last(&self, column: &str) -> f64 {
        self.trajectory.column(column).map_or(f64::NAN, |place| self.trajectory.last[place])
    }

    /// Whether the validity of the law has ended, at a margin or at an event that ends the run.
    pub fn has_left_its_law(&self) -> bool {
        self.trajectory.left.is_some() || self.trajectory.ends_before(self.span())
    }

    /// Whether a time (s) lies within the step that failed; only for methods with constant steps.
    pub fn was_before(&self, end: f64) -> bool {
        self.choice.method.steps().is_some_and(|steps| self.time() + self.span() / f64::from(steps) >= end)
    }
}

impl Diagnosis {
    /// The sentence, with the difference between the last valid time and that of the closed form.
    fn sentence(self, time: f64) -> String {
        let Diagnosis { what, at } = self;
        match at {
            None => what,
            Some(at) => format!(
                "{what}; by the closed form at t = {at:.12} s, the run's last good state is {:.1e} s from it",
                (time - at).abs()
            ),
        }
    }
}
