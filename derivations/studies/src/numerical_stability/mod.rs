//! Numerical stability: the one-step map of a method near a stable or unstable steady motion. A stable map near an unstable
//! motion is called phantom stability.
//!
//! # Overview
//! * [`methods`]: the stability functions, derived from the steps of the integrator;
//! * [`linear`]: the linearised motion near a steady one, exactly; `symbolic_linearisation`: its symbolic matrix;
//! * [`motions`]: the steady motions of a scene with their eigenvalues;
//! * [`chart`]: all methods for every such motion, with a verdict for every step size;
//! * [`measured_thresholds`]: the thresholds by runs, whose length [`threshold_run_length`] gives;
//! * [`oscillator`]: splittings for one mode, exactly; [`splittings`]: splittings near a motion, by the derivative of
//!   their step (`matrices`) at its fixed point ([`continuation`]), with the result in [`tested_steps`];
//! * [`bench_proof`]: proofs for all step sizes of an interval on a bench, where all sub-flows (`subflows`) have the
//!   equilibrium;
//! * [`gyrostat_proof`]: such proofs near a gyrostat's motions, on the `casimir_leaf` of the integrals
//!   (`gyrostat_step`), or [`reasons`] against;
//! * `multipliers`: whether multipliers leave the unit circle, over a range of step sizes; [`step_intervals`]: its
//!   subdivision;
//! * [`oscillation`]: frequencies of a linear motion, and displacements along each mode;
//! * [`survey`]: the motions of the report with all of these results.

pub mod bench_proof;
mod casimir_leaf;
pub mod chart;
pub mod continuation;
pub mod gyrostat_proof;
mod gyrostat_step;
pub mod linear;
mod matrices;
pub mod measured_thresholds;
pub mod methods;
pub mod modes;
pub mod motions;
mod multipliers;
pub mod oscillation;
pub mod oscillator;
pub mod reasons;
pub mod splittings;
pub mod step_intervals;
mod subflows;
pub mod survey;
mod symbolic_linearisation;
pub mod tested_steps;
pub mod threshold_run_length;
