//! Compiles a model as one function of time, state, switches and reactions, for Taylor series at events.

use super::{Expansions, Kind, Slope};
use crate::compiled_system::{NotCompiled, values};
use crate::modes::algebraic::Parted;
use crate::modes::contacts::{PARTS, friction, kept_at_zero, letters as reactions, motion, slides};
use crate::modes::multiples::{letters, mirrored};
use model::{Contact, Model, Trace};
use symbolic::{Derivation, Sym, Tape, substitute_all};

/// The compiled function. Its outputs are: rates of the state; conditions; rows, which contain switches and reactions as symbols;
/// derivatives of rows by these symbols; gaps, their rates, sliding velocities, coefficients of friction and of restitution of contacts;
/// events.
///
/// # Errors
/// The equations of motion are singular, or an expression has no value.
pub(super) fn expansions(model: &Model) -> Result<Expansions, NotCompiled> {
    let trace = Trace::of(model);
    let mirrored = mirrored(&trace);
    let parted = Parted::of(&trace)?;
    let Parted { accelerations, multipliers, .. } = &parted;
    let motion = motion(&trace, accelerations, multipliers);
    let own = letters(&trace, &mirrored);
    let all_in_own = |all: &[Sym]| substitute_all(all, &own);
    let conditions: Vec<Sym> = model.switches.iter().map(|condition| trace.scalar(*condition)).collect();
    let is_direct = &parted.is_direct;
    let kind = |(contact, &is_direct): (&Contact, &bool)| Kind {
        sides: contact.sides,
        is_rough: contact.friction.is_some(),
        law: contact.law,
        is_guide: contact.guide.is_some(),
        is_one_way: contact.one_way.is_some(),
        is_in_space: contact.is_in_space(),
        is_direct,
    };
    let kinds: Vec<Kind> = model.contacts.iter().zip(&is_direct.contacts).map(kind).collect();
    let rows = rows(&trace, &parted, &conditions, &motion);
    let (conditions, rows) = (all_in_own(&conditions), all_in_own(&rows));
    let letters: Vec<Sym> =
        trace.switches.iter().copied().chain(reactions(&trace)).chain(parted.letters.iter().copied()).collect();
    let is_own = |place: &usize| mirrored.get(*place).is_none_or(Option::is_none);
    let (mut slopes, mut values_of_slopes) = (Vec::new(), Vec::new());
    for row in (0..rows.len()).filter(|row| is_own(&(row % letters.len().max(1)))) {
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
    let gap_rates: Vec<Sym> = model.contacts.iter().map(|contact| trace.gap_rate(contact)).collect();
    let [along, aside] = [0, 1]
        .map(|tangent| -> Vec<Sym> { model.contacts.iter().map(|contact| slides(&trace, contact)[tangent]).collect() });
    let frictions = (0..kinds.len()).map(|contact| friction(&trace, contact)).collect();
    let restitutions =
        model.contacts.iter().map(|one| one.restitution.map_or(Sym::ZERO, |e| trace.scalar(e))).collect();
    let of_contacts = [gaps(&trace).collect(), gap_rates, along, aside, frictions, restitutions].concat();
    let moved: Vec<Sym> = trace.position_rates.iter().chain(accelerations).copied().collect();
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
    // algebraic speeds are inputs of their own, not components of the state
    let of_state = values(&trace, time, &state).into_iter().filter(|(letter, _)| !letters.contains(letter));
    let known: Vec<(Sym, Sym)> = of_state.chain(own).collect();
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
        direct_conditions: parted.is_direct.conditions,
        algebraic: parted.letters.len(),
        algebraic_speeds: model.algebraic_speeds.clone(),
        summed: summed(model),
        events: model.events.len(),
    })
}

/// The indices of the state components that are integrated: all except algebraic speeds and impulses.
fn summed(model: &Model) -> Vec<usize> {
    let positions = (0..model.positions()).filter(|place| !model.impulses.contains(place));
    let speeds = (0..model.speeds()).filter(|speed| !model.algebraic_speeds.contains(speed));
    positions.chain(speeds.map(|speed| model.positions() + speed)).collect()
}

fn gaps<'a>(trace: &'a Trace<'_>) -> impl Iterator<Item = Sym> + 'a {
    trace.model.contacts.iter().map(|contact| trace.scalar(contact.gap))
}

/// The equations for all symbols, as expressions equal to zero: rates of conditions, equations of contacts, laws of algebraic speeds. A
/// direct quantity has its value as the equation, or its rate if the value contains no unknowns. With algebraic speeds the rates follow
/// after all rows.
fn rows(trace: &Trace<'_>, parted: &Parted, conditions: &[Sym], motion: &[(Sym, Sym)]) -> Vec<Sym> {
    let Parted { is_direct, zeros, letters, .. } = parted;
    let rate = |value: &Sym| trace.rate_of(*value).substitute(motion);
    let kept = substitute_all(&kept_at_zero(trace).concat(), motion);
    let row = |is_direct: bool, value: Sym, rate: Sym| if is_direct { [value, rate] } else { [rate, Sym::ZERO] };
    let of_conditions = is_direct.conditions.iter().zip(conditions);
    let of_conditions = of_conditions.map(|(&is_direct, condition)| row(is_direct, *condition, rate(condition)));
    let of_contacts = is_direct.contacts.iter().zip(gaps(trace)).zip(kept.as_chunks::<PARTS>().0);
    let of_contacts = of_contacts.flat_map(|((&is_direct, gap), &[normal, along, aside])| {
        [row(is_direct, gap, normal), [along, Sym::ZERO], [aside, Sym::ZERO]]
    });
    let of_laws = zeros.iter().map(|zero| [*zero, rate(zero)]);
    let (rows, rates): (Vec<Sym>, Vec<Sym>) =
        of_conditions.chain(of_contacts).chain(of_laws).map(|[row, rate]| (row, rate)).unzip();
    // a system without algebraic speeds does not need the rates
    if letters.is_empty() { rows } else { [rows, rates].concat() }
}
