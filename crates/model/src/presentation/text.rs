//! Export of a whole system to text.

use super::conditions::{Condition, conditions, left_out};
use super::contacts::open_letters;
use super::cosines::Cosine;
use super::matrix_form::MatrixForm;
use super::{constraints, with_counts};
use crate::Trace;
use crate::equations::constraints_of;
use std::fmt::Write;
use symbolic::Sym;

/// Returns the matrix form with parameters and constraints, one line per nonzero entry.
pub fn text(trace: &Trace<'_>, form: &MatrixForm) -> String {
    let mut text = String::new();
    let names = |letters: &[Sym]| letters.iter().map(Sym::to_string).collect::<Vec<_>>().join(", ");
    let held = !form.constraints.is_empty();
    // a parameter may have the name of a matrix
    let [mass_matrix, inertia, forces, jacobian, bias] = [
        ["M", "mass", "mass_matrix"],
        ["h", "inertia", "inertia_terms"],
        ["Q", "forces", "applied_forces"],
        ["J", "jacobian", "constraint_rows"],
        ["c", "bias", "bias_terms"],
    ]
    .map(|names| form.free_name(&names));
    let reactions = if held { format!(" + {jacobian}^T lambda") } else { String::new() };
    let turns = form.has_own_speeds();
    let f = form.free_letter(&["f", "F", "phi", "zero"], form.constraints.len());
    match turns {
        false => writeln!(
            text,
            "{mass_matrix} q'' + {inertia} = {forces}{reactions}, with q = ({})",
            names(&form.coordinates)
        ),
        true => {
            writeln!(text, "{mass_matrix} u' + {inertia} = {forces}{reactions}, with u = ({})", names(&form.speeds))
        }
    }
    .unwrap_or(());
    if held && turns {
        let _ = writeln!(
            text,
            "{jacobian} u' + {bias} = 0: every constraint {f} = 0, differentiated; {jacobian} holds d{f}'/du of positions, d{f}/du of speeds"
        );
    } else if held {
        let _ = writeln!(
            text,
            "{jacobian} q'' + {bias} = 0: every constraint {f} = 0, differentiated; {jacobian} holds d{f}/dq of positions, d{f}/dq' of speeds"
        );
    }
    if held {
        let _ = writeln!(text, "A positive lambda acts along the gradient of {f}");
    }
    let section = |text: &mut String, title: &str, lines: Vec<String>| {
        if !lines.is_empty() {
            let _ = write!(text, "\n{title}\n  {}\n", lines.join("\n  "));
        }
    };
    section(&mut text, "Parameters", parameters(trace));
    let speeds = trace.model.quasi_velocities.iter().zip(form.quasi.iter().flat_map(|quasi| &quasi.definitions));
    let own = form.quasi.iter().all(|quasi| quasi.definitions == form.speeds);
    let speeds = speeds.map(|(speed, is)| match is.to_string() == speed.name {
        true => format!("{} in {}", speed.name, speed.unit()),
        false => format!("{} = {}, in {}", speed.name, is.decimal_text(), speed.unit()),
    });
    let speeds: Vec<String> = speeds.collect();
    let units = trace.model.coordinates.iter().map(|each| format!("{} in {}", each.name, each.unit)).collect();
    section(&mut text, "Coordinates q", units);
    section(&mut text, if own { "Independent speeds u" } else { "Quasi-velocities u" }, speeds);
    let kinematics = match form.quasi {
        Some(_) if trace.model.free.is_empty() => "Kinematic equations",
        Some(_) => "Kinematic equations; free frames have quaternions q0 + q1 i + q2 j + q3 k",
        None => "Orientation of free frames, quaternions q0 + q1 i + q2 j + q3 k",
    };
    section(&mut text, kinematics, position_rates(form));
    let coefficients = form.quasi.iter().flat_map(|quasi| &quasi.coefficients).flat_map(|each| {
        [(each.letter, each.is), (each.rate, each.rate_is)]
            .map(|(letter, is)| format!("{letter} = {}", is.decimal_text()))
    });
    section(&mut text, "Coefficients of the kinematic equations, and their rates", coefficients.collect());
    let cosines = form
        .cosines
        .iter()
        .map(|Cosine { letter, meaning, value }| format!("{letter} = {meaning} = {}", value.decimal_text()));
    section(&mut text, "Direction cosines of free frames", cosines.collect());
    let open = open_letters(trace).into_iter();
    let inputs = if trace.model.contacts.is_empty() { "Inputs" } else { "Inputs, and reactions of contacts" };
    section(&mut text, inputs, open.map(|(letter, unit)| format!("{letter} in {unit}")).collect());
    let rows: Vec<String> = form.coordinates.iter().map(Sym::to_string).collect();
    let entry = |name: &str, place: String, value: Sym| format!("{name}[{place}] = {}", value.decimal_text());
    let mut mass = Vec::new();
    for (i, row) in form.mass.iter().enumerate() {
        for (j, &value) in row.iter().enumerate().skip(i).filter(|(_, value)| **value != Sym::ZERO) {
            mass.push(entry(mass_matrix, format!("{}, {}", rows[i], rows[j]), value));
        }
    }
    section(&mut text, &format!("Mass matrix {mass_matrix}, symmetric; entries that are not written are zero"), mass);
    let vector = |name: &str, values: &[Sym]| {
        let entries = rows.iter().zip(values).filter(|(_, value)| **value != Sym::ZERO);
        entries.map(|(row, value)| entry(name, row.clone(), *value)).collect::<Vec<_>>()
    };
    let without = format!("Inertia {inertia} without accelerations");
    section(&mut text, &without, vector(inertia, &form.inertia));
    section(&mut text, &format!("Applied forces {forces}"), vector(forces, &form.forces));
    let mut lines = Vec::new();
    let kinds = constraints(trace).into_iter();
    let kept: Vec<bool> = constraints_of(trace).iter().map(|one| form.quasi.is_some() && one.gains.is_none()).collect();
    let kinds = kinds.take(kept.len()).enumerate();
    let (met, kinds): (Vec<_>, Vec<_>) = kinds.partition(|(k, _)| kept[*k]);
    for (held, (k, kind)) in form.constraints.iter().zip(kinds) {
        lines.push(kind);
        lines.push(format!("{f}{} = {}", k + 1, held.zero.decimal_text()));
        for (row, value) in rows.iter().zip(&held.row).filter(|(_, value)| **value != Sym::ZERO) {
            lines.push(entry(jacobian, format!("{}, {row}", k + 1), *value));
        }
        lines.push(entry(bias, (k + 1).to_string(), held.bias));
    }
    section(&mut text, "Constraints", lines);
    let met = met.into_iter().zip(form.quasi.iter().flat_map(|quasi| &quasi.met));
    let met = met.map(|((_, kind), held)| format!("{kind}\n    0 = {}", held.zero.decimal_text())).collect();
    section(
        &mut text,
        "Constraints, met by the kinematic equations for any u; a constraint of positions must hold at the start",
        met,
    );

    let conditions = conditions(trace, form).into_iter().map(|Condition { number, letter, is, told }| {
        format!("{letter}: condition {number} = {}, {told}", is.decimal_text())
    });
    section(&mut text, "Conditions; a bracket is 1 where its condition is positive, else 0", conditions.collect());
    let left_out = left_out(trace, form);
    if !left_out.is_empty() {
        let _ = write!(text, "\n{}\n", left_out.join("\n"));
    }
    with_counts(&text)
}

/// Returns a line for the rate of each coordinate that is not a speed.
fn position_rates(form: &MatrixForm) -> Vec<String> {
    let parts = form.positions.iter().zip(&form.position_rates).skip(form.plain());
    let lines = parts.map(|(part, rate)| (format!("{part}'"), rate.decimal_text()));
    lines.filter(|(part, rate)| part != rate).map(|(part, rate)| format!("{part} = {rate}")).collect()
}

/// Returns a line for each parameter: its value in the notation of the file, or its unit if it has no value.
fn parameters(trace: &Trace<'_>) -> Vec<String> {
    let line = |parameter: &crate::Parameter| match parameter.value {
        Some(_) => format!("{} = {}", parameter.name, parameter.written),
        None => format!("{} in {}, without a value", parameter.name, parameter.written),
    };
    trace.model.parameters.iter().map(line).collect()
}
