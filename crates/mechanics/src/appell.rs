//! Appell's equations.

use crate::differentiate::gradient;
use field::{Scalar, Tangent};

/// The derivatives dS/da_j of the acceleration energy S = 1/2 integral of a.a dm (Gibbs, Appell) with respect to the
/// quasi-accelerations a_j. Appell's equations of motion are dS/da_j = Q_j with the generalised forces Q_j.
pub fn appell<S: Scalar, const N: usize>(
    acceleration_energy: impl Fn([Tangent<S>; N]) -> Tangent<S>,
    accelerations: [S; N],
) -> [S; N] {
    gradient(acceleration_energy, accelerations)
}
