//! Servo constraints: equations enforced by controls, whose forces act along given directions, not along the gradients.
//!
//! Ordinary constraints have ideal reactions J^T lambda. In addition phi(x, x', t) = 0 is to be enforced, but no force
//! acts along dphi/dx'. The controls u act along directions B instead:
//!
//!   M x'' = X + J^T lambda + B u .
//!
//! Let b be the acceleration x'' due to a unit control under the constraints. Here (dphi/dx') b = 0: controls do not
//! affect phi'. The constraints alone give phi' = r(x, x', t), a second condition on the velocities. Its rate
//!
//!   phi'' = r_t + r_x x' + r_x' (x'' at u = 0) + (r_x' b) u
//!
//! determines the controls wherever r_x' b is regular. A control is therefore to phi as a multiplier is to a geometric
//! constraint: phi = 0 and r = 0 are both enforced, and phi'' is prescribed.
//!
//! Sources: Beghin (1922) for servo constraints; Blajer and Kolodziejczyk (2004) for controls that do not act along the
//! gradients.

use super::combining::extended;
use super::programmed::{Programme, Violation, programmed};
use super::rates::jacobian;
use super::{Constrained, State};
use crate::definite::{NotDefinite, solve};
use crate::differentiate::{along, unit};
use field::{Over, Scalar, Tangent};

/// A system with U equations enforced by U controls.
pub trait Servo<const N: usize, const C: usize, const U: usize>: Constrained<N, C> {
    /// The functions phi(x, x', t), to be kept at zero.
    fn kept<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [S; U];

    /// The directions B, one row for each control.
    fn directions<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [[S; N]; U];
}

/// Accelerations and controls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steered<S, const N: usize, const U: usize> {
    /// The accelerations x''.
    pub acceleration: [S; N],
    /// The controls u.
    pub controls: [S; U],
}

/// The gradients dphi/dx', row by row.
pub fn gradients<Q, S, const N: usize, const C: usize, const U: usize>(system: &Q, at: &State<S, N>) -> [[S; N]; U]
where
    Q: Servo<N, C, U>,
    S: Over<Q::Given>,
{
    let columns: [[S; U]; N] = std::array::from_fn(|i| {
        let varied = State { velocity: along(at.velocity, unit(i)), ..at.fixed() };
        system.kept(&varied).map(|phi| phi.slope)
    });
    std::array::from_fn(|k| std::array::from_fn(|i| columns[i][k]))
}

/// The accelerations b due to each unit control, under the constraints.
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint that depends on those before it.
pub fn additions<Q, S, const N: usize, const C: usize, const U: usize>(
    system: &Q,
    at: &State<S, N>,
) -> Result<[[S; N]; U], NotDefinite>
where
    Q: Servo<N, C, U>,
    S: Over<Q::Given>,
{
    let (masses, rows) = (system.masses::<S>(), jacobian(system, at));
    let mut added = system.directions(at);
    for column in &mut added {
        *column = extended(masses, rows, *column)?.of_friction;
        column.iter_mut().zip(masses).for_each(|(push, mass)| *push /= mass);
    }
    Ok(added)
}

/// phi and its rate r, for constraints whose violations obey the equation `contacts`.
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint that depends on those before it.
pub fn violation<Q, L, S, const N: usize, const C: usize, const U: usize>(
    system: &Q,
    contacts: &L,
    at: &State<S, N>,
) -> Result<Violation<S, U>, NotDefinite>
where
    Q: Servo<N, C, U>,
    L: Programme<N, C>,
    S: Over<Q::Given> + Over<L::Given>,
{
    let free = programmed(system, contacts, at, system.force(at))?.acceleration;
    Ok(Violation { value: system.kept(at), rate: system.kept(&moving(at, free)).map(|phi| phi.slope) })
}

/// The state as dual numbers along a motion with the given acceleration.
fn moving<S: Scalar, const N: usize>(at: &State<S, N>, acceleration: [S; N]) -> State<Tangent<S>, N> {
    State {
        time: Tangent::variable(at.time),
        place: along(at.place, at.velocity),
        velocity: along(at.velocity, acceleration),
    }
}

/// Accelerations and controls, for prescribed equations of the constraints and of phi.
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint, or control, that depends on those before it.
pub fn steered<Q, L, K, S, const N: usize, const C: usize, const U: usize>(
    system: &Q,
    (contacts, programme): (&L, &K),
    at: &State<S, N>,
) -> Result<Steered<S, N, U>, NotDefinite>
where
    Q: Servo<N, C, U>,
    L: Programme<N, C>,
    K: Programme<N, U>,
    S: Over<Q::Given> + Over<L::Given> + Over<K::Given>,
{
    let free = programmed(system, contacts, at, system.force(at))?.acceleration;
    let added = additions(system, at)?;
    let rate = |varied: State<Tangent<S>, N>| Ok(violation(system, contacts, &varied)?.rate.map(|r| r.slope));
    let unforced = rate(moving(at, free))?;
    let mut columns = [[S::zero(); U]; U];
    for (column, by) in columns.iter_mut().zip(added) {
        *column = rate(State { velocity: along(at.velocity, by), ..at.fixed() })?;
    }
    let wanted = programme.prescribed(at, &violation(system, contacts, at)?);
    let matrix = std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]));
    let controls: [S; U] = solve(matrix, std::array::from_fn(|i| wanted[i] - unforced[i]))?;
    let acceleration = std::array::from_fn(|i| (0..U).fold(free[i], |sum, k| sum + controls[k] * added[k][i]));
    Ok(Steered { acceleration, controls })
}
