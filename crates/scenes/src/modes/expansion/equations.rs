//! A model as a function of the time, the state and the switches, written down once.

use super::{Expansions, Kind, Slope};
use crate::compiled_system::{NotCompiled, values};
use crate::modes::contacts::{friction, kept_at_zero, letters as reactions, motion, slides};
use crate::modes::multiples::{letters, mirrored};
use model::equations::{Equations, Singular};
use model::{Contact, Model, Trace};
use symbolic::{Derivation, Sym, Tape, substitute_all};

/// Rates of the state; conditions; the rows, which are the rates of these and the sums that reactions keep at zero, with switches and
/// reactions as they are; the slopes of rows; gaps, their rates, sliding velocities, coefficients of friction; events.
pub(super) fn expansions(model: &Model) -> Result<Expansions, NotCompiled> {
    let trace = Trace::of(model);
    let mirrored = mirrored(&trace);
    let (accelerations, multipliers) = Equations::of(&trace).solved().map_err(|singular| match singular {
        Singular::Massless { coordinate } => NotCompiled::Massless { coordinate: trace.direction(coordinate) },
        Singular::Redundant { constraint } => NotCompiled::Redundant { constraint },
    })?;
    let motion = motion(&trace, &accelerations, &multipliers);
    let own = letters(&trace, &mirrored);
    let all_in_own = |all: &[Sym]| substitute_all(all, &own);
    let conditions: Vec<Sym> = model.switches.iter().map(|condition| trace.scalar(*condition)).collect();
    let rates: Vec<Sym> = conditions.iter().map(|&condition| trace.rate_of(condition).substitute(&motion)).collect();
    let kind = |contact: &Contact| Kind {
        sides: contact.sides,
        is_rough: contact.friction.is_some(),
        law: contact.law,
        is_guide: contact.guide.is_some(),
        is_one_way: contact.one_way.is_some(),
        is_in_space: contact.is_in_space(),
    };
    let kinds: Vec<Kind> = model.contacts.iter().map(kind).collect();
    let kept = kept_at_zero(&trace).concat();
    let rows = [rates, substitute_all(&kept, &motion)].concat();
    let (conditions, rows) = (all_in_own(&conditions), all_in_own(&rows));
    let letters: Vec<Sym> = trace.switches.iter().copied().chain(reactions(&trace)).collect();
    let is_own = |place: &usize| mirrored.get(*place).is_none_or(Option::is_none);
    let (mut slopes, mut values_of_slopes) = (Vec::new(), Vec::new());
    for row in (0..letters.len()).filter(is_own) {
        for by in (0..letters.len()).filter(is_own) {
            let slope = Derivation::new([(letters[by], Sym::ONE)]).of(rows[row]);
            if slope != Sym::ZERO {
                let used = slope.symbols_of();
                let changed_by = (0..letters.len()).filter(|&other| used.contains(&letters[other]));
                slopes.push(Slope { row, by, changed_by: changed_by.collect() });
                values_of_slopes.push(slope);
            }
        }
    }
    let gaps: Vec<Sym> = model.contacts.iter().map(|contact| trace.scalar(contact.gap)).collect();
    let gap_rates = model.contacts.iter().map(|contact| trace.gap_rate(contact)).collect();
    let [along, aside] = [0, 1]
        .map(|tangent| -> Vec<Sym> { model.contacts.iter().map(|contact| slides(&trace, contact)[tangent]).collect() });
    let frictions = (0..kinds.len()).map(|contact| friction(&trace, contact)).collect();
    let restitutions =
        model.contacts.iter().map(|one| one.restitution.map_or(Sym::ZERO, |e| trace.scalar(e))).collect();
    let of_contacts = [gaps, gap_rates, along, aside, frictions, restitutions].concat();
    let moved: Vec<Sym> = trace.position_rates.iter().copied().chain(accelerations).collect();
    let events: Vec<Sym> = model.events.iter().map(|event| trace.scalar(event.when)).collect();
    let of_contacts = all_in_own(&of_contacts);
    let all = [all_in_own(&moved), conditions, rows, values_of_slopes, of_contacts, all_in_own(&events)].concat();
    let states = model.positions() + model.speeds();
    let named = |letter: &str, count: usize| -> Vec<Sym> {
        (0..count).map(|place| Sym::symbol(&format!("{letter}{place}"))).collect()
    };
    let (state, time, inputs) = (named("y", states), Sym::symbol("t"), named("s", letters.len()));
    let own = letters.iter().copied().zip(inputs.iter().copied()).enumerate();
    let own = own.filter_map(|(place, known)| is_own(&place).then_some(known));
    let known: Vec<(Sym, Sym)> = values(&trace, time, &state).into_iter().chain(own).collect();
    let inputs = [&state[..], &[time], &inputs].concat();
    let tape = Tape::record(&inputs, &substitute_all(&all, &known))
        .map_err(|reason| NotCompiled::Undefined { reason: reason.to_string() })?;
    Ok(Expansions {
        tape: tape.arranged(),
        states,
        positions: model.positions(),
        slopes,
        mirrored,
        kinds,
        events: model.events.len(),
    })
}
