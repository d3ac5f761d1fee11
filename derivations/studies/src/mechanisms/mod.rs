//! Mechanisms that scene files name: their data, states and energies by name; everything else about a scene is derived.
//!
//! # Overview
//! * [`mechanism`]: what a mechanism says of itself, and the law with its work that is made of it;
//! * [`rewritten`], [`points`], [`steered`]: other formulations of the same mechanism, for the atlas;
//! * [`scene`]: the family of scenes: reading, the problem, what theory says of a run;
//! * [`governors`], `elastic`, [`prescribed_top`], [`drive`]: the mechanisms; [`charted`]: what those in
//!   coordinates of their own share.
//!
//! To add one: [`Mechanism`] for the system's data, and one line in the list below.

pub mod charted;
pub mod drive;
mod erased;
pub mod mechanism;
mod reductions;
pub mod rewritten;
pub mod scene;

pub use mechanism::{Amiss, Balanced, Diagnosis, Ended, Mechanism};
pub use scene::MechanismScene;

use erased::{Entry, entry};

/// Every mechanism by the name that scene files use.
pub const LIST: &[Entry] = &[entry::<drive::Drive>()];
