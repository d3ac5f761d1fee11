//! Runs compared with references, closed forms, other step sizes and other formulations.

mod beside;
mod closed_forms;
mod ensembles;
mod friction_forms;
#[path = "../physical/mod.rs"]
mod physical;
mod references;
mod splitting;
mod transition;
