//! Redundant coordinates: all coordinates are kept, and the constraints eliminate dependent velocities.
//!
//! C constraints that are linear in the velocities express C of the velocities by the others, x'_a = sum A_aj x'_j +
//! A_a0. This is a chart with q = x and the free velocities as p. Its fields are Shulgin's operators E_j = d/dx_j + sum
//! A_aj d/dx_a. Shulgin's equations d/dt dT*/dx'_j - E_j(T*) = X_j + sum A_aj X_a follow from [`quasi`](super::quasi),
//! with the correction term for constraints that are not integrable: lost_j = sum over a of m_a x'_a (dA_aj/dt -
//! E_j(x'_a)).

use super::rates::{first_rates, jacobian, rates};
use super::{Charted, Constrained, PointSystem, State};
use crate::definite::{NotDefinite, solve};
use field::{Analytic, Over, Scalar};

/// The indices of the dependent coordinates, the k-th determined by constraint k, and of the free ones, in ascending
/// order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Split<const N: usize, const C: usize, const F: usize> {
    dependent: [usize; C],
    free: [usize; F],
}

impl<const N: usize, const C: usize, const F: usize> Split<N, C, F> {
    /// A split with the given dependent coordinates; `None` where they are not C different indices below N = C + F.
    pub fn new(dependent: [usize; C]) -> Option<Self> {
        const { assert!(N == C + F, "dependent and free coordinates are all") };
        let mut others = (0..N).filter(|i| !dependent.contains(i));
        let free = std::array::from_fn(|_| others.next().unwrap_or(N));
        let complete = dependent.iter().chain(&free).all(|&i| i < N) && others.next().is_none();
        complete.then_some(Split { dependent, free })
    }

    /// The vector x from its dependent and free components.
    fn join<S: Scalar>(&self, dependent: [S; C], free: [S; F]) -> [S; N] {
        let mut all = [S::zero(); N];
        for (&i, value) in self.dependent.iter().zip(dependent).chain(self.free.iter().zip(free)) {
            all[i] = value;
        }
        all
    }
}

/// The affine space of vectors that satisfy the differentiated constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Admissible<S, const N: usize, const F: usize> {
    /// The vector whose free components are zero.
    pub particular: [S; N],
    /// The virtual displacements, one for a unit of each free component.
    pub directions: [[S; N]; F],
}

impl<S: Scalar, const N: usize, const F: usize> Admissible<S, N, F> {
    /// The vector with the given free components.
    pub fn vector(&self, free: [S; F]) -> [S; N] {
        std::array::from_fn(|i| (0..F).fold(self.particular[i], |sum, j| sum + free[j] * self.directions[j][i]))
    }
}

/// The velocities that satisfy constraints linear in the velocities.
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint that does not determine its coordinate.
pub fn velocities<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize, const F: usize>(
    system: &Q,
    split: &Split<N, C, F>,
    time: S,
    place: [S; N],
) -> Result<Admissible<S, N, F>, NotDefinite> {
    let at = State { time, place, velocity: [S::zero(); N] };
    admissible(split, jacobian(system, &at), first_rates(system, &at))
}

/// The accelerations that satisfy the differentiated constraints.
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint that does not determine its coordinate.
pub fn accelerations<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize, const F: usize>(
    system: &Q,
    split: &Split<N, C, F>,
    at: &State<S, N>,
) -> Result<Admissible<S, N, F>, NotDefinite> {
    admissible(split, jacobian(system, at), rates(system, at, [S::zero(); N]))
}

/// The solutions v of J v + rest = 0.
fn admissible<S: Scalar, const N: usize, const C: usize, const F: usize>(
    split: &Split<N, C, F>,
    rows: [[S; N]; C],
    rest: [S; C],
) -> Result<Admissible<S, N, F>, NotDefinite> {
    let block = rows.map(|row| split.dependent.map(|i| row[i]));
    let particular = split.join(solve(block, rest.map(|r| -r))?, [S::zero(); F]);
    let mut directions = [[S::zero(); N]; F];
    for (j, direction) in directions.iter_mut().enumerate() {
        let dependent = solve(block, rows.map(|row| -row[split.free[j]]))?;
        *direction = split.join(dependent, crate::differentiate::unit(j));
    }
    Ok(Admissible { particular, directions })
}

/// A system in redundant coordinates, as a chart.
#[derive(Clone, Copy, Debug)]
pub struct Redundant<'a, Q, const N: usize, const C: usize, const F: usize> {
    system: &'a Q,
    split: Split<N, C, F>,
}

impl<'a, Q: Constrained<N, C>, const N: usize, const C: usize, const F: usize> Redundant<'a, Q, N, C, F> {
    /// The chart near a position where the constraints determine the dependent velocities.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first constraint that does not determine its velocity.
    pub fn about<S: Over<Q::Given>>(
        system: &'a Q,
        split: Split<N, C, F>,
        time: S,
        place: [S; N],
    ) -> Result<Self, NotDefinite> {
        velocities(system, &split, time, place).map(|_| Redundant { system, split })
    }

    /// The free components of a velocity.
    pub fn free<S: Scalar>(&self, velocity: [S; N]) -> [S; F] {
        self.split.free.map(|i| velocity[i])
    }
}

impl<Q: Constrained<N, C>, const N: usize, const C: usize, const F: usize> PointSystem<N>
    for Redundant<'_, Q, N, C, F>
{
    type Given = Q::Given;

    fn masses<S: Over<Self::Given>>(&self) -> [S; N] {
        self.system.masses()
    }

    fn force<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [S; N] {
        self.system.force(at)
    }
}

impl<Q: Constrained<N, C>, const N: usize, const C: usize, const F: usize> Charted<N, N, F>
    for Redundant<'_, Q, N, C, F>
{
    fn place<S: Over<Self::Given> + Analytic>(&self, _time: S, x: [S; N]) -> [S; N] {
        x
    }

    fn rates<S: Over<Self::Given> + Analytic>(&self, time: S, x: [S; N], p: [S; F]) -> [S; N] {
        // `about` has checked that the pivots do not vanish
        velocities(self.system, &self.split, time, x).map_or([S::zero(); N], |admissible| admissible.vector(p))
    }
}
