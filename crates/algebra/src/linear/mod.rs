//! Linear equations over any scalar type: determinants by minors, and LU factorisation of sparse symmetric matrices.
//!
//! # Overview
//! * [`determinant`] and [`minors`]: without divisions and pivots, up to [`LARGEST`] unknowns;
//! * [`Factors`]: A z = b by elimination in an order given by the [`Pattern`] of A, or, where its pivots are too small,
//!   with the largest remaining entry as pivot. The order depends on the pattern only, the choice between both ways on
//!   the entries only: equal entries give bitwise equal results;
//! * [`Magnitude`]: the size of a number, for the choice of pivots;
//! * [`nonnegative_combination`]: a vector as an exact combination of others with nonnegative factors.
//!
//! Over enclosures ([`Kind::Enclosed`]) the solution encloses that of every matrix and right-hand side within the
//! enclosures; there is no solution where a pivot may be zero.
//!
//! One factorisation of A_0 serves all orders of a Taylor series:
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
