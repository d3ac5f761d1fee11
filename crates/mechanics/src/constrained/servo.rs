//! Servo constraints: equations that a control keeps, with control forces along given directions instead of their
//! gradients.
//!
//! Contacts keep their constraints by ideal reactions, J^T lambda. Beside them phi(x, x', t) = 0 is to hold, but no force acts
//! along dphi/dx': the directions B of the controls u take the place of the gradients,
//!
//!   M x'' = X + J^T lambda + B u .
//!
//! Let b be the acceleration x'' by a unit of a control while the contacts hold. Here (dphi/dx') b = 0: no control changes phi'
//! and no u gives phi' = 0 at once; phi' = r(x, x', t) by the contacts alone, a second equation of the velocities. Its rate
//!
//!   phi'' = r_t + r_x x' + r_x' (x'' at u = 0) + (r_x' b) u
//!
//! gives the controls wherever r_x' b is regular. A control is therefore to phi as a multiplier is to a geometric
//! constraint: phi and r are both kept, and phi'' is prescribed.
//!
//! Sources: Beghin 1922 for constraints that a servo keeps; Blajer, Kolodziejczyk 2004 for controls across the gradients.

use super::combining::extended;
use super::programmed::{Programme, Violation, programmed};
use super::rates::jacobian;
use super::{Constrained, State};
use crate::definite::{NotDefinite, solve};
use crate::differentiate::{along, unit};
use field::{Over, Scalar, Tangent};

/// A system with U equations that are kept by as many controls.
pub trait Servo<const N: usize, const C: usize, const U: usize>: Constrained<N, C> {
    /// phi(x, x', t), to be kept zero.
    fn kept<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [S; U];

    /// B, one row for each control.
    fn directions<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [[S; N]; U];
}

/// Accelerations and controls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steered<S, const N: usize, const U: usize> {
    /// x''
    pub acceleration: [S; N],
    /// u
    pub controls: [S; U],
}

/// dphi/dx', by rows.
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

/// b: the acceleration by a unit of each control while the contacts hold.
///
/// # Errors
/// [`NotDefinite`] names the first contact that depends on those before it.
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

/// phi and its rate r, with the violations of the contacts under their law.
///
/// # Errors
/// As [`additions`].
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

/// An instant moving with an acceleration.
fn moving<S: Scalar, const N: usize>(at: &State<S, N>, acceleration: [S; N]) -> State<Tangent<S>, N> {
    State {
        time: Tangent::variable(at.time),
        place: along(at.place, at.velocity),
        velocity: along(at.velocity, acceleration),
    }
}

/// Accelerations and controls with the contacts under one law, and phi'' under another.
///
/// # Errors
/// [`NotDefinite`] names the first contact that depends on those before it, or the first control.
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
