//! A motor whose laws stand in the scene as expressions:
//!
//! ```toml
//! [machine]
//! model = "text"
//! field_speed = "150 rad/s"
//! field_energy = "-b0*cos(g)"            # U(g), J
//! moment_law = "-mu*g' - f*phi'"         # m(g', phi'), N m
//!
//! [machine.parameters]
//! b0 = "0.15 N m"
//!
//! [[machine.winding]]
//! inductance = "l1"
//! resistance = "r1"
//! flux = "a1*cos(g)"                     # psi_k(g), Wb; where the field goes through it
//! supply = "v0*sin(g)"                   # v_k(g), V; where there is one
//! motional = "k*iq"                      # c_k(i), V s, affine in the currents; where conductors slide
//! current = "id"                         # its name; without it x, i1, i2, ...
//! ```

use super::issue::{Issue, nearest};
use super::machine::MachineData;
use super::read::{At, Table};
use super::units::Dimension;
use crate::machines::text::{FIELD_SPEED, Laws, Letters, Motion, Winding, is_taken};
use crate::machines::{AnyMachine, Quantity};
use std::ops::Range;
use symbolic::{NotExpression, Reason, Sym, parse_in};

/// A law of more letters is not written by a person; windings beyond any damper; parameters beyond both.
const LETTERS: usize = 2000;
const WINDINGS: usize = 100;
const PARAMETERS: usize = 200;

/// The rest of the table `[machine]` of a motor as text.
pub(super) fn read(mut table: Table<'_>, issues: &mut Vec<Issue>) -> Option<(AnyMachine, MachineData)> {
    let mut wrong = Vec::new();
    let span = table.span();
    let speed = table.scalar(&FIELD_SPEED.name, &FIELD_SPEED.meaning, &FIELD_SPEED.unit);
    let mut given = vec![(FIELD_SPEED, Dimension::of(&FIELD_SPEED.unit), speed.value)];
    let mut tables = table.tables("winding", "windings are tables, [[machine.winding]] each");
    let currents = read_currents(&mut tables);
    if let Some(mut parameters) = table.optional_table("parameters") {
        given.extend(read_parameters(&mut parameters, &currents));
        wrong.extend(parameters.finish());
    }
    let dimensions: Vec<_> =
        given.iter().map(|(quantity, unit, _)| (quantity.name.to_string(), unit.of_expressions())).collect();
    let letters = |motion| Letters { parameters: &dimensions, currents: &currents, motion };
    let meaning = "energy U(g) of the rotor in the field";
    let energy = optional(&mut table, "field_energy", meaning, "J", &letters(Motion::Angle));
    let meaning = "moment m(g', phi') of friction and slip";
    let moment = law(&mut table, "moment_law", meaning, "N m", &letters(Motion::Speeds));
    let mut windings = Vec::new();
    for (mut winding, current) in tables.into_iter().zip(&currents) {
        windings.extend(read_winding(&mut winding, current, &letters));
        wrong.extend(winding.finish());
    }
    if windings.len() > WINDINGS || given.len() > PARAMETERS {
        let title = format!("{} windings and {} parameters", windings.len(), given.len());
        let most = format!("at most {WINDINGS} windings and {PARAMETERS} parameters are accepted");
        wrong.push(Issue::at(span.clone(), title, "too many").accepted(most));
    }
    wrong.extend(table.finish());
    let sound = wrong.is_empty();
    issues.extend(wrong);
    let moment = moment.filter(|_| sound)?.value;
    let energy = energy.map_or(Sym::ZERO, |law| law.value);
    let (places, windings): (Vec<Range<usize>>, Vec<_>) = windings.into_iter().unzip();
    let (quantities, values): (Vec<Quantity>, Vec<f64>) =
        given.into_iter().map(|(quantity, _, value)| (quantity, value)).unzip();
    let laws = match Laws::new(quantities, energy, moment, &windings) {
        Ok(laws) => laws,
        Err(long) => {
            issues.push(Issue::at(span, format!("a law has {long}"), "in this table").accepted("a shorter law"));
            return None;
        }
    };
    let numbers = laws.numbers(values.clone());
    let found = issues.len();
    if numbers.iter().any(|number| !number.is_finite()) {
        let issue = Issue::at(span, "a number of the laws is not finite", "a root or quotient of these parameters");
        issues.push(issue.accepted("parameters whose roots and quotients exist"));
    }
    for (k, place) in places.into_iter().enumerate().filter(|(k, _)| laws.inductance(*k, &numbers) <= 0.0) {
        let label = format!("it is {} H", laws.inductance(k, &numbers));
        issues.push(Issue::at(place, "an inductance must be positive", label).accepted("a positive inductance"));
    }
    (issues.len() == found).then(|| MachineData::written(laws, &values))
}

/// The names of the currents: x, i1, i2, ... where a winding does not give its own.
fn read_currents(windings: &mut [Table<'_>]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for (k, table) in windings.iter_mut().enumerate() {
        let usual = if k == 0 { "x".to_owned() } else { format!("i{k}") };
        let name = match table.optional_text("current", "name of the winding's current, as in \"id\"") {
            Some(At { value, span }) => {
                let taken = is_taken(&value) || value == FIELD_SPEED.name || names.contains(&value);
                if taken || !is_name(&value) || ["angle", "slip", "rotor_speed"].contains(&&*value) {
                    let label = if taken { "this name has its meaning already" } else { "no name in an expression" };
                    let issue = Issue::at(span, format!("`{value}` cannot name a current"), label);
                    table.report(issue.accepted("letters, digits and _ are accepted, a letter first"));
                }
                value
            }
            None => usual,
        };
        names.push(name);
    }
    names
}

/// Whether an expression reads it as one name.
fn is_name(text: &str) -> bool {
    symbolic::parse(text, &|name| Some(Sym::symbol(name))).ok().and_then(Sym::symbol_name).as_deref() == Some(text)
}

/// A winding whose current has this name, and where its inductance stands; none where it is not sound, which the table then tells.
fn read_winding<'a>(
    table: &mut Table<'_>,
    current: &str,
    letters: &impl Fn(Motion) -> Letters<'a>,
) -> Option<(Range<usize>, Winding<Sym, Sym>)> {
    let flux = "flux psi(g) of the stator's field through the winding";
    let flux = optional(table, "flux", flux, "Wb", &letters(Motion::Angle));
    let inductance = law(table, "inductance", "inductance of the winding", "H", &letters(Motion::Rest));
    let resistance = law(table, "resistance", "resistance of the winding", "ohm", &letters(Motion::Rest));
    let supply = optional(table, "supply", "voltage v(g) of the supply", "V", &letters(Motion::Angle));
    let meaning = "voltage c(i) per speed by which conductors slide";
    let motional = optional(table, "motional", meaning, "V s", &letters(Motion::Currents));
    let (inductance, resistance) = (inductance?, resistance?);
    let winding = Winding {
        current: current.to_owned(),
        flux: flux.map_or(Sym::ZERO, |law| law.value),
        supply: supply.map(|law| law.value),
        motional: motional.map(|law| law.value),
        inductance: inductance.value,
        resistance: resistance.value,
    };
    Some((inductance.span, winding))
}

/// The parameters of the file, each of whatever dimension.
fn read_parameters(table: &mut Table<'_>, currents: &[String]) -> Vec<(Quantity, Dimension, f64)> {
    let mut all = Vec::new();
    for At { value: name, span } in table.keys() {
        let read = table.of_any_unit(&name);
        let taken = is_taken(&name) || name == FIELD_SPEED.name || currents.contains(&name);
        if taken || !is_name(&name) {
            let label = if taken { "this name has its meaning already" } else { "no name in an expression" };
            let issue = Issue::at(span, format!("`{name}` cannot name a parameter"), label);
            table.report(issue.accepted("letters, digits and _ are accepted, a letter first"));
        } else if let Some(At { value: (value, dimension), .. }) = read {
            let (unit, meaning) = (dimension.coherent().into(), "parameter of the written motor".into());
            all.push((Quantity { name: name.into(), unit, meaning, positive: false }, dimension, value));
        }
    }
    all
}

/// An expression in letters, of the dimension of a unit; none where it is not sound, which the table then tells.
fn law(table: &mut Table<'_>, key: &str, meaning: &str, unit: &str, letters: &Letters<'_>) -> Option<At<Sym>> {
    let text = table.text(key, &format!("{meaning}, an expression in {}", letters.known()));
    if text.value.is_empty() {
        return None;
    }
    let title = || format!("`{key}`, the {meaning}, cannot be read");
    if text.value.len() > LETTERS {
        let issue = Issue::at(text.span.clone(), title(), format!("{} letters", text.value.len()));
        table.report(issue.accepted(format!("at most {LETTERS} letters are accepted")));
        return None;
    }
    let needed = Dimension::of(unit).of_expressions();
    match parse_in(&text.value, letters) {
        Ok(expression) => match letters.dimension(expression) {
            Ok(found) if found.is_none_or(|found| found == needed) => Some(At { value: expression, span: text.span }),
            Ok(found) => {
                let found = found.map_or_else(String::new, |found| found.to_string());
                let label = format!("this is {found}; needed is {needed}");
                table.report(Issue::at(text.span, title(), label).accepted(format!("an expression in {unit}")));
                None
            }
            Err(reason) => {
                table.report(Issue::at(text.span, title(), reason.to_string()).accepted(letters.known()));
                None
            }
        },
        Err(NotExpression { span, reason }) => {
            let names = letters.parameters.iter().map(|(name, _)| name.as_str());
            let meant = match &reason {
                Reason::Name(name) => nearest(name, names).map(|nearest| format!("is `{nearest}` meant? ")),
                _ => None,
            };
            let known = format!("{}known here: {}", meant.unwrap_or_default(), letters.known());
            table.report(Issue::at(table.part(&text, &span), title(), reason.to_string()).accepted(known));
            None
        }
    }
}

/// The same of one that may be left out.
fn optional(table: &mut Table<'_>, key: &str, meaning: &str, unit: &str, letters: &Letters<'_>) -> Option<At<Sym>> {
    if table.has(key) {
        law(table, key, meaning, unit, letters)
    } else {
        table.known(&[key]);
        None
    }
}
