//! Conditions of a law for a reader: the meaning of each bracket, and the parts of the model that the equations omit.

use super::contacts::laws;
use super::matrix_form::MatrixForm;
use crate::{Direction, Event, ScalarId, Trace};
use symbolic::Sym;

/// A condition in the equations: its bracket is 1 where `is` is positive, otherwise 0.
pub(super) struct Condition {
    /// The number of the condition, counted from one.
    pub number: usize,
    /// The symbol of the bracket.
    pub letter: Sym,
    pub is: Sym,
    /// The unit, and the line in the file if this is known.
    pub told: String,
}

/// Returns the conditions that occur in the equations, or in other conditions.
pub(super) fn conditions(trace: &Trace<'_>, form: &MatrixForm) -> Vec<Condition> {
    let held = form.constraints.iter().flat_map(|held| held.row.iter().chain([&held.zero, &held.bias]));
    let loads = form.mass.iter().flatten().chain(&form.inertia).chain(&form.forces);
    let mut open: Vec<Sym> = loads.chain(held).copied().collect();
    let mut stands = vec![false; form.switches.len()];
    while let Some(expression) = open.pop() {
        let letters = expression.symbols_of();
        for (number, (letter, is)) in form.switches.iter().enumerate() {
            if letters.contains(letter) && !std::mem::replace(&mut stands[number], true) {
                open.push(*is);
            }
        }
    }
    let all = form.switches.iter().enumerate().filter(|(number, _)| stands[*number]);
    all.map(|(number, &(letter, is))| {
        let line = form.lines.conditions.get(number).map_or_else(String::new, |line| format!(", line {line}"));
        let unit = &trace.model.switch_units[number];
        Condition { number: number + 1, letter, is, told: format!("in {unit}{line}") }
    })
    .collect()
}

/// Returns sentences on the parts of a model that its equations omit, and on states at which the equations are undefined.
pub fn left_out(trace: &Trace<'_>, form: &MatrixForm) -> Vec<String> {
    [left_out_between_events(trace, form), events(trace, form)].concat()
}

/// Returns these sentences for equations that include the events.
pub(super) fn left_out_between_events(trace: &Trace<'_>, form: &MatrixForm) -> Vec<String> {
    let implied = |implied: &crate::Implied| match &implied.branch {
        None => format!("{} follows from the others and is left out.", implied.title),
        Some(start) => format!(
            "{} follows from the others for positions near the start, {start}; on other branches it does not. It is left out.",
            implied.title
        ),
    };
    let mut sentences: Vec<String> = trace.model.implied.iter().map(implied).collect();
    sentences.extend(form.quasi.iter().flat_map(|quasi| &quasi.divisors).map(|divisor| divisor.told(trace)));
    let mut sliding = conditions(trace, form);
    // a force keeps a speed at zero, and no coordinate
    sliding.retain(|one| one.is.symbols_of().iter().any(|symbol| form.speeds.contains(symbol)));
    if !sliding.is_empty() {
        let named = |one: &Condition| format!("{} ({})", one.letter, one.told);
        let named: Vec<String> = sliding.iter().map(named).collect();
        sentences.push(format!(
            "A condition that stays at zero, such as the speed of dry friction that sticks, is not part of these equations: \
             `run` finds the force that keeps it there. Conditions of speeds here: {}",
            named.join(", ")
        ));
    }
    if !trace.model.contacts.is_empty() {
        sentences.push(
            "The reactions of contacts are letters here; `run` finds them by these laws, which hold at each instant:"
                .to_owned(),
        );
        sentences.extend(laws(trace, form).into_iter().map(|line| format!("  {line}")));
    }
    sentences
}

/// Returns sentences on each event.
fn events(trace: &Trace<'_>, form: &MatrixForm) -> Vec<String> {
    let mut sentences = Vec::new();
    if trace.model.events.is_empty() {
        return sentences;
    }
    sentences.push("Events are not part of these equations; the file has:".to_owned());
    let written = |scalar: ScalarId| trace.scalar(scalar).decimal_text();
    sentences.extend(trace.model.events.iter().enumerate().map(|(place, event)| {
        let line = form.lines.events.get(place).map_or_else(String::new, |line| format!(" (line {line})"));
        let Event { name, when, direction, set, ends, .. } = event;
        let name = if name.is_empty() { format!("event {}", place + 1) } else { format!("event `{name}`") };
        let passes = match direction {
            Direction::Up => "passes zero upwards",
            Direction::Down => "passes zero downwards",
            Direction::Both => "passes zero",
        };
        let letter = |each: &crate::Assignment| match each.order {
            0 => trace.coordinates[each.coordinate],
            _ => trace.speeds[each.coordinate],
        };
        let mut does: Vec<String> =
            set.iter().map(|each| format!("{} becomes {}", letter(each), written(each.is))).collect();
        if *ends {
            does.push("the run ends".to_owned());
        }
        format!("  {name}{line}: where {} {passes}, {}", written(*when), does.join(", "))
    }));
    sentences
}
