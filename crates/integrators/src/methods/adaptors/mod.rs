//! Adaptors to the solvers of other crates: their steps, with the outputs, budget and failures of this crate.

mod components;
pub(crate) mod ryan_gast;
