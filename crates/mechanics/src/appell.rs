//! Appell's equations.

use crate::differentiate::gradient;
use field::{Scalar, Tangent};

/// dS/da_j for each quasi-acceleration a_j, of the acceleration energy S = 1/2 integral of a.a dm (Gibbs, Appell).
/// The equations of motion put them equal to the generalised forces Q_j.
pub fn appell<S: Scalar, const N: usize>(
    acceleration_energy: impl Fn([Tangent<S>; N]) -> Tangent<S>,
    accelerations: [S; N],
) -> [S; N] {
    gradient(acceleration_energy, accelerations)
}
