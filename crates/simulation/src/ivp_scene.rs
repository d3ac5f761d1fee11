//! Scenes that are one initial value problem: the interface that every command uses, whatever the family.

use crate::work_precision::{Configuration, Hybrid, Observed};
use crate::{Axes, Choice, Problem, Run, RunFailure, Trajectory};
use integrators::Reference;
use reader::Quantity;
use std::borrow::Cow;

/// A scene that is one initial value problem.
pub trait IvpScene: Send + Sync {
    fn title(&self) -> &str;
    /// The motion that the scene shows, and its difficulty.
    fn description(&self) -> &str;
    /// The name of the machine, or of the mechanism.
    fn model(&self) -> &str;
    fn run(&self) -> &Run;
    /// The problem, in the axes of a form where there are several forms.
    fn problem(&self, axes: Axes) -> Problem;
    /// The problem with work metered that no law of it keeps, where there is such work.
    fn metered(&self, axes: Axes) -> Problem {
        self.problem(axes)
    }
    fn parameters(&self) -> Vec<Parameter>;
    /// Every formulation with every model, that of [`Self::problem`] in the first axes first.
    fn ways(&self) -> Vec<Configuration>;
    /// The quantities compared between them, with their sizes along the motion.
    fn observed(&self, reference: &Reference) -> Vec<Observed>;

    /// The meaning of a column of a run, where its name does not say it.
    fn column(&self, _name: &str) -> Option<&'static Quantity> {
        None
    }

    /// The unit of a column of a run.
    fn unit(&self, name: &str) -> Cow<'static, str>;

    /// Whether columns have the names of the scene's file: their units alone then decide which of them share a picture.
    fn has_own_names(&self) -> bool {
        false
    }

    /// The scene, where its law changes at events.
    fn hybrid(&self) -> Option<&dyn Hybrid> {
        None
    }

    /// Notes on a run beside its numbers.
    fn told(&self, _choice: &Choice, _trajectory: &Trajectory) -> RunNotes {
        RunNotes::default()
    }
}

/// A parameter with its value, for a reader.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    pub name: Cow<'static, str>,
    pub value: String,
    /// Empty for a pure number.
    pub unit: Cow<'static, str>,
    pub meaning: Cow<'static, str>,
}

impl Parameter {
    /// A quantity with its value.
    pub fn of(quantity: &Quantity, value: f64) -> Self {
        let Quantity { name, unit, meaning, .. } = quantity.clone();
        Parameter { name, value: value.to_string(), unit: if unit == "1" { "".into() } else { unit }, meaning }
    }
}

/// Notes on a run beside its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RunNotes {
    /// Theoretical results that need no run.
    pub theory: Vec<String>,
    /// For a run that ended early: the name of the event that ended it.
    pub diagnosis: Option<String>,
    /// The failures of the run, found after it.
    pub failures: Vec<RunFailure>,
    /// The closed form's name, and the largest distance of the run's states from it, relative to their size.
    pub closed_form: Option<(&'static str, f64)>,
}
