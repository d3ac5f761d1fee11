//! Mass points in their redundant coordinates, held to constraints of both kinds.
//!
//! Gear, Gupta and Leimkuhler's multipliers of the places belong to geometric constraints alone: a kinematic one keeps no place.
//!
//!   x' = v + M^-1 J_g^T mu,   v' = M^-1 (X + J^T lambda),   0 = f(x, t),   0 = df/dt, 0 = phi(x, v, t)

use field::{Analytic, Over};
use integrators::Held;
use mechanics::constrained::programmed::{Linear, violation};
use mechanics::constrained::rates::jacobian;
use mechanics::constrained::{Constrained, Constraint, State};

/// y = (x, x').
#[derive(Clone, Debug)]
pub(super) struct Points<Q, const N: usize, const C: usize> {
    pub system: Q,
    /// w of f'' = -2 w f' - w^2 f and phi' = -2 w phi, 1/s
    gain: f64,
    /// Which constraints are.
    geometric: [bool; C],
}

impl<Q, const N: usize, const C: usize> Points<Q, N, C>
where
    Q: Constrained<N, C, Given = f64>,
{
    pub fn new(system: Q, gain: f64, start: &State<f64, N>) -> Self {
        let geometric = system.constraints(start).map(|constraint| matches!(constraint, Constraint::Geometric(_)));
        Points { system, gain, geometric }
    }

    fn places(&self) -> impl Iterator<Item = usize> {
        (0..C).filter(|k| self.geometric[*k])
    }

    /// Multipliers of the constraints on both levels.
    pub fn multipliers(&self) -> usize {
        self.places().count() + C
    }

    /// The law that leads so many violations.
    pub fn led<const K: usize>(&self) -> Linear<f64, K> {
        Linear::baumgarte(self.gain, self.gain)
    }

    /// What a force adds to x''.
    pub fn moved<S: Over<f64>>(&self, mut force: [S; N]) -> [S; N] {
        let masses = self.system.masses::<S>();
        force.iter_mut().zip(masses).for_each(|(force, mass)| *force /= mass);
        force
    }
}

pub(super) fn state<S: Copy, const N: usize>(time: S, y: &[S]) -> State<S, N> {
    State { time, place: std::array::from_fn(|i| y[i]), velocity: std::array::from_fn(|i| y[N + i]) }
}

impl<S, Q, const N: usize, const C: usize> Held<S> for Points<Q, N, C>
where
    S: Over<f64> + Analytic,
    Q: Constrained<N, C, Given = f64>,
{
    fn sizes(&self) -> (usize, usize) {
        (2 * N, self.multipliers())
    }

    fn rates(&self, t: S, y: &[S], z: &[S], dy: &mut [S]) {
        let (at, (mu, lambda)) = (state::<S, N>(t, y), z.split_at(self.places().count()));
        let (force, rows) = (self.system.force(&at), jacobian(&self.system, &at));
        let placed = |i: usize| self.places().zip(mu).fold(S::zero(), |sum, (k, mu)| sum + rows[k][i] * *mu);
        let pushed = |i: usize| rows.iter().zip(lambda).fold(force[i], |sum, (row, lambda)| sum + row[i] * *lambda);
        let along = self.moved(std::array::from_fn(placed));
        (0..N).for_each(|i| dy[i] = at.velocity[i] + along[i]);
        dy[N..].copy_from_slice(&self.moved(std::array::from_fn(pushed)));
    }

    fn parts(&self, t: S, y: &[S], dy: &mut [S], columns: &mut [S]) {
        let at = state::<S, N>(t, y);
        dy[..N].copy_from_slice(&at.velocity);
        dy[N..].copy_from_slice(&self.moved(self.system.force(&at)));
        columns.fill(S::zero());
        let rows = jacobian(&self.system, &at);
        let pushes = self.places().map(|k| (k, 0)).chain((0..C).map(|k| (k, N)));
        for (column, (k, below)) in columns.chunks_mut(2 * N).zip(pushes) {
            column[below..below + N].copy_from_slice(&self.moved(rows[k]));
        }
    }

    fn constraints(&self, t: S, y: &[S], g: &mut [S]) {
        let found = violation(&self.system, &state::<S, N>(t, y));
        let values = self.places().map(|k| found.value[k]);
        g.iter_mut().zip(values.chain(found.rate)).for_each(|(g, value)| *g = value);
    }
}
