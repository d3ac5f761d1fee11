//! Expressions: algebra, decision, printing, programs.

mod algebra;
mod decisions;
mod dimensions;
mod laws;
mod parsing;
mod printing;
mod programs;
