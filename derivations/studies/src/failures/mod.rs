//! The catalogue of failure: every way in which methods fail here, theory's exact threshold beside the measured one.
//!
//! # Overview
//! * `entry`: what is said of one way: its scene, thresholds, what the program says of it, what survives, advice;
//! * `exact`: a threshold as theory has it, rational, algebraic or a formula;
//! * `bounds`: the longest steps that a method bears, as roots of its own one-step map;
//! * `edge`: where a run ceases to hold, by halving; `at_a_parameter`: Newton's method, and how it is lost;
//! * `trials`: every method on a scene under a budget, and what became of each; `slopes`: Jacobians of dear laws; `slip`: friction
//!   whose direction is given;
//! * `text_entry`: ways that are scenes with the table `[failure]`;
//! * one file for each way, in the order of the list below.
//!
//! A threshold by theory is computed from the scene's decimals, exactly; the measured one comes from runs alone: by halving
//! between one that holds and one that does not, begun on both sides of theory's. What survives is not written down either: it
//! is what held in the trials.

mod at_a_parameter;
mod bounds;
mod edge;
mod entry;
mod exact;
mod slip;
mod slopes;
mod text_entry;
mod trials;

mod angles;
mod blow_up;
mod drift;
mod forms;
mod gains;
mod inclination;
mod painleve;
mod pull_out;
mod reversal;
mod sleeping;
mod straightening;
mod turning;
mod windings;

pub use entry::{Failing, Found, NotFound, Threshold, Within};
pub use exact::Exact;
pub use text_entry::{measure_text, text_entries, text_entry};
pub use trials::{Fate, Trial};

use std::path::Path;

/// Every way, in the order in which they are told.
pub const ALL: &[Failing] = &[
    windings::FAILING,
    turning::FAILING,
    drift::FAILING,
    forms::FAILING,
    angles::FAILING,
    pull_out::FAILING,
    painleve::FAILING,
    reversal::FAILING,
    straightening::FAILING,
    blow_up::FAILING,
    inclination::FAILING,
    sleeping::FAILING,
    gains::FAILING,
];

/// Whether a scene is here for the catalogue alone.
pub fn is_own(scene: &Path) -> bool {
    scene.parent().is_some_and(|folder| folder.ends_with(text_entry::FOLDER))
}
