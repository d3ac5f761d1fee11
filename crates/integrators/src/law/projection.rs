//! Projection onto equations that hold along every motion of a law, such as constraints and their rates.
//!
//! A method has an error in these equations as in everything else, and its error in the rate of a constraint accumulates. A state that is
//! projected after each accepted step keeps them to rounding over a run of any length, and a method keeps its order: the projection is as
//! short as the error of the step (Hairer, Lubich, Wanner: Geometric numerical integration, IV.4).

use field::Scalar;

/// The projection onto the equations that the motions of a law keep.
pub trait Projection<S: Scalar> {
    /// Projects a state at a time onto the equations where it is off by more than rounding; returns whether it has been moved. Must not
    /// allocate.
    fn project(&self, t: S, y: &mut [S]) -> bool;
}
