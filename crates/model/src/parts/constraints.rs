//! Constraints.

use crate::{ScalarId, VectorId};
use std::ops::Range;
use symbolic::Dimension;

/// An expression f that is zero along every motion, or is led to zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    pub name: Option<String>,
    pub zero: Zero,
    /// The dimension of that expression.
    pub dimension: Dimension,
    /// Gains of a constraint that is led to zero: f'' + g1 f' + g2 f = 0 of positions, f' + g1 f = 0 of speeds.
    pub gains: Option<Vec<ScalarId>>,
    /// Where its gains stand; where it has none, itself.
    pub gains_at: Range<usize>,
    pub at: Range<usize>,
}

/// The expression of a constraint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Zero {
    Scalar(ScalarId),
    /// Every component that does not vanish by itself.
    Vector(VectorId),
}

/// An equation of a constraint that follows from others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Implied {
    /// Its constraint, and its component of a vector.
    pub of: [usize; 2],
    /// As sentences call it.
    pub title: String,
    /// The start in words, where it follows on the branch of the start and not on others.
    pub branch: Option<String>,
}
