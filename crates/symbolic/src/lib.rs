//! Exact expressions: the field in which equations of motion are proved, printed and turned into straight-line code.
//!
//! # Overview
//! A [`Sym`] is a `Copy` handle into a hash-consed expression graph of the current thread. It implements the
//! workbench's scalar traits, so every law that runs over `f64` also runs over `Sym` and thereby writes itself down.

mod analytic;
mod calculus;
mod evaluate;
mod graph;
mod operators;
mod print;
mod sym;

pub use evaluate::Unbound;
pub use graph::{Node, Sym};
pub use sym::symbols;
