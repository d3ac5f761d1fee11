//! A regime whose determinant goes to zero, slowed down by it.

use crate::friction::stretch::{Stretch, parts};
use field::{DoubleDouble, Over, Scalar};
use integrators::{Directions, Ode, System};
use mechanics::constrained::contacts::Contacts;

/// y' = D f(t, y) of places and velocities, and t' = D, with the time as the last component: backwards where D is negative. The
/// reactions are numerators over D, so that this law is regular up to D = 0, to which it comes as exp(-s^2) does: there
/// velocities grow as s, in finite time.
pub(super) struct Slowed<'a, Q, const N: usize, const C: usize, const K: usize> {
    pub stretch: &'a Stretch<'a, Q, N, C, K>,
}

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Slowed<'_, Q, N, C, K> {
    /// D
    pub fn determinant<S: Over<f64>>(&self, t: S, y: &[S]) -> Option<S> {
        self.stretch.solve(&parts(t, y)).map(|(_, cramer)| cramer.determinant)
    }

    fn slowed<S: Over<f64>>(&self, y: &[S], dy: &mut [S]) -> Option<()> {
        let (&t, y) = y.split_last()?;
        let at = parts::<S, N>(t, y);
        let (seen, cramer) = self.stretch.solve(&at)?;
        let determinant = cramer.determinant;
        let acceleration = seen.times_determinant(determinant, &cramer.numerators);
        for i in 0..N {
            (dy[i], dy[N + i]) = (determinant * at.velocity[i], acceleration[i]);
        }
        dy[2 * N] = determinant;
        Some(())
    }
}

impl<Q, S, const N: usize, const C: usize, const K: usize> Ode<S> for Slowed<'_, Q, N, C, K>
where
    Q: Contacts<N, C, K, Given = f64>,
    S: Scalar + Over<f64>,
{
    fn dimension(&self) -> usize {
        2 * N + 1
    }

    fn rates(&self, _s: S, y: &[S], dy: &mut [S]) {
        if self.slowed(y, dy).is_none() {
            dy.fill(S::one() / S::zero());
        }
    }
}

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> System
    for Slowed<'_, Q, N, C, K>
where
    Self: Ode<f64> + Ode<Directions> + Ode<DoubleDouble>,
{
}
