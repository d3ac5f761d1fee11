//! Linear equations with numbers of any field: determinants by minors, and factors of sparse symmetric matrices.
//!
//! # Overview
//! * [`determinant`] and [`minors`]: no division and no pivot, up to [`LARGEST`] unknowns;
//! * [`Factors`]: A z = b by elimination, in an order that the [`Pattern`] of A gives, and where the pivots of this
//!   order are too small, by the largest entry of the rest. The order depends on the pattern alone, the choice between
//!   both ways on the entries alone: equal entries give equal bits;
//! * [`Magnitude`]: the size of a number, by which pivots are chosen;
//! * [`nonnegative_combination`]: a column as an exact combination of others with factors that are not negative.
//!
//! Over enclosures ([`Kind::Enclosed`]) the unknowns enclose those of every matrix and right side that the entries enclose, or there is
//! no solution where a pivot may be zero.
//!
//! The same factors serve every order of a series: with A_0 factored once,
//!
//!   A_0 z_k = b_k - sum_(l = 1 ... k) A_l z_(k-l) .

mod factors;
mod magnitude;
mod minors;
mod nonnegative;
mod order;
mod pattern;

pub use factors::{Factors, NotSolved};
pub use magnitude::{Kind, Magnitude};
pub use minors::{LARGEST, determinant, minors};
pub use nonnegative::nonnegative_combination;
pub use pattern::Pattern;
