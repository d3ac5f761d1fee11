//! Maps over angle and friction that show where the motion with friction is unique.
//!
//! # Overview
//! * [`maps`]: the verdicts, together with the critical curves of [`critical`].
//!
//! The theorems behind the maps are claims in `derivations/theorems/src/regimes/`.

pub mod critical;
pub mod maps;
