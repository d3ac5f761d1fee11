//! A model from a TOML text, without the diagnostics of the command-line program.

use dalembert_model::{
    BodySource, ConstraintSource, Entry, EventSource, InertiaSource, InputSource, LoadSource, Model, Source, Text,
};
use toml::{Table, Value};

/// Returns the model described by a text.
pub fn model(text: &str) -> Model {
    let top: Table = text.parse().unwrap_or_else(|wrong| panic!("{wrong}: {text}"));
    let list = |name: &str| -> Vec<Table> {
        let tables = top.get(name).and_then(Value::as_array).into_iter().flatten();
        tables.map(|table| table.as_table().expect("a table").clone()).collect()
    };
    let source = Source {
        parameters: entries(&top, "parameters"),
        coordinates: entries(&top, "coordinates"),
        definitions: entries(&top, "definitions"),
        frames: entries(&top, "frames"),
        points: entries(&top, "points"),
        bodies: table(&top, "bodies")
            .iter()
            .map(|(name, value)| body(name, value.as_table().expect("a body")))
            .collect(),
        gravity: text_of(&top, "gravity"),
        energies: entries(&top, "energies"),
        forces: list("force").iter().map(load).collect(),
        torques: list("torque").iter().map(load).collect(),
        constraints: list("constraint").iter().map(constraint).collect(),
        inputs: table(&top, "inputs").iter().map(|(name, value)| input(name, value)).collect(),
        events: list("event").iter().map(event).collect(),
        ..Source::default()
    };
    Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}: {text}"))
}

fn table<'a>(top: &'a Table, name: &str) -> std::borrow::Cow<'a, Table> {
    match top.get(name) {
        Some(Value::Table(table)) => std::borrow::Cow::Borrowed(table),
        _ => std::borrow::Cow::Owned(Table::new()),
    }
}

fn text_of(table: &Table, key: &str) -> Option<Text> {
    table.get(key).and_then(Value::as_str).map(Text::from)
}

fn texts(value: Option<&Value>) -> Vec<Text> {
    match value {
        Some(Value::String(text)) => vec![text.as_str().into()],
        Some(Value::Array(texts)) => texts.iter().map(|text| text.as_str().expect("a text").into()).collect(),
        _ => Vec::new(),
    }
}

fn entries(top: &Table, name: &str) -> Vec<Entry> {
    let entry = |(name, value): (&String, &Value)| (name.as_str(), value.as_str().expect("a text")).into();
    table(top, name).iter().map(entry).collect()
}

fn body(name: &str, table: &Table) -> BodySource {
    let text = |key: &str| text_of(table, key);
    let inertia = match table.get("inertia") {
        Some(Value::Table(tensor)) => {
            let mut entries = ["xx", "yy", "zz", "xy", "xz", "yz"].map(|key| text_of(tensor, key));
            for (entry, moment) in entries.iter_mut().zip(texts(tensor.get("principal"))) {
                *entry = Some(moment);
            }
            Some(InertiaSource::Tensor { axes: text_of(tensor, "axes"), entries: Box::new(entries) })
        }
        _ => text("inertia").map(InertiaSource::Axial),
    };
    let [turns, frame, centre, mass] = ["turns", "frame", "centre", "mass"].map(text);
    BodySource { name: name.into(), turns, frame, centre, mass, inertia }
}

fn load(table: &Table) -> LoadSource {
    let between = match &texts(table.get("between"))[..] {
        [one, other] => Some([one.clone(), other.clone()]),
        _ => None,
    };
    let text = |key: &str| text_of(table, key);
    let is = text("is").expect("a load has a value");
    LoadSource { on: text("on"), along: text("along"), between, is, ..LoadSource::default() }
}

fn constraint(table: &Table) -> ConstraintSource {
    let gains = table.get("programmed").map(|programmed| texts(programmed.get("gains")));
    ConstraintSource { name: text_of(table, "name"), zero: texts(table.get("zero")), gains, ..Default::default() }
}

fn input(name: &str, value: &Value) -> InputSource {
    let (unit, value) = match value {
        Value::Table(table) => (text_of(table, "unit"), text_of(table, "value")),
        unit => (unit.as_str().map(Text::from), None),
    };
    InputSource { name: name.into(), unit: unit.expect("a unit"), value }
}

fn event(table: &Table) -> EventSource {
    let set = self::table(table, "set");
    let set = set.iter().map(|(name, value)| (name.as_str(), value.as_str().expect("a text")).into()).collect();
    let ends = table.get("end").and_then(Value::as_bool).unwrap_or(false);
    let [when, direction] = ["when", "direction"].map(|key| text_of(table, key));
    EventSource { when: when.expect("an event has a condition"), direction, set, ends, ..Default::default() }
}
