//! Scenes that are one initial value problem: what every command asks of them, whatever their family.

use crate::work_precision::{Configuration, Hybrid, Observed};
use crate::{Axes, Choice, Problem, Run, RunFailure, Trajectory};
use integrators::Reference;
use reader::Quantity;
use std::borrow::Cow;

/// A scene that is one initial value problem.
pub trait IvpScene: Send + Sync {
    fn title(&self) -> &str;
    /// What happens and why it is hard.
    fn description(&self) -> &str;
    /// The machine, or the mechanism.
    fn model(&self) -> &str;
    fn run(&self) -> &Run;
    /// In the axes of a form, where there are forms.
    fn problem(&self, axes: Axes) -> Problem;
    /// The same with the work metered that no law of the problem keeps, where there is such work.
    fn metered(&self, axes: Axes) -> Problem {
        self.problem(axes)
    }
    fn parameters(&self) -> Vec<Parameter>;
    /// Every formulation with every model, that of [`Self::problem`] in the first axes first.
    fn ways(&self) -> Vec<Configuration>;
    /// What is compared between them, with the sizes along the motion.
    fn observed(&self, reference: &Reference) -> Vec<Observed>;

    /// What a column of a run is, where its name does not say it.
    fn column(&self, _name: &str) -> Option<&'static Quantity> {
        None
    }

    /// The unit of a column of a run.
    fn unit(&self, name: &str) -> Cow<'static, str>;

    /// Whether columns have the names of the scene's file, so that their units alone tell what stands in one picture.
    fn has_own_names(&self) -> bool {
        false
    }

    /// The scene, where its law changes at events.
    fn hybrid(&self) -> Option<&dyn Hybrid> {
        None
    }

    /// What is known beside a run.
    fn told(&self, _choice: &Choice, _trajectory: &Trajectory) -> RunNotes {
        RunNotes::default()
    }
}

/// A datum for a reader.
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

/// What is said of a run beside its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RunNotes {
    /// What theory says without the run.
    pub theory: Vec<String>,
    /// Of one that ended early: the name of what happened.
    pub diagnosis: Option<String>,
    /// The ways in which it failed, found after it.
    pub failures: Vec<RunFailure>,
    /// The closed form's name, and the largest distance of the run's states from it, relative to their size.
    pub closed_form: Option<(&'static str, f64)>,
}
