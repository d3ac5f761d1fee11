//! The accelerations of contacts as affine functions of the reactions.

use crate::constrained::State;
use crate::constrained::contacts::{Contact, Contacts, Sides};
use crate::constrained::multipliers::multipliers;
use crate::constrained::rates::jacobian;
use crate::definite::{NotDefinite, solve};
use crate::differentiate::{along, gradient};
use field::{Over, Scalar, Tangent};

/// The normal and tangential components of a quantity at each contact.
pub type Pairs<S, const K: usize> = [[S; 2]; K];

/// A system at a state, as seen by its contacts: a = b + W lambda. Here a has the second derivatives of the gap and of
/// the position along the curve, and lambda the normal and tangential reactions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dry<S, const K: usize> {
    /// The accelerations b without contact reactions, m/s^2.
    pub free: Pairs<S, K>,
    /// The matrix W, 1/kg: symmetric, and positive definite if the contacts are independent. `response[k][i]` is the
    /// row of contact k, component i.
    pub response: [[Pairs<S, K>; 2]; K],
    /// The friction coefficient f of each contact.
    pub friction: [S; K],
    /// The kind of each contact.
    pub sides: [Sides; K],
}

/// The gap and the position along the curve of a contact.
fn coordinates<S>(contact: Contact<S>) -> [S; 2] {
    [contact.gap, contact.along]
}

/// The gradients of the gap and of the position along the curve, which are the directions of the reactions.
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

/// The second derivatives of the gap and of the position along the curve, for an acceleration.
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

/// A system at a state, with undetermined contact reactions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen<S, const N: usize, const K: usize> {
    /// The accelerations of the contacts as functions of their reactions.
    pub dry: Dry<S, K>,
    /// The directions of the reactions: the gradients of the gap and of the position along the curve.
    pub directions: [[[S; N]; 2]; K],
    /// The accelerations x'' without contact reactions.
    free: [S; N],
    /// The accelerations x'' due to each unit reaction.
    responses: [[[S; N]; 2]; K],
}

impl<S: Scalar, const N: usize, const K: usize> Seen<S, N, K> {
    /// Evaluates a system at a state under a force; the system's own constraints are satisfied through their
    /// multipliers.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first of the system's constraints that depends on those before it.
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

    /// The accelerations x'' for given reactions.
    pub fn acceleration(&self, reactions: &Pairs<S, K>) -> [S; N] {
        let each = || reactions.as_flattened().iter().zip(self.responses.as_flattened());
        std::array::from_fn(|n| each().fold(self.free[n], |sum, (reaction, response)| sum + *reaction * response[n]))
    }
}

impl<S: Scalar, const K: usize> Dry<S, K> {
    /// The part of [`Seen::of`] that the choice of a regime needs.
    ///
    /// # Errors
    /// [`NotDefinite`] as for [`Seen::of`].
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

/// The accelerations x'' due to each unit reaction, with the system's own constraints satisfied.
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
