//! Model reduction: a hierarchy of reduced models of a scene, their errors, and the choice of the cheapest sufficient
//! one.
//!
//! # Overview
//! * [`reduced_model`]: a reduced model of a full one, as a lift and a law; its defect, which vanishes for an exact
//!   reduction;
//! * [`lumping`]: exact lumping of windings, found and proved from the machine's laws; [`elimination`]: its linear algebra;
//! * [`currents`]: quasi-steady values of currents, `quasi_steady` the models with them; `steady_currents`: the model of windings
//!   with a supply; `smaller_machines`: smaller motor models of the scene's data;
//! * [`motors`], [`models`]: the hierarchies of scenes;
//! * [`outputs`]: the outputs of interest; [`sampled_run`]: runs at the instants at which errors are measured;
//! * [`error_propagation`]: the error equation, driven by the defect; [`estimate`]: the error estimate from its run;
//! * [`dual_weighted_error`]: the error by transition matrices, weighted for each output, with its sources along the run;
//! * [`switching`]: a reduced model on a part of the run; [`loss_weights`]: the transition matrices that weight its losses;
//! * [`simplification`]: elements that a text model can do without, found in its equations; [`text_models`]: its models;
//! * [`run_rows`]: a run's rows at its steps; [`first_run`]: that of the scene's own model; [`plan`]: the cheapest method and form
//!   for a law; `trial`: its run with an error, `comparison`: reduced models against that; [`choose`](mod@choose): the cheapest of
//!   any [`choose::Models`], such as those of [`forms`], with its [`receipt`]; [`ReducedScene`]: a scene run by one of them.
//!
//! A reduction with a vanishing defect is exact; this is decided symbolically. For all others the error is estimated to
//! first order, together with the second order. Neither is a bound; [`lumping::merged_at_most`] is one.

pub mod choose;
mod comparison;
pub mod currents;
pub mod dual_weighted_error;
pub mod elimination;
pub mod error_propagation;
pub mod estimate;
pub mod first_run;
pub mod forms;
pub mod loss_weights;
pub mod lumping;
pub mod models;
pub mod motors;
pub mod outputs;
pub mod plan;
mod quasi_steady;
pub mod receipt;
pub mod reduced_model;
mod reduced_scene;
pub mod run_rows;
pub mod sampled_run;
pub mod simplification;
mod smaller_machines;
mod steady_currents;
pub mod switching;
pub mod text_models;
mod trial;

pub use choose::{Models, choose};
pub use estimate::Estimate;
pub use forms::Forms;
pub use lumping::{Lumped, Lumping};
pub use plan::Plan;
pub use receipt::{Choice, Line, Receipt, Sufficiency, Wish};
pub use reduced_model::Lower;
pub use reduced_scene::ReducedScene;
pub use simplification::{Simplification, SimplifiedScene};
pub use text_models::TextModels;

use simulation::work_precision::{Configuration, Formulation, Standing, Treated};
use simulation::{Law, Problem, Program, SymbolicLaw};
use std::sync::Arc;

/// The error class of a reduced model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Loss {
    /// The scene's own model.
    Own,
    /// Exact: proved for these data, and for all data by this claim of the ledger, if there is one.
    Nothing { claim: Option<&'static str> },
    /// Approximate: the error is small where this parameter is.
    Small { parameter: &'static str },
}

/// A reduced model of a scene.
pub struct ReducedModel {
    pub name: &'static str,
    /// The neglected parts, in words, compared with the model above.
    pub dropped: String,
    pub loss: Loss,
    pub lower: Lower,
    pub law: Arc<dyn Law>,
    pub start: Vec<f64>,
    /// The outputs that a run of the scene with the machine of this name shows with equal meaning; empty for a model
    /// that is no machine, whose run shows all.
    pub shows: Vec<String>,
    /// The value of the small parameter at a state with its rates, where defined.
    pub small: Option<Box<Small>>,
    lift: Program,
}

/// A value as a function of (z, z').
pub type Small = dyn Fn(&[f64], &[f64]) -> Option<f64> + Send + Sync;
/// The map from time and a state of the law from which the reduced models are derived to the scene's own state.
pub type Whole = dyn Fn(f64, &[f64]) -> Vec<f64> + Send + Sync;

/// The models of a scene, from the largest.
pub struct Hierarchy {
    /// The name of the scene's own model.
    pub model: String,
    /// The scene's own problem.
    pub own: Problem,
    /// The problem that a run of the scene solves, where it has the work of loads as a state too.
    pub metered: Option<Problem>,
    /// The law from which the reduced models are derived: the scene's own, or that with lumped windings.
    pub written: Arc<dyn SymbolicLaw>,
    /// The compiled form of `written`.
    pub law: Arc<dyn Law>,
    pub start: Vec<f64>,
    pub whole: Box<Whole>,
    pub models: Vec<ReducedModel>,
    /// The lumping of the windings, if there is one.
    pub lumping: Option<Lumping>,
}

impl ReducedModel {
    /// A reduced model with its law as straight-line code; `None` where it cannot be recorded.
    pub fn new(name: &'static str, dropped: &str, loss: Loss, lower: Lower, start: Vec<f64>) -> Option<Self> {
        let lift = Program::of(lower.dimension, |time, z| (lower.lift)(time, z))?;
        let law = lower.law()?;
        Some(ReducedModel {
            name,
            dropped: dropped.to_owned(),
            loss,
            lower,
            law,
            start,
            shows: Vec::new(),
            small: None,
            lift,
        })
    }

    /// The state of the full law: Y(t, z).
    pub fn lifted(&self, time: f64, z: &[f64], states: usize) -> Vec<f64> {
        let mut y = vec![f64::NAN; states];
        // states that the program does not write stay NaN
        let _ = self.lift.run(time, z, &mut y);
        y
    }

    /// Whether the model is a machine whose run shows these outputs.
    pub fn shows_all(&self, names: &[String]) -> bool {
        !self.shows.is_empty() && names.iter().all(|name| self.shows.contains(name))
    }

    /// Whether the model is exact.
    pub fn is_exact(&self) -> bool {
        !matches!(self.loss, Loss::Small { .. })
    }
}

impl Hierarchy {
    /// The problem that a run of the scene solves.
    pub fn of_run(&self) -> &Problem {
        self.metered.as_ref().unwrap_or(&self.own)
    }

    /// The reason why the scene's law is invalid at a state of `written`, if it is.
    pub fn left(&self, time: f64, state: &[f64]) -> Option<&'static str> {
        self.own.outside(time, &(self.whole)(time, state))
    }

    /// The row of outputs from a state of `written`.
    pub fn row(&self, time: f64, state: &[f64]) -> Vec<f64> {
        (self.own.row)(time, &(self.whole)(time, state))
    }

    /// The reduced models as configurations for a work-precision study, each with its own law.
    pub fn ways(self: &Arc<Self>, formulation: Formulation) -> Vec<Configuration> {
        let way = |(at, reduced): (usize, &ReducedModel)| {
            let ladder = Arc::clone(self);
            let states = self.start.len();
            let row = move |time: f64, z: &[f64]| ladder.row(time, &ladder.models[at].lifted(time, z, states));
            Configuration {
                formulation,
                model: reduced.name,
                standing: if reduced.is_exact() { Standing::Exact } else { Standing::Approximate },
                law: Treated::Free(Arc::clone(&reduced.law)),
                state: reduced.start.clone(),
                sizes: Vec::new(),
                columns: self.own.columns.clone(),
                row: Box::new(row),
            }
        };
        self.models.iter().enumerate().map(way).collect()
    }
}
