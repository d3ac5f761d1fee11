//! Linear equations over expressions. [`solve`] solves small systems symbolically; [`Solve`] records systems of any size for a numerical
//! solution at each evaluation.

mod cramer;
mod equations;

pub use cramer::{Solution, Unsolved, solve};
pub use equations::Solve;
