//! The law of a mode with its signals as additional states, so that the curvature of a signal limits the step size of every method.
//!
//! Example: while a block sticks, its accelerations are zero and do not limit the step, although the force that will move the block
//! oscillates.

use super::mode::{Case, Mode, Phase};
use super::signals::{Fall, written};
use crate::compiled_system::{CompiledSystem, rates};
use crate::letters::Letters;
use integrators::Ode;
use model::Model;
use simulation::{CompiledLaw, Law, Program};
use std::sync::Arc;
use symbolic::{Derivation, Sym};

/// The law with the rates of the state, then of the nonlinear signals.
#[derive(Debug)]
struct Followed {
    model: Arc<Model>,
    mode: Mode,
    dimension: usize,
}

/// The law of a mode for runs, and the number of signals that it integrates.
pub(super) fn followed(model: &Arc<Model>, system: &Arc<CompiledSystem>) -> (Arc<dyn Law>, usize) {
    let mode = &system.mode;
    if mode.is_only_one() && model.events.is_empty() {
        return (system.law(), 0);
    }
    let states = model.positions() + model.speeds();
    let mut count = 0;
    let program = Program::of(states, |time, state| {
        count = of_signals(model, mode, time, state).map_or(0, |rates| rates.len());
        Vec::new()
    });
    if program.is_none() || count == 0 {
        return (system.law(), 0);
    }
    let followed = Followed { model: Arc::clone(model), mode: mode.clone(), dimension: states + count };
    let law = CompiledLaw::new(followed);
    match law.program() {
        Some(_) => (Arc::new(law), count),
        None => (system.law(), 0),
    }
}

/// The rates of the state, then of the signals, as expressions over the extended state.
fn all(model: &Model, mode: &Mode, time: Sym, extended: &[Sym]) -> Vec<Sym> {
    let state = &extended[..model.positions() + model.speeds()];
    let moved = rates(model, mode, Letters::with_data(time, state));
    let signals = of_signals(model, mode, time, state);
    match (moved, signals) {
        (Ok(moved), Some(signals)) => [moved, signals].concat(),
        _ => vec![Sym::UNDEFINED; extended.len()],
    }
}

/// The rates of all signals that are not linear in time and state; `None` if they have no expressions.
fn of_signals(model: &Model, mode: &Mode, time: Sym, state: &[Sym]) -> Option<Vec<Sym>> {
    // signals of contacts that slide in space are functions of speeds, which are states
    let (falls, all) = written(model, mode, time, (state, &[])).ok()?;
    let bends = |signal: Sym| {
        let mut letters = signal.symbols_of().into_iter();
        letters.any(|letter| !Derivation::new([(letter, Sym::ONE)]).of(signal).symbols_of().is_empty())
    };
    // the signal 1 - s has the curvature of s
    let own = falls.iter().zip(all.as_chunks::<2>().0);
    let own = own.filter(|(fall, _)| !matches!(fall, Fall::Leaves { to: Case::On, .. }));
    // the direction of friction changes without bound as a contact in space comes to rest; the rates of the state contain it
    let glides = mode.phases.iter().any(|phase| matches!(phase, Phase::Glides { .. }));
    let own =
        own.filter(|(fall, _)| !(glides && matches!(fall, Fall::Lifts { .. } | Fall::Slides { .. } | Fall::Jams)));
    Some(own.filter_map(|(_, &[signal, rate])| bends(signal).then_some(rate)).collect())
}

impl Ode<Sym> for Followed {
    fn dimension(&self) -> usize {
        self.dimension
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        dy.copy_from_slice(&all(&self.model, &self.mode, t, y));
    }
}
