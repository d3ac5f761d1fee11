//! Mechanical systems.

pub mod gyrostat;
