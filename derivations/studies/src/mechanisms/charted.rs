//! Systems in coordinates that keep their constraints: Appell's equations as rates, and the power of given forces.

use field::{Analytic, Over, Scalar};
use mechanics::constrained::Charted;
use mechanics::constrained::appell::rates;
use mechanics::constrained::motion::Motion;

/// (q, p) of a slice.
fn parts<S: Copy, const K: usize, const R: usize>(y: &[S]) -> ([S; K], [S; R]) {
    (std::array::from_fn(|i| y[i]), std::array::from_fn(|j| y[K + j]))
}

/// (q', p') by Appell's equations; no number where a field depends on others, which every integrator refuses.
pub fn charted<Q, S, const N: usize, const K: usize, const R: usize>(system: &Q, time: S, y: &[S], dy: &mut [S])
where
    Q: Charted<N, K, R, Given = f64>,
    S: Over<f64> + Analytic,
{
    let (q, p) = parts::<S, K, R>(y);
    let motion: Motion<S, N, R> = Motion::at(system, time, q, p);
    let found = rates(system, &motion, system.force(&motion.state));
    dy[..K].copy_from_slice(&system.rates(time, q, p));
    dy[K..].copy_from_slice(&found.unwrap_or([S::zero() / S::zero(); R]));
}

/// X.x', W.
pub fn power<S: Scalar, const N: usize>(force: [S; N], velocity: [S; N]) -> S {
    force.into_iter().zip(velocity).fold(S::zero(), |sum, (force, rate)| sum + force * rate)
}
