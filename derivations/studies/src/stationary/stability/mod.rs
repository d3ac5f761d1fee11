//! Stability of steady motions, exactly.
//!
//! # Overview
//! * [`state`]: steady motions and deviations from them;
//! * [`linear`]: the linearisation and the second variation of the energy, by differentiation, over any scalar type;
//! * [`approximation`]: both for a scene's gyrostat and motor, symbolic, evaluated over fractions and enclosures;
//! * [`verdict`]: the verdicts, and the theorems behind them; [`judged`]: a verdict with its evidence;
//! * [`judge`]: verdicts on a scene's motions, with enclosures of sufficient precision, and with fractions if all is
//!   rational;
//! * [`family`]: circles and spheres of motions as rational curves; [`critical`]: functions on them, one of which
//!   vanishes where a verdict changes; [`along`]: the verdicts, arc by arc; [`symmetry`]: families of which one member
//!   represents all;
//! * [`reduced`]: the two classical gyrostats in three unknowns, for theorems, maps and figures;
//! * [`cone`]: stability at every point of the cone of axes, exactly;
//! * [`map`]: stability maps of the rotation about an axis with rotor and weight, over two speeds; [`plane`]: over any
//!   two data ([`datum`]); [`region`]: of every motion of any gyrostat, decided at nodes and continued between them.
//!
//! The theorems, in symbols, are claims in `derivations/theorems/src/stability/`.

pub mod along;
pub mod approximation;
pub mod cone;
pub mod critical;
pub mod datum;
pub mod family;
pub mod judge;
pub mod judged;
pub mod linear;
pub mod map;
pub mod plane;
pub mod reduced;
pub mod region;
pub mod state;
pub mod symmetry;
pub mod verdict;

pub use along::Along;
pub use approximation::Approximation;
pub use judged::Judged;
pub use linear::{Integral, Linear};
pub use state::StationaryState;
pub use verdict::{Reason, StabilityVerdict};
