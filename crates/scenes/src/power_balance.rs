//! The power balance of a run: the total energy minus the work of all loads is constant, except for errors of integration.

use crate::changing_laws::is_watched;
use crate::compiled_system::CompiledSystem;
use crate::compiled_system::determined;
use crate::elimination::{Elimination, LEAST_MOVING};
use crate::implicit::recurrence_with;
use crate::letters::Letters;
use crate::program::recorded;
use crate::row_units::WORK;
use integrators::Ode;
use model::{PowerBalance, Trace};
use simulation::events::of_leading;
use simulation::problem::{Function, Invariant};
use simulation::{CompiledLaw, LawSeries, Problem, SymbolicLaw};
use std::sync::Arc;
use symbolic::{Sym, apart};

/// The problem with the work of all loads as an additional last state and the energy minus this work as its invariant. If no load does
/// work, only the energy is added as an invariant. The problem is unchanged if the energy is already an invariant, the law changes at events,
/// a column named as the work exists, or the accelerations are solved numerically at each evaluation.
pub(crate) fn metered(system: &Arc<CompiledSystem>, plain: Problem) -> Problem {
    let model = system.model();
    let is_taken = plain.columns.iter().any(|name| name == WORK);
    if system.keeps_energy || is_watched(model) || is_taken || Elimination::of(model) == Elimination::Solved {
        return plain;
    }
    let own = plain.state.len();
    let mut has_energy = false;
    let energy = recorded(own, |time, state| {
        let trace = Trace::of(model);
        let all = [PowerBalance::of(&trace).energy, trace.kinetic_energy(), trace.potential_energy()];
        let states = trace.coordinates.iter().chain(&trace.speeds);
        let known = all[0].symbols_of();
        has_energy = states.clone().any(|state| known.contains(state));
        Letters::with_data(time, state).put_into(&trace, &all)
    });
    // without any energy all work is rounding error
    let Ok(energy) = energy else { return plain };
    if !has_energy {
        return plain;
    }
    let energies = move |time: f64, state: &[f64]| {
        let mut values = [f64::NAN; 3];
        // the program was compiled for a state of this length
        energy.run(time, state, &mut values).unwrap_or(());
        values
    };
    if apart(|| PowerBalance::of(&Trace::of(model)).power == Sym::ZERO) {
        return kept(plain, energies);
    }
    let mut law = CompiledLaw::of(Arc::new(WithSuppliedWork(Arc::clone(system))) as Arc<dyn SymbolicLaw>);
    if law.program().is_none() {
        return plain;
    }
    if system.has_solved_series() {
        let system = Arc::clone(system);
        law = law.with_series(LawSeries::by(move || {
            let solved = recurrence_with(system.model(), LEAST_MOVING, |trace| PowerBalance::of(trace).power);
            solved.or_else(|| LawSeries::written(&WithSuppliedWork(Arc::clone(&system))))
        }));
    }
    let Problem { mut state, span, mut columns, row, margins, residual, .. } = plain;
    columns.push(WORK.to_owned());
    let (of_size, [_, _, first]) = (energies.clone(), energies(0.0, &state));
    let balance = move |time: f64, state: &[f64]| energies(time, &state[..own])[0] - state[own];
    let size = move |time: f64, state: &[f64]| {
        let [_, kinetic, potential] = of_size(time, &state[..own]);
        kinetic.abs() + (potential - first).abs() + state[own].abs()
    };
    state.push(0.0);
    let row = move |time: f64, state: &[f64]| {
        let mut row = row(time, &state[..own]);
        row.push(state[own]);
        row
    };
    Problem {
        law: system.projected(Arc::new(law)),
        state,
        metered: 1,
        span,
        // the energy is not constant here, and no other invariant was given
        invariants: vec![Invariant { name: "energy_less_work", value: Box::new(balance), size: Some(Box::new(size)) }],
        columns,
        row: Box::new(row),
        residual: residual.map(|residual| -> Box<Function> {
            Box::new(move |time: f64, state: &[f64]| residual(time, &state[..own]))
        }),
        margins: of_leading(margins, own),
        switching: None,
    }
}

/// The problem with its constant energy, the first of the three `energies`, as an invariant.
fn kept(plain: Problem, energies: impl Fn(f64, &[f64]) -> [f64; 3] + Clone + Send + Sync + 'static) -> Problem {
    let (of_size, [_, _, first]) = (energies.clone(), energies(0.0, &plain.state));
    let value = move |time: f64, state: &[f64]| energies(time, state)[0];
    let size = move |time: f64, state: &[f64]| {
        let [_, kinetic, potential] = of_size(time, state);
        kinetic.abs() + (potential - first).abs()
    };
    let energy = Invariant { name: "energy", value: Box::new(value), size: Some(Box::new(size)) };
    Problem { invariants: vec![energy], ..plain }
}

/// The law of a system with the power of all loads as an additional last rate; the last state is their work (J).
struct WithSuppliedWork(Arc<CompiledSystem>);

impl Ode<Sym> for WithSuppliedWork {
    fn dimension(&self) -> usize {
        Ode::<Sym>::dimension(&*self.0) + 1
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        if let ([y @ .., _], [dy @ .., work]) = (y, dy) {
            self.0.rates(t, y, dy);
            let trace = Trace::of(self.0.model());
            let power = determined(&trace, &self.0.mode, vec![PowerBalance::of(&trace).power]);
            *work = Letters::with_data(t, y).put_into(&trace, &power)[0];
        }
    }
}
