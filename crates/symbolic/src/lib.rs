//! Exact expressions: the field in which equations of motion are proved, printed and turned into straight-line code.
//!
//! # Overview
//! A [`Sym`] is a `Copy` handle into a hash-consed expression graph of the current thread. It implements the
//! workbench's scalar traits, so every law that runs over `f64` also runs over `Sym` and thereby writes itself down.
//!
//! Angles are circle points and roots are generators with a known square, so that expressions are fractions of
//! polynomials modulo rewriting rules ([`Hypotheses`]). Whether one vanishes is then decidable: [`decide`] brings it
//! over a denominator kept as a product of known factors and looks at the numerator. [`normal`] gives the normal form.

mod analytic;
mod calculus;
mod coefficients;
mod dimension;
mod evaluate;
mod graph;
pub mod linear;
mod operators;
mod poly;
mod print;
mod prove;
mod sym;
mod tape;

pub use calculus::substitute_all;
pub use coefficients::{NotPolynomial, coefficients, degree};
pub use dimension::{Dimension, Mismatch, dimension};
pub use evaluate::Unbound;
pub use graph::{Node, Sym};
pub use prove::{Decision, Hypotheses, NormalForm, NotNormal, Proof, Refused, Witness, decide, decide_modulo, normal};
pub use sym::symbols;
pub use tape::{IllPosed, Program, Series, Tape, Untapeable};
