//! Adaptors to solvers of other crates: their steps, with this crate's outputs, budget and failures.

mod components;
pub(crate) mod ryan_gast;
