//! Constraints of a model.

use crate::{ScalarId, VectorId};
use std::ops::Range;
use symbolic::Dimension;

/// An expression f that vanishes along every motion, or is stabilised towards zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    pub name: Option<String>,
    /// The expression f.
    pub zero: Zero,
    /// The dimension of f.
    pub dimension: Dimension,
    /// Gains of a stabilised constraint: f'' + g1 f' + g2 f = 0 for positions, f' + g1 f = 0 for speeds. Units 1/s and 1/s^2.
    pub gains: Option<Vec<ScalarId>>,
    /// The position of the gains in the file; without gains, that of the constraint.
    pub gains_at: Range<usize>,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// The expression f of a constraint f = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Zero {
    Scalar(ScalarId),
    /// A vector; each component that does not vanish identically is a scalar constraint.
    Vector(VectorId),
}

/// A redundant equation of a constraint: it follows from others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Implied {
    /// The index of the constraint, and the index of the component of a vector constraint.
    pub of: [usize; 2],
    /// The name in sentences.
    pub title: String,
    /// A description of the start, if the equation is redundant on the branch of the start only.
    pub branch: Option<String>,
}
