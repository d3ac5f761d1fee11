//! Mass points with contacts and servo constraints, with each treatment of both.
//!
//! A control pushes along its direction B as a multiplier does along its gradient, and leads phi as a multiplier leads a
//! geometric constraint. Held to phi = 0 and to its rate r = 0, phi has a multiplier nu of its own, as f has mu:
//!
//!   v' = M^-1 (X + J^T lambda + B u + (dphi/dv)^T nu),   0 = phi(x, v, t),   0 = r(x, v, t),
//!
//! and nu vanishes on the exact motion, since there r is the rate of phi.

use super::points::{Points, state};
use super::rewritten::{Rewritten, treated};
use field::{Analytic, Over};
use integrators::{Held, HeldSystem, Ode};
use mechanics::constrained::State;
use mechanics::constrained::servo::{Servo, gradients, steered, violation};

/// y = (x, x').
#[derive(Clone, Debug)]
struct Steered<Q, const N: usize, const C: usize, const U: usize>(Points<Q, N, C>);

impl<Q, const N: usize, const C: usize, const U: usize> Steered<Q, N, C, U>
where
    Q: Servo<N, C, U, Given = f64>,
{
    /// What the multipliers nu, then the controls u, add to v', each by one.
    fn columns<S: Over<f64>>(&self, at: &State<S, N>) -> [[[S; N]; U]; 2] {
        [gradients(&self.0.system, at), self.0.system.directions(at)]
            .map(|pushes| pushes.map(|push| self.0.moved(push)))
    }
}

impl<S, Q, const N: usize, const C: usize, const U: usize> Ode<S> for Steered<Q, N, C, U>
where
    S: Over<f64> + Analytic,
    Q: Servo<N, C, U, Given = f64>,
{
    fn dimension(&self) -> usize {
        2 * N
    }

    /// No number where contacts depend on each other or no control moves a rate, which every integrator refuses.
    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let at = state::<S, N>(t, y);
        let found = steered(&self.0.system, (&self.0.led::<C>(), &self.0.led::<U>()), &at);
        dy[..N].copy_from_slice(&at.velocity);
        dy[N..].copy_from_slice(&found.map_or([S::zero() / S::zero(); N], |steered| steered.acceleration));
    }
}

impl<S, Q, const N: usize, const C: usize, const U: usize> Held<S> for Steered<Q, N, C, U>
where
    S: Over<f64> + Analytic,
    Q: Servo<N, C, U, Given = f64>,
{
    fn sizes(&self) -> (usize, usize) {
        (2 * N, self.0.multipliers() + 2 * U)
    }

    fn rates(&self, t: S, y: &[S], z: &[S], dy: &mut [S]) {
        let (contacts, servo) = z.split_at(self.0.multipliers());
        Held::rates(&self.0, t, y, contacts, dy);
        let columns = self.columns(&state::<S, N>(t, y));
        for (column, by) in columns.as_flattened().iter().zip(servo) {
            dy[N..].iter_mut().zip(column).for_each(|(rate, push)| *rate += *push * *by);
        }
    }

    fn parts(&self, t: S, y: &[S], dy: &mut [S], columns: &mut [S]) {
        let (contacts, servo) = columns.split_at_mut((2 * N) * self.0.multipliers());
        Held::parts(&self.0, t, y, dy, contacts);
        servo.fill(S::zero());
        let pushes = self.columns(&state::<S, N>(t, y));
        for (column, push) in servo.chunks_mut(2 * N).zip(pushes.as_flattened()) {
            column[N..].copy_from_slice(push);
        }
    }

    fn constraints(&self, t: S, y: &[S], g: &mut [S]) {
        let (contacts, servo) = g.split_at_mut(self.0.multipliers());
        Held::constraints(&self.0, t, y, contacts);
        let found = violation(&self.0.system, &self.0.led::<C>(), &state::<S, N>(t, y));
        match found {
            Ok(found) => {
                servo[..U].copy_from_slice(&found.value);
                servo[U..].copy_from_slice(&found.rate);
            }
            Err(_) => servo.fill(S::zero() / S::zero()),
        }
    }
}

impl<Q, const N: usize, const C: usize, const U: usize> HeldSystem for Steered<Q, N, C, U> where
    Q: Servo<N, C, U, Given = f64>
{
}

/// Every treatment of the contacts and of what the controls keep, from a start that keeps both; `whole` reads x and x'.
pub fn redundant<Q, const N: usize, const C: usize, const U: usize>(
    system: &Q,
    start: &State<f64, N>,
    whole: impl Fn(&State<f64, N>) -> Vec<f64> + Clone + Send + Sync + 'static,
) -> Vec<Rewritten>
where
    Q: Servo<N, C, U, Given = f64> + Clone + Send + Sync + 'static,
{
    let law = |gain| Steered::<Q, N, C, U>(Points::new(system.clone(), gain, start));
    let y = [start.place, start.velocity].concat();
    treated(law, &y, move |y| whole(&state(0.0, y)))
}
