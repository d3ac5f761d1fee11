//! Points that touch rough curves.

use super::newton::Reactions;
use super::{Charted, Constrained, Constraint, PointSystem, State};
use field::{Analytic, Over};

/// A point of the system beside a rough curve that it may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<S> {
    /// The distance from the curve: zero while they touch, positive beside a one-sided curve. Its multiplier is the
    /// normal reaction.
    pub gap: S,
    /// The place along the curve: its rate is the velocity of sliding, its multiplier the tangential reaction.
    pub along: S,
    /// f of Coulomb's law |tangential| <= f |normal|, with equality and against the velocity where there is sliding.
    pub friction: S,
    /// Whether the point can leave the curve.
    pub sides: Sides,
}

/// The sides from which a curve holds a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// The curve only pushes: gap >= 0, normal reaction >= 0.
    One,
    /// A guide, from both sides: gap = 0, a normal reaction of either sign.
    Two,
}

/// A constrained system with K contacts.
pub trait Contacts<const N: usize, const C: usize, const K: usize>: Constrained<N, C> {
    /// The contacts in a fixed order.
    fn contacts<S: Over<Self::Given>>(&self, time: S, place: [S; N]) -> [Contact<S>; K];
}

/// The system with all its contacts kept closed: the gaps are geometric constraints after the system's own.
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

/// The chart, which closes the gaps.
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

/// The reactions of the system, with those of its contacts.
impl<Q: Reactions<N, D>, const N: usize, const C: usize, const K: usize, const D: usize> Reactions<N, D>
    for Closed<Q, C, K>
{
    fn reactions<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [[S; N]; D] {
        self.0.reactions(at)
    }
}
