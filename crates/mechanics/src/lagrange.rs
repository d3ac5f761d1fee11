//! Lagrange's equations of the second kind.

use crate::differentiate::{along, fixed, unit};
use field::{Scalar, Tangent};

/// The expressions d/dt (dL/dq'_i) - dL/dq_i for each i, for a given position, velocity and acceleration.
///
/// One nested evaluation for each coordinate: the outer tangent varies q'_i, the inner one follows the motion (q',
/// q''). Their mixed derivative is the total time derivative of the momentum.
pub fn lagrange<S: Scalar, const N: usize>(
    lagrangian: impl Fn([Tangent<Tangent<S>>; N], [Tangent<Tangent<S>>; N]) -> Tangent<Tangent<S>>,
    position: [S; N],
    velocity: [S; N],
    acceleration: [S; N],
) -> [S; N] {
    rheonomic(|_, q, dq| lagrangian(q, dq), S::zero(), position, velocity, acceleration)
}

/// As [`lagrange`], for L(t, q, q').
pub fn rheonomic<S: Scalar, const N: usize>(
    lagrangian: impl Fn(Tangent<Tangent<S>>, [Tangent<Tangent<S>>; N], [Tangent<Tangent<S>>; N]) -> Tangent<Tangent<S>>,
    time: S,
    position: [S; N],
    velocity: [S; N],
    acceleration: [S; N],
) -> [S; N] {
    let moving = |x: [S; N], rate: [S; N], variation: [S; N]| {
        std::array::from_fn(|j| Tangent::moving(Tangent::moving(x[j], rate[j]), Tangent::fixed(variation[j])))
    };
    let (now, running) = (Tangent::fixed(Tangent::fixed(time)), Tangent::fixed(Tangent::variable(time)));
    let rest = [S::zero(); N];
    std::array::from_fn(|i| {
        let varied = lagrangian(running, moving(position, velocity, rest), moving(velocity, acceleration, unit(i)));
        let force = lagrangian(now, fixed(along(position, unit(i))), fixed(fixed(velocity))).value.slope;
        varied.slope.slope - force
    })
}
