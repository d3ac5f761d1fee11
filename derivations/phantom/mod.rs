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

mod alphabet;
pub mod chart;
mod claims;
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

use ::claims::Paper;

/// The page in the ledger.
pub const PAPER: Paper = Paper {
    key: "phantom",
    title: "Phantom stability: what a step makes of a motion",
    citation: "The workbench's own page. The stability function and A-stability are those of G. Dahlquist (1963); collocation after E. Hairer, G. Wanner: Solving ordinary differential equations II (1991), IV.3 and IV.5.",
    summary: r"Near a stationary motion $\dot x=Ax$ a Runge-Kutta method has the matrix $R(hA)$, and a mode $\mu$ fades, stays or grows under it as $|R(h\mu)|$ is below, at or above one. Euler lets grow at every step what stays; the classical Runge-Kutta method damps it up to $h|\mu|=2\sqrt2$; backward Euler and Radau IIA damp it always, and hide a mode that grows from some step on: phantom stability. The midpoint rule and Gauss with two and three stages are honest at every step on every motion. The command `dalembert phantom` gives for a scene's motions every threshold, isolated.",
    entries: &["function", "axis", "grows", "honest", "splitting"],
    page: claims::page,
};
