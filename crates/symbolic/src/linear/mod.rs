//! Linear equations over expressions: solved as they are written, at the size of a body's equations ([`solve`]), or written
//! down to be solved in numbers at each evaluation, at any size ([`Solve`]).

mod cramer;
mod equations;

pub use cramer::{Solution, Unsolved, solve};
pub use equations::Solve;
