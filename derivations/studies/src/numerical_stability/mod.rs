//! Numerical stability: the map of a method's steps beside a motion that is stable, or is not. Growth that a map hides is called
//! phantom stability.
//!
//! # Overview
//! * `claims`: what a step makes of one mode, by method, proved;
//! * [`methods`]: the stability functions, derived from the steps that run;
//! * [`linear`]: the linear motion near a stationary one, exactly, as `written` down over symbols;
//! * [`motions`]: the stationary motions of a scene with their eigenvalues;
//! * [`chart`]: every method on every such motion, every step judged;
//! * [`measured_thresholds`]: the same thresholds by runs, each as long as [`threshold_run_length`] says it must be;
//! * [`oscillator`], [`splittings`]: compositions of flows, on one mode exactly, on a motion by their own step and what its matrix (`matrices`) tells ([`tested_steps`]), its motion [`continuation`] from short steps;
//! * [`bench_proof`]: the same for every step between two on a bench, where all pieces rest, proved from the `pieces` that run;
//! * [`gyrostat_proof`]: the same near a gyrostat's motions, on the `surface` of the integrals (`stepped` over it), about the motion of a splitting's own, or why not ([`reasons`]);
//! * `multipliers`: whether they leave the unit circle, over a range of steps; [`step_intervals`]: ranges, halved until that is known;
//! * [`oscillation`]: frequencies of a linear motion, and displacements along each;
//! * [`survey`]: some motions with all of this, for the report.

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
