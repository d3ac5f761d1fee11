//! A constrained system given by energies: as an ODE in y = (q, q') with constraint stabilisation, or as a DAE of index
//! 2.

use field::{Analytic, Over, Scalar};
use integrators::{Index2Dae, Index2DaeSystem, Ode, System};
use mechanics::constrained::State;
use mechanics::constrained::energies::{Energies, Instant, violation};
use mechanics::constrained::gear_gupta_leimkuhler::Extended;
use mechanics::constrained::programmed::{Linear, Programme};

/// The equations with f'' = -b f' - k f for each constraint; Lagrange's equations if both gains are zero.
#[derive(Clone, Copy, Debug)]
pub struct Stabilised<'a, Q, const N: usize, const C: usize> {
    pub system: &'a Q,
    /// The damping gain b, 1/s.
    pub damping: f64,
    /// The stiffness gain k, 1/s^2.
    pub stiffness: f64,
}

impl<Q: Energies<N, C, Given = f64>, const N: usize, const C: usize> Stabilised<'_, Q, N, C> {
    /// The accelerations q'' in a state; NaN where undetermined, which every integrator rejects.
    pub fn acceleration<S: Over<f64> + Analytic>(&self, at: &State<S, N>) -> [S; N] {
        let programme = Linear::<f64, C> { damping: diagonal(self.damping), stiffness: diagonal(self.stiffness) };
        let instant = Instant::of(self.system, at);
        let wanted = programme.prescribed(at, &instant.kinematics.violation());
        instant.leading_to(wanted).map_or([S::zero() / S::zero(); N], |reaction| reaction.acceleration)
    }
}

fn diagonal<const C: usize>(gain: f64) -> [[f64; C]; C] {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { gain } else { 0.0 }))
}

/// The state from a slice (q, q').
pub fn state<S: Scalar, const N: usize>(time: S, y: &[S]) -> State<S, N> {
    State { time, place: std::array::from_fn(|i| y[i]), velocity: std::array::from_fn(|i| y[N + i]) }
}

impl<S: Over<f64> + Analytic, Q: Energies<N, C, Given = f64>, const N: usize, const C: usize> Ode<S>
    for Stabilised<'_, Q, N, C>
{
    fn dimension(&self) -> usize {
        2 * N
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let at = state::<S, N>(t, y);
        dy[..N].copy_from_slice(&at.velocity);
        dy[N..].copy_from_slice(&self.acceleration(&at));
    }
}

impl<Q: Energies<N, C, Given = f64>, const N: usize, const C: usize> System for Stabilised<'_, Q, N, C> {}

/// The system with f = 0 and f' = 0 enforced by the multipliers (mu, lambda) of Gear, Gupta and Leimkuhler.
#[derive(Clone, Copy, Debug)]
pub struct BothHeld<'a, Q, const N: usize, const C: usize>(pub &'a Q);

impl<S: Over<f64> + Analytic, Q: Energies<N, C, Given = f64>, const N: usize, const C: usize> Index2Dae<S>
    for BothHeld<'_, Q, N, C>
{
    fn sizes(&self) -> (usize, usize) {
        (2 * N, 2 * C)
    }

    fn rates(&self, t: S, y: &[S], z: &[S], dy: &mut [S]) {
        let Ok(extended) = Extended::of(self.0, &state::<S, N>(t, y)) else {
            return undefined(dy);
        };
        let (places, velocities) = extended.rates(std::array::from_fn(|k| z[k]), std::array::from_fn(|k| z[C + k]));
        dy[..N].copy_from_slice(&places);
        dy[N..].copy_from_slice(&velocities);
    }

    fn parts(&self, t: S, y: &[S], dy: &mut [S], columns: &mut [S]) {
        let Ok(extended) = Extended::of(self.0, &state::<S, N>(t, y)) else {
            return undefined(dy);
        };
        dy[..N].copy_from_slice(&extended.velocity);
        dy[N..].copy_from_slice(&extended.free);
        columns.fill(S::zero());
        for (k, push) in extended.pushes.iter().enumerate() {
            columns[2 * N * k..][..N].copy_from_slice(push);
            columns[2 * N * (C + k) + N..][..N].copy_from_slice(push);
        }
    }

    fn constraints(&self, t: S, y: &[S], g: &mut [S]) {
        let found = violation(self.0, &state::<S, N>(t, y));
        g[..C].copy_from_slice(&found.value);
        g[C..].copy_from_slice(&found.rate);
    }
}

impl<Q: Energies<N, C, Given = f64>, const N: usize, const C: usize> Index2DaeSystem for BothHeld<'_, Q, N, C> {}

/// Fills the rates with NaN, which every integrator rejects.
fn undefined<S: Scalar>(dy: &mut [S]) {
    dy.fill(S::zero() / S::zero());
}
