//! The smallest sufficient model: a hierarchy of models under a scene's own, what each step loses, and the choice.
//!
//! # Overview
//! * [`reduced_model`]: a smaller model within a richer one, as a lift and a law; its defect, exact where that vanishes;
//! * [`lumping`]: windings lumped without any loss, found and proved from the machine's laws; [`elimination`];
//! * [`currents`]: what stands for currents that are not followed, `slaved` the rungs of that; `resting`: of those that a supply
//!   feeds; `smaller`: other machines of the scene's data;
//! * [`motors`], [`models`]: the hierarchies of scenes;
//! * [`outputs`]: what of a run matters; [`sampled_run`]: runs at the instants at which that is seen;
//! * [`error_propagation`]: the error that the defect makes, carried by the richer law; [`estimate`]: its run;
//! * [`dual_weighted_error`]: the same by transition matrices, weighed for each output: where along the run an error comes from;
//! * [`switching`]: a smaller model on those stretches only; [`loss_weights`]: what weighs its losses;
//! * [`simplification`]: elements that a system as text does without, found in its equations; [`text_models`]: its models;
//! * [`run_rows`]: a run's rows at its steps; [`first_run`]: that of the scene's own model; [`plan`]: the cheapest method and form
//!   for a law; `trial`: its run with an error, `comparison`: smaller models beside that; [`choose`](mod@choose): the cheapest of
//!   any [`choose::Models`], as those of [`forms`] are, with its [`receipt`]; [`ReducedScene`]: a scene run by one of them.
//!
//! Key results: a step with a vanishing defect is exact, which is decided over expressions; of every other the error is
//! estimated to first order, with the second order beside it. Neither is a bound; [`lumping::merged_at_most`] is one.

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

/// What a step down loses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Loss {
    /// It is the scene's own model.
    Own,
    /// Nothing: proved here for these data, and for all of them by this claim of the ledger, where there is one.
    Nothing { claim: Option<&'static str> },
    /// Something, that is small where this is.
    Small { parameter: &'static str },
}

/// A model under the scene's own.
pub struct ReducedModel {
    pub name: &'static str,
    /// In words, against the reduced model above.
    pub dropped: String,
    pub loss: Loss,
    pub lower: Lower,
    pub law: Arc<dyn Law>,
    pub start: Vec<f64>,
    /// The outputs that a run of the scene with the machine of this name shows as they are meant here: none of a model that is
    /// no machine, whose run shows all.
    pub shows: Vec<String>,
    /// The value of the small parameter at a state with its rates, where it has one there.
    pub small: Option<Box<Small>>,
    lift: Program,
}

/// A value at (z, z').
pub type Small = dyn Fn(&[f64], &[f64]) -> Option<f64> + Send + Sync;
/// The scene's own state at a time, from that of the law that the reduced models are derived from.
pub type Whole = dyn Fn(f64, &[f64]) -> Vec<f64> + Send + Sync;

/// The models of a scene, from the largest.
pub struct Hierarchy {
    /// The name of the scene's own model.
    pub model: String,
    /// The scene's own.
    pub own: Problem,
    /// The law that the reduced models are derived from: the scene's own, or the exact one next to it.
    pub written: Arc<dyn SymbolicLaw>,
    /// The same as it runs.
    pub law: Arc<dyn Law>,
    pub start: Vec<f64>,
    pub whole: Box<Whole>,
    pub rungs: Vec<ReducedModel>,
    /// How windings were lumped, where they were.
    pub lumping: Option<Lumping>,
}

impl ReducedModel {
    /// With its law as straight-line code; `None` where it cannot be recorded.
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

    /// The state of the richer law: Y(t, z).
    pub fn lifted(&self, time: f64, z: &[f64], states: usize) -> Vec<f64> {
        let mut y = vec![f64::NAN; states];
        // where it was recorded it runs, and what it does not write is no number
        let _ = self.lift.run(time, z, &mut y);
        y
    }

    /// Whether it is a machine whose run shows these outputs.
    pub fn shows_all(&self, names: &[String]) -> bool {
        !self.shows.is_empty() && names.iter().all(|name| self.shows.contains(name))
    }

    /// Whether it loses nothing.
    pub fn is_exact(&self) -> bool {
        !matches!(self.loss, Loss::Small { .. })
    }
}

impl Hierarchy {
    /// Why the law of the scene does not hold at a state of the law that the reduced models are derived from, where it does not.
    pub fn left(&self, time: f64, state: &[f64]) -> Option<&'static str> {
        self.own.outside(time, &(self.whole)(time, state))
    }

    /// The row of a run, from a state of the law that the reduced models are derived from.
    pub fn row(&self, time: f64, state: &[f64]) -> Vec<f64> {
        (self.own.row)(time, &(self.whole)(time, state))
    }

    /// The reduced models as ways of an atlas, each with a law of its own.
    pub fn ways(self: &Arc<Self>, formulation: Formulation) -> Vec<Configuration> {
        let way = |(at, rung): (usize, &ReducedModel)| {
            let ladder = Arc::clone(self);
            let states = self.start.len();
            let row = move |time: f64, z: &[f64]| ladder.row(time, &ladder.rungs[at].lifted(time, z, states));
            Configuration {
                formulation,
                model: rung.name,
                standing: if rung.is_exact() { Standing::Exact } else { Standing::Approximate },
                law: Treated::Free(Arc::clone(&rung.law)),
                state: rung.start.clone(),
                sizes: Vec::new(),
                columns: self.own.columns.clone(),
                row: Box::new(row),
            }
        };
        self.rungs.iter().enumerate().map(way).collect()
    }
}
