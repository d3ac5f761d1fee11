//! Frictional contacts between points and curves.

use super::newton::Reactions;
use super::{Charted, Constrained, Constraint, PointSystem, State};
use field::{Analytic, Over};

/// A contact between a point of the system and a rough curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<S> {
    /// The distance from the curve: zero in contact, positive away from a one-sided curve. The multiplier of gap = 0 is
    /// the normal reaction.
    pub gap: S,
    /// The position along the curve. Its rate is the sliding velocity, the multiplier of a constant position the
    /// tangential reaction.
    pub along: S,
    /// The coefficient f of Coulomb's law |tangential| <= f |normal|, with equality and opposite to the velocity in
    /// sliding.
    pub friction: S,
    /// Whether the contact is unilateral or bilateral.
    pub sides: Sides,
}

/// The kinds of contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// Unilateral: gap >= 0, normal reaction >= 0.
    One,
    /// Bilateral (a guide): gap = 0, with a normal reaction of either sign.
    Two,
}

/// A constrained system with K contacts.
pub trait Contacts<const N: usize, const C: usize, const K: usize>: Constrained<N, C> {
    /// The contacts in a fixed order.
    fn contacts<S: Over<Self::Given>>(&self, time: S, place: [S; N]) -> [Contact<S>; K];
}

/// The system with all contacts closed: the gaps are geometric constraints, after the system's own constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closed<Q, const C: usize, const K: usize>(pub Q);

impl<Q: PointSystem<N>, const N: usize, const C: usize, const K: usize> PointSystem<N> for Closed<Q, C, K> {
    type Given = Q::Given;

    fn masses<S: Over<Self::Given>>(&self) -> [S; N] {
        self.0.masses()
    }

    fn force<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [S; N] {
        self.0.force(at)
    }
}

impl<Q, const N: usize, const C: usize, const K: usize, const D: usize> Constrained<N, D> for Closed<Q, C, K>
where
    Q: Contacts<N, C, K>,
{
    fn constraints<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [Constraint<S>; D] {
        const { assert!(D == C + K, "the system's constraints and its contacts") };
        let own = self.0.constraints(at);
        let gaps = self.0.contacts(at.time, at.place);
        std::array::from_fn(|i| if i < C { own[i] } else { Constraint::Geometric(gaps[i - C].gap) })
    }
}

/// The chart of the system, in which the gaps are closed.
impl<Q, const N: usize, const C: usize, const K: usize, const A: usize, const R: usize> Charted<N, A, R>
    for Closed<Q, C, K>
where
    Q: Charted<N, A, R>,
{
    fn place<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; A]) -> [S; N] {
        self.0.place(time, q)
    }

    fn rates<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; A], p: [S; R]) -> [S; A] {
        self.0.rates(time, q, p)
    }
}

/// The reactions of the system, then those of its contacts.
impl<Q: Reactions<N, D>, const N: usize, const C: usize, const K: usize, const D: usize> Reactions<N, D>
    for Closed<Q, C, K>
{
    fn reactions<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [[S; N]; D] {
        self.0.reactions(at)
    }
}
