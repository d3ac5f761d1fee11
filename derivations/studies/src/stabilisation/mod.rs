//! Constraint stabilisation with discrete time steps: stability regions of the gains, errors and cost.
//!
//! # Overview
//! * [`schemes`]: one step of a method for the equation of a violation, over any scalar type;
//! * [`drive_law`], [`experiment`]: runs of the electromechanical drive;
//! * [`drifting`]: a monitor that detects drift of a constraint;
//! * [`regions`], [`treatments`]: stability maps and a comparison of treatments, measured.

pub mod bearable;
pub mod drifting;
pub mod drive_law;
pub mod experiment;
pub mod law;
pub mod regions;
pub mod schemes;
pub mod treatments;
