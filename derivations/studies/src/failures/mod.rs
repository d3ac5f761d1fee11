//! The catalogue of failures of integration methods, each with its exact threshold by theory and the measured one.
//!
//! # Overview
//! * `entry`: one entry: scene, thresholds, the program's message, trials, remedy;
//! * `exact`: a threshold by theory: rational, algebraic or a formula;
//! * `bounds`: stability limits of the step size, as roots of equations for a method's one-step map;
//! * `edge`: bisection for a threshold; `at_a_parameter`: Newton's method at a fold, where it fails;
//! * `trials`: the result of every method on a scene with a budget; `slopes`: Jacobians of expensive laws; `slip`:
//!   friction with a given direction;
//! * `text_entry`: entries that are scenes with the table `[failure]`;
//! * one file for each entry, in the order of the list below.
//!
//! A theoretical threshold is computed exactly from the decimal data of the scene. The measured one comes from runs
//! only: by bisection between a successful and a failing run, which begins on both sides of the theoretical threshold.
//! The methods that succeed are determined by trials as well.

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

/// Whether a scene is used in the catalogue only.
pub fn is_own(scene: &Path) -> bool {
    scene.parent().is_some_and(|folder| folder.ends_with(text_entry::FOLDER))
}
