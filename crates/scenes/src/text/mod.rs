//! The tables of a file as the source of a model: keys and texts with their places.

mod interactions;
mod machines;
mod other_words;

pub use machines::driven_by;

use interactions::{contacts, drives, loads, one_ways};
use model::{
    BodySource, ConstraintSource, Entry, EventSource, Fault, InertiaSource, InputSource, RegulatorSource, Source, Text,
};
use reader::{At, Issue, Table};
use std::ops::Range;

/// Reads all tables of a system; faults are reported in `top`.
pub fn source(top: &mut Table<'_>) -> Source {
    // only version 1 of the language exists
    top.optional_count("language", "version of the language", 1, 1);
    other_words::report(top);
    let (start, equilibrium) = start(top);
    let (drives, data) = drives(top);
    Source {
        parameters: [entries(top, "parameters"), data].concat(),
        coordinates: entries(top, "coordinates"),
        speeds: entries(top, "speeds"),
        definitions: entries(top, "definitions"),
        frames: entries(top, "frames"),
        points: entries(top, "points"),
        bodies: bodies(top),
        gravity: top.optional_text("gravity", "acceleration of free fall, \"-g*N.z\"").map(|text| placed(top, &text)),
        energies: entries(top, "energies"),
        forces: loads(top, "force"),
        torques: loads(top, "torque"),
        constraints: constraints(top),
        contacts: contacts(top),
        one_ways: one_ways(top),
        drives,
        outputs: entries(top, "outputs"),
        regulator: regulator(top),
        inputs: inputs(top),
        events: events(top),
        start,
        equilibrium,
        absent: Vec::new(),
        rigid: Vec::new(),
        angles: Vec::new(),
    }
}

/// The table `[regulator]`.
fn regulator(top: &mut Table<'_>) -> Option<RegulatorSource> {
    let mut table = top.optional_table("regulator")?;
    let inputs = table.texts("inputs", "names of inputs, [\"u\"]");
    let inputs = inputs.iter().map(|name| placed(&table, name)).collect();
    let cost = table.text("cost", "cost by the time, a quadratic form of deviations");
    let cost = placed(&table, &cost);
    let last = text_of(&mut table, "last", "cost of what is left at the end of the horizon");
    let horizon = text_of(&mut table, "horizon", "time for which the cost counts");
    let displaced = entries(&mut table, "displaced");
    let at = table.span();
    let sound = !table.has_issues();
    top.absorb(table);
    sound.then_some(RegulatorSource { inputs, cost, last, horizon, displaced, at })
}

/// The entries of `[start]`, and the place of its key `equilibrium` if that is true; the entries are then guesses.
fn start(top: &mut Table<'_>) -> (Vec<Entry>, Option<Range<usize>>) {
    let Some(mut table) = top.optional_table("start") else { return (Vec::new(), None) };
    let place = table.place_of("equilibrium");
    let is_asked = table.flag("equilibrium", "the start is an equilibrium near what [start] gives");
    let keys = table.keys().into_iter().filter(|key| key.value != "equilibrium").collect();
    let entries = entries_of(&mut table, "start", keys);
    top.absorb(table);
    (entries, place.filter(|_| is_asked))
}

/// The keys and tables at the top level of a file with a system.
const TOP: [&str; 25] = [
    "title",
    "description",
    "known_as",
    "language",
    "gravity",
    "parameters",
    "coordinates",
    "speeds",
    "definitions",
    "frames",
    "points",
    "bodies",
    "energies",
    "force",
    "torque",
    "constraint",
    "contact",
    "diode",
    "freewheel",
    "drive",
    "inputs",
    "outputs",
    "regulator",
    "event",
    "start",
];

/// The additional keys at the top level of a paper's file, which may also contain a system.
pub const OF_PAPERS: [&str; 5] = ["citation", "model", "letters", "claim", "summary"];

/// Whether a table or key at the top level has an unknown name; then the missing table may explain other faults.
pub fn has_unknown_tables(top: &Table<'_>) -> bool {
    let is_paper = top.has("letters") || top.has("claim");
    let is_known = |key: &str| {
        TOP.contains(&key) || is_paper && OF_PAPERS.contains(&key) || matches!(key, "run" | "ensemble" | "failure")
    };
    top.keys()
        .iter()
        .any(|key| !is_known(&key.value) && (top.is_table(&key.value) || units::nearest(&key.value, TOP).is_some()))
}

/// Whether a key at the top level occurs only in files with a system.
pub(crate) fn is_of_system(key: &str) -> bool {
    TOP.contains(&key) && !matches!(key, "title" | "description" | "known_as" | "parameters")
}

/// A fault of the model as an issue of the file.
pub fn issue(fault: Fault) -> Issue {
    let Fault { span, title, label, accepted } = fault;
    Issue::at(span, title, label).accepted(accepted)
}

/// A text with the place of its first character in the file, behind the quote.
fn placed(table: &Table<'_>, text: &At<String>) -> Text {
    let start = table.part(text, &(0..0)).start;
    Text::at(text.value.clone(), start)
}

fn key_text(key: &At<String>) -> Text {
    // the span of a quoted key includes its quotes
    let quote = usize::from(key.span.len() > key.value.len());
    Text::at(key.value.clone(), key.span.start + quote)
}

fn entries(top: &mut Table<'_>, name: &str) -> Vec<Entry> {
    let Some(mut table) = top.optional_table(name) else { return Vec::new() };
    let keys = table.keys();
    let entries = entries_of(&mut table, name, keys);
    top.absorb(table);
    entries
}

fn entries_of(table: &mut Table<'_>, name: &str, keys: Vec<At<String>>) -> Vec<Entry> {
    let mut entries = Vec::new();
    for key in keys {
        if holds_more(table, &key.value)
            && let Some(fault) = model::misplaced(&key_text(&key), name)
        {
            table.report(issue(fault));
        } else if let Some(value) = table.written(&key.value, &format!("`{}` in [{name}]", key.value)) {
            let value = placed(table, &value);
            entries.push(Entry { name: key_text(&key), value });
        }
    }
    entries
}

/// Whether the value of a key is a list or a table, as for some keys of bodies, forces, constraints and events.
fn holds_more(table: &mut Table<'_>, key: &str) -> bool {
    match key {
        "between" | "zero" => is_list(table, key),
        _ => table.is_table(key),
    }
}

/// Whether the value of a key is a list of texts.
fn is_list(table: &mut Table<'_>, key: &str) -> bool {
    let Some(place) = table.place_of(key) else { return false };
    table.text_or_texts(key, "text").first().is_some_and(|text| text.span != place)
}

fn bodies(top: &mut Table<'_>) -> Vec<BodySource> {
    let Some(mut table) = top.optional_table("bodies") else { return Vec::new() };
    let mut bodies = Vec::new();
    for key in table.keys() {
        if !table.is_table(&key.value)
            && let Some(fault) = model::misplaced(&key_text(&key), "bodies")
        {
            // reported once, since the keys below belong to the same mistake
            table.report(issue(Fault {
                accepted: "[bodies.NAME]: each body has a name of its own".to_owned(),
                ..fault
            }));
            table.known_all();
            break;
        }
        let mut body = table.table(&key.value, "a body");
        let mut text = |key: &str, needed: &str| {
            let found = body.written(key, needed)?;
            Some(placed(&body, &found))
        };
        let (turns, frame) = (text("turns", "angle about N.z"), text("frame", "frame that the body is fixed in"));
        let (centre, mass) = (text("centre", "centre of mass, a point"), text("mass", "mass"));
        let inertia = if body.is_table("inertia") {
            Some(tensor(&mut body))
        } else if is_list(&mut body, "inertia") {
            let place = body.place_of("inertia").unwrap_or_else(|| body.span());
            let issue = Issue::at(place, "moments of inertia have names", "a list");
            body.report(issue.accepted("inertia = { axes = \"C\", principal = [\"A\", \"B\", \"C\"] }"));
            None
        } else {
            text_of(&mut body, "inertia", "moment of inertia").map(InertiaSource::Axial)
        };
        let own = ["turns", "frame", "centre", "mass", "inertia"];
        let others = body.keys();
        let mut others = others.iter().filter(|other| !own.contains(&other.value.as_str()));
        if let Some(fault) =
            others.find_map(|other| model::misplaced(&key_text(other), &format!("bodies.{}", key.value)))
        {
            body.report(issue(fault));
            body.known_all();
        }
        bodies.push(BodySource { name: key_text(&key), turns, frame, centre, mass, inertia });
        table.absorb(body);
    }
    top.absorb(table);
    bodies
}

fn text_of(table: &mut Table<'_>, key: &str, needed: &str) -> Option<Text> {
    let found = table.written(key, needed)?;
    Some(placed(table, &found))
}

/// The table `inertia = { axes = "C", principal = [...] }` or `{ xx = ..., xy = ... }` of a body.
fn tensor(body: &mut Table<'_>) -> InertiaSource {
    let mut table = body.table("inertia", "moments of inertia");
    let axes = text_of(&mut table, "axes", "frame that is fixed in the body");
    let principal = table.texts("principal", "[\"m*r^2/4\", \"m*r^2/2\", \"m*r^2/4\"]");
    let mut entries: [Option<Text>; 6] = std::array::from_fn(|_| None);
    for (entry, key) in entries.iter_mut().zip(["xx", "yy", "zz", "xy", "xz", "yz"]) {
        *entry = text_of(&mut table, key, "moment of inertia");
    }
    if table.has("principal") {
        if principal.len() != 3 || entries.iter().any(Option::is_some) {
            let issue = Issue::at(
                table.span(),
                "`principal` has three moments, and no other moments are given with it",
                "here",
            );
            table.report(issue.accepted("principal = [\"A\", \"B\", \"C\"], or xx, yy, zz, xy, xz, yz"));
        }
        for (entry, moment) in entries.iter_mut().zip(&principal) {
            *entry = Some(placed(&table, moment));
        }
    }
    body.absorb(table);
    InertiaSource::Tensor { axes, entries: Box::new(entries) }
}

fn constraints(top: &mut Table<'_>) -> Vec<ConstraintSource> {
    let mut constraints = Vec::new();
    for mut table in
        top.tables("constraint", "[[constraint]] in double brackets is accepted, since a system may have several")
    {
        let name = text_of(&mut table, "name", "name");
        let gains = programmed(&mut table);
        let zero = table.text_or_texts("zero", "expression that is zero, or a list of expressions");
        let zero = zero.iter().map(|text| placed(&table, text)).collect();
        let at = table.span();
        top.absorb(table);
        constraints.push(ConstraintSource { name, zero, gains, at });
    }
    constraints
}

/// The gains of `programmed = { gains = ["2*a", "b^2"] }`.
fn programmed(constraint: &mut Table<'_>) -> Option<Vec<Text>> {
    let mut table = constraint.optional_table("programmed")?;
    let gains = table.texts("gains", "[\"2*a\", \"b^2\"]");
    if gains.is_empty() && !table.has_issues() {
        let issue = Issue::at(table.span(), "a programmed constraint has gains", "none stand here");
        table.report(issue.accepted("programmed = { gains = [\"2*a\", \"b^2\"] }: f'' + 2 a f' + b^2 f = 0"));
    }
    let gains = gains.iter().map(|gain| placed(&table, gain)).collect();
    constraint.absorb(table);
    Some(gains)
}

/// The table `[inputs]`: `u = { unit = "N", value = "F*sin(w*t)" }`, or `u = "N"` for an input without a value.
fn inputs(top: &mut Table<'_>) -> Vec<InputSource> {
    let Some(mut table) = top.optional_table("inputs") else { return Vec::new() };
    let mut inputs = Vec::new();
    for key in table.keys() {
        let name = key_text(&key);
        if table.is_table(&key.value) {
            let mut input = table.table(&key.value, "an input");
            let unit = input.text("unit", "unit of the input");
            let (unit, value) = (placed(&input, &unit), text_of(&mut input, "value", "value of the input"));
            let sound = !input.has_issues();
            table.absorb(input);
            if sound {
                inputs.push(InputSource { name, unit, value });
            }
        } else if let Some(unit) = text_of(&mut table, &key.value, "unit of the input") {
            inputs.push(InputSource { name, unit, value: None });
        }
    }
    top.absorb(table);
    inputs
}

fn events(top: &mut Table<'_>) -> Vec<EventSource> {
    let mut events = Vec::new();
    for mut table in top.tables("event", "[[event]] in double brackets is accepted, since a system may have several") {
        let name = text_of(&mut table, "name", "name");
        let when = table.text("when", "expression that passes zero");
        let when = placed(&table, &when);
        let direction = text_of(&mut table, "direction", "\"up\", \"down\" or \"both\"");
        let set = match table.place_of("set").filter(|_| !table.is_table("set")) {
            Some(place) => {
                table.known(&["set"]);
                let issue = Issue::at(place, "`set` gives coordinates and speeds their values", "no table");
                table.report(issue.accepted("set = { \"x'\" = \"-e*x'\", y = \"0\" }"));
                Vec::new()
            }
            None => entries(&mut table, "set"),
        };
        let ends = table.flag("end", "end of the run");
        let at = table.span();
        let sound = !table.has_issues();
        top.absorb(table);
        if sound {
            events.push(EventSource { name, when, direction, set, ends, at });
        }
    }
    events
}
