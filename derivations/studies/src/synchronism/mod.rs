//! A synchronous motor under load: pull-out, pull-in, and the initial states from which it reaches synchronism.
//!
//! # Overview
//! * [`loaded`]: the motor alone, its load a constant state;
//! * [`branches`]: all synchronous equilibria up to the pull-out, and all periodic slipping motions, over the load, with stability;
//! * [`pull_in`]: the least load with stable slipping;
//! * [`energy`]: a Lyapunov function that proves synchronism;
//! * [`basin`]: the basin of attraction of synchronism, sampled on the bench and in a gyrostat;
//! * [`maps`]: the share of synchronous initial states over load and damping, over load and bars.
//!
//! Pull-out is the load at which the synchronous equilibria end, a saddle-node bifurcation. Pull-in is the least load with a stable
//! slipping motion. Between the two loads both are stable, and the initial state decides. Proofs: `derivations/theorems/src/synchronism.rs`.

pub mod basin;
pub mod branches;
pub mod energy;
pub mod loaded;
pub mod maps;
pub mod pull_in;
