//! Other people's solvers behind our driver: their steps, our outputs, budget and failures.

mod components;
pub(crate) mod ryan_gast;
