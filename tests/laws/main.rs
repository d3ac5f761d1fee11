//! Laws and principles: scalar types, derivatives, constraints, counterexamples, contact regimes.

mod classification;
mod counterexamples;
mod exported_code;
mod fields;
mod inverse_problem;
mod jacobians;
mod nonideal;
mod one_source;
#[path = "../physical/mod.rs"]
mod physical;
mod principles;
mod regimes;
mod rotations;
