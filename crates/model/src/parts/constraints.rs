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
    /// The position of the gains in the file; without gains, of the constraint.
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
    /// The constraint, and the component of a vector.
    pub of: [usize; 2],
    /// The name in sentences.
    pub title: String,
    /// The start in words, where it follows on the branch of the start and not on others.
    pub branch: Option<String>,
}
