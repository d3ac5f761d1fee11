//! Constraint stabilisation under discretisation: stability regions of the gains, errors and cost.
//!
//! # Overview
//! * [`schemes`]: one step of a method on the equation of a violation, over any field;
//! * [`drive_law`], [`experiment`]: the electromechanical drive, run;
//! * [`drifting`]: a monitor that detects drift of a constraint;
//! * [`regions`], [`treatments`]: stability maps and comparison of treatments, measured.

pub mod bearable;
pub mod drifting;
pub mod drive_law;
pub mod experiment;
pub mod law;
pub mod regions;
pub mod schemes;
pub mod treatments;
