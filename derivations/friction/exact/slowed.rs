//! A regime whose determinant goes to zero, slowed down by it.

use crate::friction::stretch::{Stretch, motion_of_contacts, parts};
use field::{DoubleDouble, Over, Scalar};
use integrators::{Directions, Ode, System};
use mechanics::constrained::contacts::Contacts;

/// y' = D f(t, y) and t' = D, with the time as the last component. The reactions are numerators over D, so that this law is
/// regular up to D = 0, to which it comes as exp(-s^2) does: there velocities grow as s, in finite time.
pub(super) struct Slowed<'a, Q, const N: usize, const C: usize, const K: usize> {
    pub stretch: Stretch<'a, Q, N, C, K>,
}

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Slowed<'_, Q, N, C, K> {
    /// D, positive where the stretch is oriented.
    pub fn determinant<S: Over<f64>>(&self, t: S, y: &[S]) -> Option<S> {
        let (_, cramer) = self.stretch.solve(&parts(t, y))?;
        Some(cramer.determinant * S::lift(self.stretch.orientation))
    }

    fn slowed<S: Over<f64>>(&self, y: &[S], dy: &mut [S]) -> Option<()> {
        let (&t, y) = y.split_last()?;
        let at = parts::<S, N>(t, y);
        let (seen, cramer) = self.stretch.solve(&at)?;
        let sign = S::lift(self.stretch.orientation);
        let determinant = cramer.determinant * sign;
        let numerators = cramer.numerators.map(|pair| pair.map(|numerator| numerator * sign));
        let acceleration = seen.times_determinant(determinant, &numerators);
        let (force, slides): ([S; N], _) =
            (self.stretch.system.force(&at), motion_of_contacts(self.stretch.system, &at));
        for i in 0..N {
            (dy[i], dy[N + i]) = (determinant * at.velocity[i], acceleration[i]);
        }
        dy[2 * N] = (0..K).fold(S::zero(), |sum, k| sum + numerators[k][1] * slides[k][1].slope);
        dy[2 * N + 1] = (0..N).fold(S::zero(), |sum, i| sum + force[i] * at.velocity[i]) * determinant;
        dy[2 * N + 2] = determinant;
        Some(())
    }
}

impl<Q, S, const N: usize, const C: usize, const K: usize> Ode<S> for Slowed<'_, Q, N, C, K>
where
    Q: Contacts<N, C, K, Given = f64>,
    S: Scalar + Over<f64>,
{
    fn dimension(&self) -> usize {
        2 * N + 3
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
