//! Tests of expressions: algebra, decisions, dimensions, parsing, printing, tapes.

mod algebra;
mod decisions;
mod dimensions;
mod laws;
mod parsing;
mod printing;
mod programs;
