//! Time derivatives of constraints along a motion.

use super::{Constrained, Constraint, State};
use crate::differentiate::{along, unit};
use field::{Over, Tangent};

/// d^2f/dt^2 of geometric and dphi/dt of kinematic constraints, for a given acceleration. They are affine in the
/// acceleration.
pub fn rates<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
    acceleration: [S; N],
) -> [S; C] {
    // second derivative along the motion: x' in the outer tangent, x' and x'' in the inner one
    let twice = |x: S, first: S, second: S| Tangent::moving(Tangent::moving(x, first), Tangent::moving(first, second));
    let still = S::zero();
    let moving = State {
        time: twice(at.time, S::one(), still),
        place: std::array::from_fn(|i| twice(at.place[i], at.velocity[i], acceleration[i])),
        velocity: std::array::from_fn(|i| twice(at.velocity[i], acceleration[i], still)),
    };
    system.constraints(&moving).map(|constraint| match constraint {
        Constraint::Geometric(f) => f.slope.slope,
        Constraint::Kinematic(phi) => phi.slope.value,
    })
}

/// df/dt of geometric constraints at the velocity, phi of kinematic ones.
pub fn first_rates<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> [S; C] {
    let moving = State {
        time: Tangent::variable(at.time),
        place: along(at.place, at.velocity),
        velocity: at.velocity.map(Tangent::fixed),
    };
    system.constraints(&moving).map(|constraint| match constraint {
        Constraint::Geometric(f) => f.slope,
        Constraint::Kinematic(phi) => phi.value,
    })
}

/// The Jacobian with the rows df/dx and dphi/dx': the coefficients of the accelerations in [`rates`], and the
/// directions of ideal reactions.
pub fn jacobian<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> [[S; N]; C] {
    let fixed = at.fixed();
    let columns: [[S; C]; N] = std::array::from_fn(|i| {
        let direction = unit::<S, N>(i).map(|along| Tangent::moving(S::zero(), along));
        rates(system, &fixed, direction).map(|rate| rate.slope)
    });
    std::array::from_fn(|row| std::array::from_fn(|i| columns[i][row]))
}
