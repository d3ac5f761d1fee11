//! A system some of whose contacts are made smooth: the model without their friction.

use field::Over;
use mechanics::constrained::contacts::{Contact, Contacts};
use mechanics::constrained::{Constrained, Constraint, State, System};

/// The same system with f = 0 at some contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smoothed<Q, const K: usize> {
    pub system: Q,
    pub smooth: [bool; K],
}

impl<Q: System<N>, const N: usize, const K: usize> System<N> for Smoothed<Q, K> {
    type Given = Q::Given;

    fn masses<S: Over<Self::Given>>(&self) -> [S; N] {
        self.system.masses()
    }

    fn force<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [S; N] {
        self.system.force(at)
    }
}

impl<Q, const N: usize, const C: usize, const K: usize> Constrained<N, C> for Smoothed<Q, K>
where
    Q: Constrained<N, C>,
{
    fn constraints<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [Constraint<S>; C] {
        self.system.constraints(at)
    }
}

impl<Q, const N: usize, const C: usize, const K: usize> Contacts<N, C, K> for Smoothed<Q, K>
where
    Q: Contacts<N, C, K>,
{
    fn contacts<S: Over<Self::Given>>(&self, time: S, place: [S; N]) -> [Contact<S>; K] {
        let rough = self.system.contacts(time, place);
        std::array::from_fn(|k| match self.smooth[k] {
            true => Contact { friction: S::zero(), ..rough[k] },
            false => rough[k],
        })
    }
}
