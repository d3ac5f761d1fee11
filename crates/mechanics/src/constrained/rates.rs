//! Constraints differentiated along a motion, up to the accelerations.

use super::{Constrained, Constraint, State};
use crate::differentiate::{along, unit};
use field::{Over, Tangent};

/// d^2f/dt^2 of the geometric and dphi/dt of the kinematic constraints, at an acceleration. They are affine in it.
pub fn rates<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
    acceleration: [S; N],
) -> [S; C] {
    // x moves twice: with x' outside, with x' and x'' inside
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

/// df/dt of the geometric constraints at the velocity, and the kinematic ones themselves.
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

/// The rows df/dx and dphi/dx': the coefficients of the accelerations in [`rates`], and the directions of ideal
/// reactions.
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
