//! Mass points in their redundant coordinates, with each treatment of constraints of both kinds.
//!
//! Gear, Gupta and Leimkuhler's multipliers of the places belong to geometric constraints alone: a kinematic one keeps no place.
//!
//!   x' = v + M^-1 J_g^T mu,   v' = M^-1 (X + J^T lambda),   0 = f(x, t),   0 = df/dt, 0 = phi(x, v, t)
//!
//! Where a coordinate has no mass, M + J^T J stands for M ([`mechanics::constrained::massless`]).

use super::rewritten::{Rewritten, treated};
use field::{Analytic, Over};
use integrators::{Held, HeldSystem, Ode};
use mechanics::constrained::massless::{self, Inertia};
use mechanics::constrained::motion::velocity;
use mechanics::constrained::multipliers;
use mechanics::constrained::programmed::{Linear, Programme, violation};
use mechanics::constrained::rates::jacobian;
use mechanics::constrained::{Charted, Constrained, Constraint, State, System};

/// Angles of which the coordinates know cosine and sine only, so that their rates are led along.
pub trait Turning<const N: usize, const A: usize>: System<N> {
    /// The rates of the angles, rad/s.
    fn turning<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [S; A];
}

/// y = (x, x', angles).
#[derive(Clone, Debug)]
pub(super) struct Points<Q, const N: usize, const C: usize, const A: usize> {
    pub system: Q,
    /// w of f'' = -2 w f' - w^2 f and phi' = -2 w phi, 1/s
    gain: f64,
    /// Which constraints are.
    geometric: [bool; C],
    /// Whether every coordinate has a mass.
    massive: bool,
}

impl<Q, const N: usize, const C: usize, const A: usize> Points<Q, N, C, A>
where
    Q: Constrained<N, C, Given = f64>,
{
    pub fn new(system: Q, gain: f64, start: &State<f64, N>) -> Self {
        let geometric = system.constraints(start).map(|constraint| matches!(constraint, Constraint::Geometric(_)));
        let massive = system.masses::<f64>().iter().all(|mass| *mass > 0.0);
        Points { system, gain, geometric, massive }
    }

    fn places(&self) -> impl Iterator<Item = usize> {
        (0..C).filter(|k| self.geometric[*k])
    }

    /// The law that leads so many violations.
    pub fn led<const K: usize>(&self) -> Linear<f64, K> {
        Linear::baumgarte(self.gain, self.gain)
    }

    /// What a force adds to x''; no number where nothing holds a coordinate.
    pub fn moved<S: Over<f64>>(&self, at: &State<S, N>, mut force: [S; N]) -> [S; N] {
        let masses = self.system.masses::<S>();
        if self.massive {
            force.iter_mut().zip(masses).for_each(|(force, mass)| *force /= mass);
            return force;
        }
        let inertia = Inertia::of(masses, &jacobian(&self.system, at));
        inertia.moved(force).unwrap_or([S::zero() / S::zero(); N])
    }
}

pub(super) fn state<S: Copy, const N: usize>(time: S, y: &[S]) -> State<S, N> {
    State { time, place: std::array::from_fn(|i| y[i]), velocity: std::array::from_fn(|i| y[N + i]) }
}

impl<S, Q, const N: usize, const C: usize, const A: usize> Ode<S> for Points<Q, N, C, A>
where
    S: Over<f64> + Analytic,
    Q: Constrained<N, C, Given = f64> + Turning<N, A>,
{
    fn dimension(&self) -> usize {
        2 * N + A
    }

    /// No number where constraints depend on each other, which every integrator refuses.
    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let at = state::<S, N>(t, y);
        let (force, wanted) = (self.system.force(&at), self.led().prescribed(&at, &violation(&self.system, &at)));
        let found = match self.massive {
            true => multipliers::leading_to(&self.system, &at, force, wanted),
            false => massless::leading_to(&self.system, &at, force, wanted),
        };
        dy[..N].copy_from_slice(&at.velocity);
        dy[N..2 * N].copy_from_slice(&found.map_or([S::zero() / S::zero(); N], |reaction| reaction.acceleration));
        dy[2 * N..].copy_from_slice(&self.system.turning(&at));
    }
}

impl<S, Q, const N: usize, const C: usize, const A: usize> Held<S> for Points<Q, N, C, A>
where
    S: Over<f64> + Analytic,
    Q: Constrained<N, C, Given = f64> + Turning<N, A>,
{
    fn sizes(&self) -> (usize, usize) {
        (2 * N + A, self.places().count() + C)
    }

    fn rates(&self, t: S, y: &[S], z: &[S], dy: &mut [S]) {
        let (at, (mu, lambda)) = (state::<S, N>(t, y), z.split_at(self.places().count()));
        let (force, rows) = (self.system.force(&at), jacobian(&self.system, &at));
        let placed = |i: usize| self.places().zip(mu).fold(S::zero(), |sum, (k, mu)| sum + rows[k][i] * *mu);
        let pushed = |i: usize| rows.iter().zip(lambda).fold(force[i], |sum, (row, lambda)| sum + row[i] * *lambda);
        let along = self.moved(&at, std::array::from_fn(placed));
        (0..N).for_each(|i| dy[i] = at.velocity[i] + along[i]);
        dy[N..2 * N].copy_from_slice(&self.moved(&at, std::array::from_fn(pushed)));
        dy[2 * N..].copy_from_slice(&self.system.turning(&at));
    }

    fn parts(&self, t: S, y: &[S], dy: &mut [S], columns: &mut [S]) {
        let at = state::<S, N>(t, y);
        dy[..N].copy_from_slice(&at.velocity);
        dy[N..2 * N].copy_from_slice(&self.moved(&at, self.system.force(&at)));
        dy[2 * N..].copy_from_slice(&self.system.turning(&at));
        columns.fill(S::zero());
        let rows = jacobian(&self.system, &at);
        let pushes = self.places().map(|k| (k, 0)).chain((0..C).map(|k| (k, N)));
        for (column, (k, below)) in columns.chunks_mut(2 * N + A).zip(pushes) {
            column[below..below + N].copy_from_slice(&self.moved(&at, rows[k]));
        }
    }

    fn constraints(&self, t: S, y: &[S], g: &mut [S]) {
        let found = violation(&self.system, &state::<S, N>(t, y));
        let values = self.places().map(|k| found.value[k]);
        g.iter_mut().zip(values.chain(found.rate)).for_each(|(g, value)| *g = value);
    }
}

impl<Q, const N: usize, const C: usize, const A: usize> HeldSystem for Points<Q, N, C, A> where
    Q: Constrained<N, C, Given = f64> + Turning<N, A>
{
}

/// Every treatment of the constraints of a charted system, from its q and p with the angles; `whole` reads x, x' and the angles.
pub fn redundant<Q, const N: usize, const C: usize, const K: usize, const R: usize, const A: usize>(
    system: &Q,
    (q, p, angles): ([f64; K], [f64; R], [f64; A]),
    whole: impl Fn(&State<f64, N>, [f64; A]) -> Vec<f64> + Clone + Send + Sync + 'static,
) -> Vec<Rewritten>
where
    Q: Constrained<N, C, Given = f64> + Charted<N, K, R> + Turning<N, A> + Clone + Send + Sync + 'static,
{
    let start = State { time: 0.0, place: system.place(0.0, q), velocity: velocity(system, 0.0, q, p) };
    let law = |gain| Points::<Q, N, C, A>::new(system.clone(), gain, &start);
    let y = [&start.place[..], &start.velocity, &angles].concat();
    treated(law, &y, move |y| whole(&state(0.0, y), std::array::from_fn(|k| y[2 * N + k])))
}
