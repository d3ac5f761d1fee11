//! A synchronous motor under load: pull-out, pull-in, and the initial states from which it reaches synchronism.
//!
//! # Overview
//! * [`loaded`]: the motor alone, with its load as a constant component of the state;
//! * [`branches`]: all synchronous equilibria up to the pull-out, and all periodic slipping motions, over the load,
//!   with their stability;
//! * [`pull_in`]: the least load with a stable slipping motion;
//! * [`energy`]: a Lyapunov function that proves synchronism;
//! * [`basin`]: the basin of attraction of synchronism, by sampling, on the bench and in a gyrostat;
//! * [`maps`]: the fraction of initial states that reach synchronism, over load and damping, and over load and number
//!   of bars.
//!
//! Pull-out is the load at which the synchronous equilibria end in a saddle-node bifurcation. Pull-in is the least load
//! with a stable slipping motion. Between the two loads synchronism and slipping are both stable, and the initial state
//! decides which one is reached. For proofs see `derivations/theorems/src/synchronism.rs`.

pub mod basin;
pub mod branches;
pub mod energy;
pub mod loaded;
pub mod maps;
pub mod pull_in;
