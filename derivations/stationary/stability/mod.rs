//! Stability of stationary motions, exactly.
//!
//! # Overview
//! * [`linear`]: the first approximation and the second variation of the energy, by differentiation, over any field;
//! * [`approximation`]: both for a scene's gyrostat and motor, written down once and run over fractions and enclosures;
//! * [`verdict`]: what they say, as a closed set of answers with what each rests on;
//! * [`judge`]: of a scene's motions, with enclosures fine enough, and with fractions where all is rational.

pub mod approximation;
pub mod judge;
pub mod linear;
pub mod verdict;

pub use approximation::Approximation;
pub use linear::{Integral, Linear, Place};
pub use verdict::{Judged, Reason, Verdict};
