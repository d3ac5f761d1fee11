//! Equations that hold along every motion of a law, such as constraints and their rates, and the way back onto them.
//!
//! A method errs in these equations as in everything else, and what it errs in the rate of a constraint adds up. A state that is brought
//! back after each accepted step keeps them to rounding over a run of any length, and a method keeps its order: the way back is as short as
//! the error of the step (Hairer, Lubich, Wanner: Geometric numerical integration, IV.4).

use field::Scalar;

/// The way back onto the equations that the motions of a law keep.
pub trait Projection<S: Scalar> {
    /// Brings a state at a time back onto the equations where it is off by more than rounding; whether it has been moved. Must not allocate.
    fn project(&self, t: S, y: &mut [S]) -> bool;
}
