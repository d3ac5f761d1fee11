//! Gauss' principle of least constraint.
//!
//! Among all admissible accelerations the true ones minimise Z = 1/2 sum m_i (x''_i - X_i/m_i)^2. The constraints give
//! x'' as an affine function of its free components; Z is quadratic in these. The root of its gradient is the minimum
//! because
//!
//!   Z(x'' + d) - Z(x'') = 1/2 sum m_i d_i^2 for every admissible difference d.

use super::redundant::Admissible;
use crate::definite::{NotDefinite, root};
use crate::differentiate::{fixed, gradient};
use field::{Scalar, Tangent};

/// The constraint Z of an acceleration under a force.
pub fn constraint<S: Scalar, const N: usize>(masses: [S; N], force: [S; N], acceleration: [S; N]) -> S {
    let excess = std::array::from_fn(|i| acceleration[i] - force[i] / masses[i]);
    super::kinetic_energy(masses, excess)
}

/// The admissible acceleration with the least Z.
///
/// # Errors
/// [`NotDefinite`] with the index of the first free component without mass.
pub fn least<S: Scalar, const N: usize, const F: usize>(
    masses: [S; N],
    force: [S; N],
    accelerations: &Admissible<S, N, F>,
) -> Result<[S; N], NotDefinite> {
    type Twice<S> = Tangent<Tangent<S>>;
    let twice = |x: [S; N]| -> [Twice<S>; N] { fixed(fixed(x)) };
    let admissible =
        Admissible { particular: twice(accelerations.particular), directions: accelerations.directions.map(twice) };
    let free = root(|free| gradient(|free| constraint(twice(masses), twice(force), admissible.vector(free)), free))?;
    Ok(accelerations.vector(free))
}
