//! Projection onto equations that hold along every motion of a law, such as constraints, their rates and integrals.
//!
//! The numerical error in the rate of a constraint accumulates over a run. A projection after each accepted step keeps
//! the equations satisfied to rounding. The method keeps its order, since the projection is at most of the size of the
//! local error (Hairer, Lubich, Wanner: Geometric numerical integration, IV.4).

use field::Scalar;

/// The projection onto the invariant equations of a law.
pub trait Projection<S: Scalar> {
    /// Projects a state if its residual exceeds rounding. Returns whether the state was changed. Must not allocate.
    fn project(&self, t: S, y: &mut [S]) -> bool;
}
