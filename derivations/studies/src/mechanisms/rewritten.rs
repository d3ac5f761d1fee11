//! Other ways to write the equations of a mechanism: redundant coordinates with each treatment of the constraints.

use crate::stabilisation::treatments::MODERATE;
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

/// A law as it is run: straight-line code with its series and its Jacobian.
pub fn ready(law: impl SymbolicLaw + 'static) -> Arc<dyn Law> {
    Arc::new(CompiledLaw::new(law))
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
