//! Stabilised constraints in steps.
//!
//! # Overview
//! * [`schemes`]: one step of a method on the law of violations, over any field;
//! * [`drive_law`], [`experiment`]: the electromechanical drive, run;
//! * [`drifting`]: a monitor that says by name that a constraint drifts;
//! * [`regions`], [`treatments`]: gains and treatments of a constraint, measured.

pub mod bearable;
pub mod drifting;
pub mod drive_law;
pub mod experiment;
pub mod law;
pub mod regions;
pub mod schemes;
pub mod treatments;
