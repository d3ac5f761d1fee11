//! Phantom stability: what the steps of a method make of a motion that is stable, or is not.
//!
//! # Overview
//! * `claims`: what a step makes of one mode, by method, proved;
//! * [`methods`]: the stability functions, derived from the steps that run;
//! * [`linear`]: the linear motion near a stationary one, exactly, as `written` down over symbols;
//! * [`motions`]: the stationary motions of a scene with their eigenvalues;
//! * [`chart`]: every method on every such motion, every step judged;
//! * [`measured`]: the same thresholds by runs, each as long as [`crossing`] says it must be;
//! * [`oscillator`], [`splittings`]: compositions of flows, on one mode exactly, on a motion by their own step and what its matrix (`matrices`) tells ([`tested`]), its motion [`followed`] from short steps;
//! * [`enclosed`]: the same for every step between two on a bench, where all pieces rest, proved from the `pieces` that run;
//! * [`turning`]: the same near a gyrostat's motions, on the `surface` of the integrals (`stepped` over it), about the motion of a splitting's own, or why not ([`unproved`]);
//! * `multipliers`: whether they leave the unit circle, over a range of steps; [`stretches`]: ranges, halved until that is known;
//! * [`survey`]: some motions with all of this, for the report.

pub mod chart;
pub mod crossing;
pub mod enclosed;
pub mod followed;
pub mod linear;
mod matrices;
pub mod measured;
pub mod methods;
pub mod motions;
mod multipliers;
pub mod oscillator;
mod pieces;
pub mod splittings;
mod stepped;
pub mod stretches;
mod surface;
pub mod survey;
pub mod tested;
pub mod turning;
pub mod unproved;
mod written;
