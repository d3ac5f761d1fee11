//! Knowledge of a system beyond its equations, attached to files that ask for it by name.
//!
//! A crate submits a [`Knowledge`]; a file with the key `known_as` has its theory in every run, its closed form beside the run, its
//! diagnosis where a run ends early, and its margins, which end one. Other crates attach more under the same name, such as smaller models.
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

/// The knowledge of a system beside its equations; [`Knowledge::EMPTY`] gives the fields that are left out.
#[derive(Debug)]
pub struct Knowledge {
    /// The name in files.
    pub name: &'static str,
    /// A summary in one line, for lists.
    pub summary: &'static str,
    /// The parameters that it reads, by their names in the file.
    pub parameters: &'static [&'static str],
    /// The states and outputs that it reads.
    pub columns: &'static [&'static str],
    /// Scene files of which one must give the same equations, with the parameters of the file that asks; the knowledge does not
    /// apply to other equations. An empty list accepts any equations.
    pub equations: &'static [&'static str],
    /// Sentences of theory on the run, without the run; its span is that of the scene.
    pub theory: fn(&dyn Modelled, &Choice) -> Vec<String>,
    /// The name of the event that ended a run early, where its last state or its method shows it.
    pub diagnosis: fn(&Ended<'_>) -> Option<Diagnosis>,
    /// Columns at a time, s, in closed form, where they are known.
    pub closed_form: fn(&dyn Modelled, f64) -> Option<ClosedForm>,
    /// The distance of a state from a boundary beyond which the law does not hold and which its equations do not show; the second argument
    /// has the names of the states in their order. A run that comes there has stopped, while one that an event of its file ends has reached
    /// its end. Must not call [`IvpScene::problem`](crate::IvpScene::problem) on the scene, which calls this function.
    pub margins: fn(&dyn Modelled, &[String]) -> Option<Box<Margins>>,
}

/// A run that stopped, or that an event ended before its span.
#[derive(Clone, Copy, Debug)]
pub struct Ended<'a> {
    pub scene: &'a dyn Modelled,
    pub choice: &'a Choice,
    pub trajectory: &'a Trajectory,
}

/// The end of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// The end in one sentence, without its full stop.
    pub what: String,
    /// The time of the end by the closed form, s.
    pub at: Option<f64>,
}

/// Values of columns at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    /// The name in the line `closed form` of a run.
    pub what: &'static str,
    /// The values by the names of the columns.
    pub values: Vec<(&'static str, f64)>,
}

inventory::collect!(Knowledge);

/// All knowledge of the crates in the program, by name.
pub fn entries() -> Vec<&'static Knowledge> {
    let mut all: Vec<&Knowledge> = inventory::iter::<Knowledge>().collect();
    all.sort_by_key(|knowledge| knowledge.name);
    all
}

impl Knowledge {
    /// No knowledge, under no name.
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

    /// The notes of this knowledge on a run.
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

    /// The closed form's name, with the largest relative distance of the rows from it; `None` where there is none at any instant.
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

    /// The span that the run was asked for, s.
    pub fn span(&self) -> f64 {
        self.scene.run().span
    }

    /// The time of the last good state, s.
    pub fn time(&self) -> f64 {
        self.trajectory.outcome.time
    }

    /// A column at the last good state; NaN where no column has the name.
    pub fn last(&self, column: &str) -> f64 {
        self.trajectory.column(column).map_or(f64::NAN, |place| self.trajectory.last[place])
    }

    /// True where the law has come to its end: at a margin, or at an event that ends the run.
    pub fn has_left_its_law(&self) -> bool {
        self.trajectory.left.is_some() || self.trajectory.ends_before(self.span())
    }

    /// Whether a time is within the step that could not be made, for methods with constant steps.
    pub fn was_before(&self, end: f64) -> bool {
        self.choice.method.steps().is_some_and(|steps| self.time() + self.span() / f64::from(steps) >= end)
    }
}

impl Diagnosis {
    /// The sentence, with the distance of the last good state from the time of the closed form.
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
