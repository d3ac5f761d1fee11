//! Linear equations over expressions: solved symbolically, at the size of a body's equations ([`solve`]), or recorded for a
//! solution in numbers at each evaluation, at any size ([`Solve`]).

mod cramer;
mod equations;

pub use cramer::{Solution, Unsolved, solve};
pub use equations::Solve;
