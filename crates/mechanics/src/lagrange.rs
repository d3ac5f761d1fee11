//! Lagrange's equations of the second kind.

use crate::differentiate::{along, fixed, unit};
use field::{Scalar, Tangent};

/// d/dt (dL/dq'_i) - dL/dq_i for each i, at a position, velocity and acceleration.
///
/// One nested pass for each coordinate: the outer tangent moves along the motion (q', q''), the inner one varies q'_i,
/// so that their mixed derivative is the total time derivative of the momentum.
pub fn lagrange<S: Scalar, const N: usize>(
    lagrangian: impl Fn([Tangent<Tangent<S>>; N], [Tangent<Tangent<S>>; N]) -> Tangent<Tangent<S>>,
    position: [S; N],
    velocity: [S; N],
    acceleration: [S; N],
) -> [S; N] {
    let moving = |x: [S; N], rate: [S; N], variation: [S; N]| {
        std::array::from_fn(|j| Tangent::moving(Tangent::moving(x[j], rate[j]), Tangent::fixed(variation[j])))
    };
    let rest = [S::zero(); N];
    std::array::from_fn(|i| {
        let momentum_rate =
            lagrangian(moving(position, velocity, rest), moving(velocity, acceleration, unit(i))).slope.slope;
        let force = lagrangian(fixed(along(position, unit(i))), fixed(fixed(velocity))).value.slope;
        momentum_rate - force
    })
}
