//! Explicit methods.

pub(super) mod classical;
pub(super) mod dormand_prince;
pub(super) mod gragg;

pub use classical::{euler_step, runge_kutta_4_step};
