//! The catalogue of failure: the ways in which integration methods fail, each with its exact threshold by theory and the measured one.
//!
//! # Overview
//! * `entry`: one entry: scene, thresholds, the program's message, trials, remedy;
//! * `exact`: a threshold by theory, rational, algebraic or a formula;
//! * `bounds`: stability limits of the step size, as roots of a method's one-step map;
//! * `edge`: bisection for a threshold; `at_a_parameter`: Newton's method at a fold, where it fails;
//! * `trials`: every method on a scene under a budget, with its fate; `slopes`: Jacobians of expensive laws; `slip`: friction
//!   in a given direction;
//! * `text_entry`: entries that are scenes with the table `[failure]`;
//! * one file for each entry, in the order of the list below.
//!
//! A threshold by theory is computed from the scene's decimals, exactly. The measured one comes from runs alone: by bisection
//! between a run that holds and one that does not, begun on both sides of the threshold by theory. The methods that survive are
//! found by trials too.

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

/// Every entry, in the order of the catalogue.
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

/// Whether a scene serves the catalogue alone.
pub fn is_own(scene: &Path) -> bool {
    scene.parent().is_some_and(|folder| folder.ends_with(text_entry::FOLDER))
}
