//! Every example in the reference of the language is read as a part of one of a few systems.

use super::expressions::{CONSTANTS, OPERATORS};
use super::schema::{refused, schema};
use super::sections::table;
use super::values::{file, of_text};
use dalembert_scenes::{FailureEntry, ModelScene, Task, parse_ensemble, parse_titled};
use model::expression::FUNCTIONS;
use serde_json::{Value, json};
use std::collections::BTreeMap;

pub const CRANE: &str = include_str!("crane.toml");
const CIRCUIT: &str = include_str!("circuit.toml");
/// Systems with a free frame, with additional knowledge (`known_as`), and with a failure.
const OTHERS: [&str; 3] = [
    include_str!("../../../../scenes/models/tumbling_body.toml"),
    include_str!("../../../../scenes/drive/stiff_diode.toml"),
    include_str!("../../../../scenes/failures/bounces.toml"),
];

/// The error with which the reader of a file refuses it; `None` if it is read.
fn wrong(text: &str, tables: &Value) -> Option<String> {
    let failed = |error: reader::SceneError| error.to_string();
    let is_valued = !text.contains("[N/m]") && tables["inputs"]["u"] != "N";
    match () {
        () if tables.get("failure").is_some() => FailureEntry::parse("scene.toml", text).map(drop).map_err(failed),
        () if tables.get("ensemble").is_some() => parse_ensemble("scene.toml", text).map(drop).map_err(failed),
        () if is_valued => ModelScene::parse("scene.toml", text).map(drop).map_err(failed),
        () => parse_titled("scene.toml", text, Task::Write).map(drop).map_err(failed),
    }
    .err()
}

/// A system with additional entries in one of its tables, or appended to its list of such tables.
fn with(system: &str, table: &str, entries: &Value, several: bool) -> Value {
    let mut tables = of_text(system);
    let own = &mut tables[table];
    match (own, entries) {
        (Value::Array(own), entries) => own.push(entries.clone()),
        (Value::Object(own), Value::Object(entries)) => own.extend(entries.clone()),
        (own, entries) if several => *own = json!([entries]),
        (own, entries) => *own = entries.clone(),
    }
    tables
}

fn is_read(of: &str, systems: &[Value]) {
    let mut reasons = Vec::new();
    for tables in systems {
        match wrong(&file(tables), tables) {
            None => return,
            Some(reason) => reasons.push(reason),
        }
    }
    panic!("{of} is read in no system:\n{}", reasons.join("\n"));
}

#[test]
fn every_example_of_the_schema_is_read() {
    let schema = schema();
    let systems = || [CRANE, CIRCUIT].into_iter().chain(OTHERS);
    for example in schema["examples"].as_array().expect("examples") {
        let with_keys = |system: &str| {
            let mut tables = of_text(system);
            tables.as_object_mut().expect("tables").extend(example.as_object().expect("keys").clone());
            tables
        };
        is_read(&example.to_string(), &systems().map(with_keys).collect::<Vec<_>>());
    }
    for (table, of_table) in schema["properties"].as_object().expect("tables") {
        let several = of_table["type"] == "array";
        let examples = if several { &of_table["items"]["examples"] } else { &of_table["examples"] };
        for example in examples.as_array().into_iter().flatten() {
            let told = format!("[{table}] {example}");
            let schema = if several { &of_table["items"] } else { of_table };
            assert_eq!(refused(schema, example, ""), Vec::<String>::new(), "{told}");
            is_read(&told, &systems().map(|system| with(system, table, example, several)).collect::<Vec<_>>());
        }
    }
}

/// For each key with a default, the example of a table with this default as the value of the key; each with the path of the key.
fn with_defaults(root: &Value, schema: &Value, example: &Value) -> Vec<(String, Value)> {
    let (Some((keys, _)), Some(entries)) = (table(root, schema), example.as_object()) else { return Vec::new() };
    let mut all = Vec::new();
    for (key, value) in entries {
        let (way, schema) = match keys["properties"].get(key) {
            Some(schema) => (key.as_str(), schema),
            None => ("NAME", &keys["additionalProperties"]),
        };
        let inner: Vec<(String, Value)> = match value {
            Value::Array(items) => {
                let items = items.iter().flat_map(|item| with_defaults(root, schema, item));
                items.map(|(way, item)| (way, json!([item]))).collect()
            }
            value => with_defaults(root, schema, value),
        };
        let own = schema.get("default").map(|default| (String::new(), default.clone()));
        all.extend(own.into_iter().chain(inner).map(|(inside, value)| {
            let mut example = example.clone();
            example[key] = value;
            (format!("{way}.{inside}"), example)
        }));
    }
    all
}

#[test]
fn every_default_of_the_schema_can_be_written() {
    let schema = schema();
    let mut ways: BTreeMap<String, Vec<Value>> = BTreeMap::new();
    for (name, of_table) in schema["properties"].as_object().expect("tables") {
        let several = of_table["type"] == "array";
        let examples = if several { &of_table["items"]["examples"] } else { &of_table["examples"] };
        let examples = examples.as_array().into_iter().flatten();
        for (way, example) in examples.flat_map(|example| with_defaults(&schema, of_table, example)) {
            let systems = [CRANE, CIRCUIT].into_iter().chain(OTHERS);
            let systems = systems.map(|system| with(system, name, &example, several));
            ways.entry(format!("{name}.{way}")).or_default().extend(systems);
        }
    }
    ways.iter().for_each(|(way, systems)| is_read(&format!("the default of {way}"), systems));
    assert!(ways.len() > 20, "{:?}", ways.keys());
}

/// The crane, the crane with a constraint and with a contact from the examples of the schema, and a free body.
fn systems_of_expressions() -> [Value; 4] {
    let schema = schema();
    let first = |table: &str| schema["properties"][table]["items"]["examples"][0].clone();
    let with = |table: &str| with(CRANE, table, &first(table), true);
    [of_text(CRANE), with("constraint"), with("contact"), of_text(OTHERS[0])]
}

#[test]
fn every_example_of_an_expression_is_read() {
    let functions = FUNCTIONS.iter().map(|function| (function.name, function.example));
    let operators = OPERATORS.iter().chain(CONSTANTS).map(|row| (row.name, row.example));
    for (name, example) in functions.chain(operators) {
        assert!(!example.is_empty(), "{name} has no example");
        let shown = |mut tables: Value| {
            tables["outputs"] = json!({ "shown": example });
            tables
        };
        is_read(&format!("`{example}`"), &systems_of_expressions().map(shown));
    }
    for function in &FUNCTIONS {
        assert!(function.example.contains(&format!("{}(", function.name)), "{}", function.name);
    }
}
