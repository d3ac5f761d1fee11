//! Phantom stability: what the steps of a method make of a motion that is stable, or is not.
//!
//! # Overview
//! * [`methods`]: the stability functions, derived from the steps that run;
//! * [`linear`]: the linear motion near a stationary one, exactly;
//! * [`motions`]: the stationary motions of a scene with their eigenvalues;
//! * [`chart`]: every method on every such motion, every step judged.

pub mod chart;
pub mod linear;
pub mod methods;
pub mod motions;
