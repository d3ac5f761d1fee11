//! A model as a function of the time, the state and the switches, written down once.

use super::{Expansions, Slope};
use crate::compiled_system::{NotCompiled, values};
use crate::modes::multiples::{letters, mirrored};
use model::equations::{Equations, Singular};
use model::{Model, Trace};
use symbolic::{Derivation, Sym, Tape, substitute_all};

/// Rates of the state; conditions, their rates with switches as they are, the slopes of these; events.
pub(super) fn expansions(model: &Model) -> Result<Expansions, NotCompiled> {
    let trace = Trace::of(model);
    let mirrored = mirrored(&trace);
    let (accelerations, _) = Equations::of(&trace).solved().map_err(|singular| match singular {
        Singular::Massless { coordinate } => NotCompiled::Massless { coordinate: trace.direction(coordinate) },
        Singular::Redundant { constraint } => NotCompiled::Redundant { constraint },
    })?;
    let motion: Vec<(Sym, Sym)> = trace.accelerations.iter().copied().zip(accelerations.iter().copied()).collect();
    let own = letters(&trace, &mirrored);
    let all_in_own = |all: &[Sym]| substitute_all(all, &own);
    let conditions: Vec<Sym> = model.switches.iter().map(|condition| trace.scalar(*condition)).collect();
    let rates: Vec<Sym> = conditions.iter().map(|&condition| trace.rate_of(condition).substitute(&motion)).collect();
    let (conditions, rates) = (all_in_own(&conditions), all_in_own(&rates));
    let (mut slopes, mut values_of_slopes) = (Vec::new(), Vec::new());
    for (condition, rate) in rates.iter().enumerate().filter(|(condition, _)| mirrored[*condition].is_none()) {
        for (switch, letter) in trace.switches.iter().enumerate().filter(|(switch, _)| mirrored[*switch].is_none()) {
            let slope = Derivation::new([(*letter, Sym::ONE)]).of(*rate);
            if slope != Sym::ZERO {
                let used = slope.symbols_of();
                let changed_by = (0..trace.switches.len()).filter(|&other| used.contains(&trace.switches[other]));
                slopes.push(Slope { condition, switch, changed_by: changed_by.collect() });
                values_of_slopes.push(slope);
            }
        }
    }
    let moved: Vec<Sym> = trace.position_rates.iter().copied().chain(accelerations).collect();
    let events: Vec<Sym> = model.events.iter().map(|event| trace.scalar(event.when)).collect();
    let all = [all_in_own(&moved), conditions, rates, values_of_slopes, all_in_own(&events)].concat();
    let states = model.positions() + model.speeds();
    let named = |letter: &str, count: usize| -> Vec<Sym> {
        (0..count).map(|place| Sym::symbol(&format!("{letter}{place}"))).collect()
    };
    let (state, time, switches) = (named("y", states), Sym::symbol("t"), named("s", trace.switches.len()));
    let own_switches = trace.switches.iter().copied().zip(switches.iter().copied()).zip(&mirrored);
    let own_switches = own_switches.filter_map(|(known, mirrored)| mirrored.is_none().then_some(known));
    let known: Vec<(Sym, Sym)> = values(&trace, time, &state).into_iter().chain(own_switches).collect();
    let inputs = [&state[..], &[time], &switches].concat();
    let tape = Tape::record(&inputs, &substitute_all(&all, &known))
        .map_err(|reason| NotCompiled::Undefined { reason: reason.to_string() })?;
    Ok(Expansions { tape: tape.arranged(), states, slopes, mirrored, events: model.events.len() })
}
