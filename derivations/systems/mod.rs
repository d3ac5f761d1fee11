//! Mechanical systems.

pub mod gyrostat;
pub mod ladder;
pub mod rod;
pub mod steered_rod;
