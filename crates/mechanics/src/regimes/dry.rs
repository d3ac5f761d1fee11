//! The contacts' accelerations as a function of their reactions.

use crate::constrained::State;
use crate::constrained::contacts::{Contact, Contacts, Sides};
use crate::constrained::multipliers::multipliers;
use crate::constrained::rates::jacobian;
use crate::definite::{NotDefinite, solve};
use crate::differentiate::{along, gradient};
use field::{Over, Scalar, Tangent};

/// Normal and tangential component of something at each contact.
pub type Pairs<S, const K: usize> = [[S; 2]; K];

/// The system seen by its contacts at a state: a = b + W lambda, where a is the second derivative of gap and place
/// along the curve, and lambda the normal and the tangential reaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dry<S, const K: usize> {
    /// b: with no reaction at any contact. m/s^2
    pub free: Pairs<S, K>,
    /// W, symmetric, positive definite where the contacts are independent: `response[k][i]` is the row of contact k,
    /// component i. 1/kg
    pub response: [[Pairs<S, K>; 2]; K],
    /// f of each contact.
    pub friction: [S; K],
    /// The sides of each contact.
    pub sides: [Sides; K],
}

/// Gap and place along the curve, contact by contact.
fn coordinates<S>(contact: Contact<S>) -> [S; 2] {
    [contact.gap, contact.along]
}

/// The gradients of gap and place along the curve: the directions of the reactions.
fn directions<Q, S, const N: usize, const C: usize, const K: usize>(system: &Q, at: &State<S, N>) -> [[[S; N]; 2]; K]
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given>,
{
    let time = Tangent::fixed(at.time);
    std::array::from_fn(|k| {
        std::array::from_fn(|i| gradient(|place| coordinates(system.contacts(time, place)[k])[i], at.place))
    })
}

/// Second derivatives of gap and place along the curve, at an acceleration.
fn accelerations<Q, S, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<S, N>,
    acceleration: [S; N],
) -> Pairs<S, K>
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given>,
{
    let inner = along(at.place, at.velocity);
    let outer = along(at.velocity, acceleration);
    let time = Tangent::moving(Tangent::moving(at.time, S::one()), Tangent::fixed(S::one()));
    let moving = std::array::from_fn(|i| Tangent::moving(inner[i], outer[i]));
    system.contacts(time, moving).map(|contact| coordinates(contact).map(|value| value.slope.slope))
}

/// A system at a state, with open reactions of its contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen<S, const N: usize, const K: usize> {
    /// The contacts' accelerations as a function of their reactions.
    pub dry: Dry<S, K>,
    /// The directions of the reactions: the gradients of gap and place along the curve.
    pub directions: [[[S; N]; 2]; K],
    /// x'' without reactions.
    free: [S; N],
    /// x'' for a unit of each reaction.
    responses: [[[S; N]; 2]; K],
}

impl<S: Scalar, const N: usize, const K: usize> Seen<S, N, K> {
    /// Evaluates a system at a state under a force; the system's own constraints are kept by their multipliers.
    ///
    /// # Errors
    /// [`NotDefinite`] names the first of the system's constraints that depends on those before it.
    pub fn of<Q, const C: usize>(system: &Q, at: &State<S, N>, force: [S; N]) -> Result<Self, NotDefinite>
    where
        Q: Contacts<N, C, K>,
        S: Over<Q::Given>,
    {
        let free = multipliers(system, at, force)?.acceleration;
        let directions = directions(system, at);
        let responses = responses(system, at, &directions)?;
        let dot = |a: &[S; N], b: &[S; N]| (0..N).fold(S::zero(), |sum, n| sum + a[n] * b[n]);
        let response =
            directions.map(|pair| pair.map(|row| responses.map(|columns| columns.map(|column| dot(&row, &column)))));
        let contacts = system.contacts(at.time, at.place);
        let dry = Dry {
            free: accelerations(system, at, free),
            response,
            friction: contacts.map(|contact| contact.friction),
            sides: contacts.map(|contact| contact.sides),
        };
        Ok(Seen { dry, directions, free, responses })
    }

    /// x'' with these reactions.
    pub fn acceleration(&self, reactions: &Pairs<S, K>) -> [S; N] {
        let each = || reactions.as_flattened().iter().zip(self.responses.as_flattened());
        std::array::from_fn(|n| each().fold(self.free[n], |sum, (reaction, response)| sum + *reaction * response[n]))
    }
}

impl<S: Scalar, const K: usize> Dry<S, K> {
    /// [`Seen::of`] without the data that only a motion needs.
    ///
    /// # Errors
    /// [`NotDefinite`] as [`Seen::of`].
    pub fn of<Q, const N: usize, const C: usize>(
        system: &Q,
        at: &State<S, N>,
        force: [S; N],
    ) -> Result<Self, NotDefinite>
    where
        Q: Contacts<N, C, K>,
        S: Over<Q::Given>,
    {
        Seen::of(system, at, force).map(|seen| seen.dry)
    }
}

/// x'' for a unit of each reaction alone, the system's own constraints kept.
fn responses<Q, S, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<S, N>,
    directions: &[[[S; N]; 2]; K],
) -> Result<[[[S; N]; 2]; K], NotDefinite>
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given>,
{
    let masses: [S; N] = system.masses();
    let rows: [[S; N]; C] = jacobian(system, at);
    let weighted = |a: &[S; N], b: &[S; N]| (0..N).fold(S::zero(), |sum, n| sum + a[n] * b[n] / masses[n]);
    let matrix: [[S; C]; C] = std::array::from_fn(|a| std::array::from_fn(|b| weighted(&rows[a], &rows[b])));
    let mut responses = [[[S::zero(); N]; 2]; K];
    for (response, direction) in responses.as_flattened_mut().iter_mut().zip(directions.as_flattened()) {
        let multipliers = solve(matrix, std::array::from_fn(|a| -weighted(&rows[a], direction)))?;
        *response =
            std::array::from_fn(|n| (0..C).fold(direction[n], |sum, c| sum + multipliers[c] * rows[c][n]) / masses[n]);
    }
    Ok(responses)
}
