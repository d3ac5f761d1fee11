//! Other ways to write the equations of a mechanism: redundant coordinates with each treatment of the constraints.

use crate::stabilisation::law::{BothHeld, Stabilised};
use crate::stabilisation::treatments::MODERATE;
use field::{Analytic, Over};
use integrators::{Held, Ode};
use mechanics::constrained::energies::Energies;
use simulation::work_precision::{Formulation, Treated};
use simulation::{CompiledHeld, CompiledLaw, Law, SymbolicHeld, SymbolicLaw};
use std::sync::Arc;

/// A formulation with its law, and how its states are read as those of the mechanism.
pub struct Rewritten {
    pub formulation: Formulation,
    pub law: Treated,
    pub state: Vec<f64>,
    pub whole: Box<Whole>,
}

/// From a state to the mechanism's own.
pub type Whole = dyn Fn(&[f64]) -> Vec<f64> + Send + Sync;

/// A system in its redundant coordinates, y = (q, q').
#[derive(Clone, Debug)]
struct Redundant<Q, const N: usize, const C: usize> {
    system: Q,
    /// w of f'' = -2 w f' - w^2 f, 1/s
    gain: f64,
}

impl<Q, const N: usize, const C: usize> Redundant<Q, N, C> {
    fn led(&self) -> Stabilised<'_, Q, N, C> {
        Stabilised { system: &self.system, damping: 2.0 * self.gain, stiffness: self.gain * self.gain }
    }
}

impl<S, Q, const N: usize, const C: usize> Ode<S> for Redundant<Q, N, C>
where
    S: Over<f64> + Analytic,
    Q: Energies<N, C, Given = f64>,
{
    fn dimension(&self) -> usize {
        2 * N
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        self.led().rates(t, y, dy);
    }
}

impl<S, Q, const N: usize, const C: usize> Held<S> for Redundant<Q, N, C>
where
    S: Over<f64> + Analytic,
    Q: Energies<N, C, Given = f64>,
{
    fn sizes(&self) -> (usize, usize) {
        (2 * N, 2 * C)
    }

    fn rates(&self, t: S, y: &[S], z: &[S], dy: &mut [S]) {
        BothHeld(&self.system).rates(t, y, z, dy);
    }

    fn parts(&self, t: S, y: &[S], dy: &mut [S], columns: &mut [S]) {
        BothHeld(&self.system).parts(t, y, dy, columns);
    }

    fn constraints(&self, t: S, y: &[S], g: &mut [S]) {
        BothHeld(&self.system).constraints(t, y, g);
    }
}

/// A law as it is run: straight-line code with its series and its Jacobian.
pub fn ready(law: impl SymbolicLaw + 'static) -> Arc<dyn Law> {
    Arc::new(CompiledLaw::new(law))
}

/// Every treatment of the constraints of a system, from (q, q').
pub fn redundant<Q, const N: usize, const C: usize>(
    system: &Q,
    state: &[f64],
    whole: impl Fn(&[f64]) -> Vec<f64> + Clone + Send + Sync + 'static,
) -> Vec<Rewritten>
where
    Q: Energies<N, C, Given = f64> + Clone + Send + Sync + 'static,
{
    treated(|gain| Redundant::<Q, N, C> { system: system.clone(), gain }, state, whole)
}

/// Every treatment, by a law that leads its constraints with a gain w, 1/s, or is held to them.
pub(super) fn treated<L>(
    law: impl Fn(f64) -> L,
    state: &[f64],
    whole: impl Fn(&[f64]) -> Vec<f64> + Clone + Send + Sync + 'static,
) -> Vec<Rewritten>
where
    L: SymbolicLaw + SymbolicHeld + 'static,
{
    let (reduced, led) = (ready(law(0.0)), ready(law(MODERATE)));
    let held = Arc::new(CompiledHeld::new(law(0.0)));
    let treated = [
        (Formulation::IndexReduced, Treated::Free(Arc::clone(&reduced))),
        (Formulation::Led, Treated::Free(led)),
        (Formulation::Projected, Treated::Projected(reduced, held.clone())),
        (Formulation::Held, Treated::Held(held)),
    ];
    let rewritten = treated.into_iter().map(|(formulation, law)| Rewritten {
        formulation,
        law,
        state: state.to_vec(),
        whole: Box::new(whole.clone()),
    });
    rewritten.collect()
}
