//! Expressions: algebra, decision, printing, programs, series, roots.

mod algebra;
mod balls;
mod decisions;
mod dimensions;
mod laws;
mod linear_unknowns;
mod parsing;
mod printing;
mod programs;
mod real;
mod series;
