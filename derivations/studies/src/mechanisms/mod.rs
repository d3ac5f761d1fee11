//! Mechanisms that scene files name: their data, states and energies by name; everything else about a scene is derived.
//!
//! # Overview
//! * [`mechanism`]: what a mechanism says of itself, and the law with its work that is made of it;
//! * [`rewritten`], [`points`], [`steered`]: other formulations of the same mechanism, for the atlas;
//! * [`scene`]: the family of scenes: reading, the problem, what theory says of a run;
//! * [`governors`], [`prescribed_top`]: the mechanisms; [`charted`]: what those in coordinates of their own share;
//! * `elastic`, [`crank_drive`]: what is known of systems as text beyond their equations.
//!
//! To add one: [`Mechanism`] for the system's data, and one line in the list below.

pub mod charted;
pub mod crank_drive;
mod elastic;
mod erased;
pub mod governors;
pub mod mechanism;
pub mod points;
pub mod prescribed_top;
pub mod rewritten;
pub mod scene;
pub mod steered;

pub use mechanism::{Amiss, Balanced, Diagnosis, Ended, Mechanism};
pub use scene::MechanismScene;

use erased::{Entry, entry};
use governors::{Discs, Drum, Programme};

/// Every mechanism by the name that scene files use.
pub const LIST: &[Entry] =
    &[entry::<Programme<Drum>>(), entry::<Programme<Discs>>(), entry::<prescribed_top::PrescribedTop<f64>>()];
