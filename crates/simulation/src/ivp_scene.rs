//! The interface of scenes that are initial value problems, used by every command.

use crate::work_precision::{Configuration, Hybrid, Observed};
use crate::{Axes, Choice, Problem, Run, RunFailure, Trajectory};
use integrators::Reference;
use reader::Quantity;
use std::borrow::Cow;

/// A scene that is an initial value problem.
pub trait IvpScene: Send + Sync {
    fn title(&self) -> &str;
    /// A description of the motion.
    fn description(&self) -> &str;
    /// The name of the machine, or of the mechanism.
    fn model(&self) -> &str;
    fn run(&self) -> &Run;
    /// The problem, in the given axes where the equations have several forms.
    fn problem(&self, axes: Axes) -> Problem;
    /// The problem with additional states for the work of nonconservative forces, where there are any.
    fn metered(&self, axes: Axes) -> Problem {
        self.problem(axes)
    }
    fn parameters(&self) -> Vec<Parameter>;
    /// Every combination of formulation and model; the first one is that of [`Self::problem`] in the first axes.
    fn ways(&self) -> Vec<Configuration>;
    /// The quantities that are compared between configurations, with their sizes along the motion.
    fn observed(&self, reference: &Reference) -> Vec<Observed>;

    /// The meaning of a column of a run, where its name is not self-explanatory.
    fn column(&self, _name: &str) -> Option<&'static Quantity> {
        None
    }

    /// The unit of a column of a run.
    fn unit(&self, name: &str) -> Cow<'static, str>;

    /// Whether columns have names from the scene's file: their units alone then decide which columns share a diagram.
    fn has_own_names(&self) -> bool {
        false
    }

    /// The scene as a hybrid system, if its law changes at events.
    fn hybrid(&self) -> Option<&dyn Hybrid> {
        None
    }

    /// Notes on a run besides its numbers.
    fn told(&self, _choice: &Choice, _trajectory: &Trajectory) -> RunNotes {
        RunNotes::default()
    }
}

/// A parameter with its value, for display.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    pub name: Cow<'static, str>,
    pub value: String,
    /// The unit; empty for a pure number.
    pub unit: Cow<'static, str>,
    pub meaning: Cow<'static, str>,
}

impl Parameter {
    /// The parameter of a quantity with its value.
    pub fn of(quantity: &Quantity, value: f64) -> Self {
        let Quantity { name, unit, meaning, .. } = quantity.clone();
        Parameter { name, value: value.to_string(), unit: if unit == "1" { "".into() } else { unit }, meaning }
    }
}

/// Notes on a run besides its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RunNotes {
    /// Theoretical results that do not depend on the run.
    pub theory: Vec<String>,
    /// For a run that ended early: a sentence on the event that ended it.
    pub diagnosis: Option<String>,
    /// The failures of the run, detected afterwards.
    pub failures: Vec<RunFailure>,
    /// The name of the closed form, and the largest relative distance of the run's states from it.
    pub closed_form: Option<(&'static str, f64)>,
}
