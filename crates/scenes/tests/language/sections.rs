//! The schema as sections of the reference: one for each table, with a row for each key.

use super::values::entry;
use serde_json::Value;

/// A step in the path of a key from the top level of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    Key(String),
    /// A name that the author of a file chooses.
    Name,
}

/// A table of the language, as a section of the reference.
pub struct Section {
    /// The heading in TOML, `[run]` or `[[force]]`; `None` for the keys above all tables.
    pub heading: Option<String>,
    /// The kind of file with this table, as an addition to the heading; empty for systems as text.
    pub of: &'static str,
    pub description: String,
    /// The required keys, as text.
    pub needed: Option<String>,
    pub rows: Vec<Row>,
}

/// A key of a table, as a row of the reference.
pub struct Row {
    /// The key; `None` for a name that the author chooses.
    pub key: Option<String>,
    pub meaning: String,
    pub unit: String,
    /// The meaning of leaving the key out.
    pub absent: String,
    pub example: Cell,
}

/// The example of a key.
pub enum Cell {
    /// Lines of TOML.
    Lines(Vec<String>),
    /// The heading of a table with a section of its own.
    Table(String),
}

/// The sections of a schema, without the top-level keys of the schema `known`.
pub fn sections(schema: &Value, known: &Value, of: &'static str) -> Vec<Section> {
    let is_new = |key: &str| known["properties"].get(key).is_none();
    let all = schema["properties"].as_object().expect("keys");
    let (tables, keys): (Vec<_>, Vec<_>) =
        all.iter().filter(|(key, _)| is_new(key)).partition(|(_, value)| table(schema, value).is_some());
    let needed = schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect::<Vec<_>>();
    let rows = keys.iter().map(|(key, value)| row(schema, key, value, &[], &needed, &[])).collect();
    let mut found = vec![Section { heading: None, of, description: String::new(), needed: None, rows }];
    for (key, value) in tables {
        push(&mut found, schema, &[Step::Key(key.clone())], value);
    }
    found.iter_mut().for_each(|section| section.of = of);
    found
}

/// The schema that a `$ref` points to; other schemas are returned unchanged.
fn resolved<'a>(root: &'a Value, schema: &'a Value) -> &'a Value {
    let place = schema["$ref"].as_str().and_then(|place| place.strip_prefix('#'));
    place.and_then(|place| root.pointer(place)).unwrap_or(schema)
}

/// The schema of a table, if a value is or may be one, and whether it is a list of tables.
pub fn table<'a>(root: &'a Value, schema: &'a Value) -> Option<(&'a Value, bool)> {
    let schema = resolved(root, schema);
    let holds_keys = |schema: &Value| schema["properties"].is_object() || schema["additionalProperties"].is_object();
    if holds_keys(schema) {
        return Some((schema, false));
    }
    if schema["type"] == "array" {
        return Some((resolved(root, &schema["items"]), true)).filter(|(items, _)| holds_keys(items));
    }
    let choices = schema["anyOf"].as_array()?;
    choices.iter().map(|choice| resolved(root, choice)).find(|choice| holds_keys(choice)).map(|choice| (choice, false))
}

fn push(found: &mut Vec<Section>, root: &Value, path: &[Step], schema: &Value) {
    let Some((keys, several)) = table(root, schema) else { return };
    let needed: Vec<&str> = names(&keys["required"]).collect();
    let choices: Vec<Vec<&str>> = ["oneOf", "anyOf"]
        .iter()
        .filter_map(|word| keys[word].as_array())
        .flat_map(|all| all.iter().map(|choice| names(&choice["required"]).collect()))
        .collect();
    let mut rows = Vec::new();
    let mut inner = Vec::new();
    for (key, value) in keys["properties"].as_object().into_iter().flatten() {
        rows.push(row(root, key, value, path, &needed, &choices));
        if table(root, value).is_some() {
            inner.push(([path, &[Step::Key(key.clone())]].concat(), value));
        }
    }
    let free = &keys["additionalProperties"];
    let is_table = table(root, free).is_some() && free["anyOf"].is_null();
    if free.is_object() && !is_table {
        let example = Cell::Lines(lines(root, path, None));
        rows.push(described(free, absent(free, "none"), None, example));
    }
    if table(root, free).is_some() {
        inner.push(([path, &[Step::Name]].concat(), free));
    }
    // a table that contains only tables is described by their sections
    if !rows.is_empty() {
        let text = |schema: &Value| schema["description"].as_str().unwrap_or_default().to_owned();
        let (outer, own) = (text(schema), text(keys));
        let description = match (several, outer.as_str(), own.as_str()) {
            (true, outer, own) if outer != own => format!("{outer} {own}"),
            (_, outer, "") => outer.to_owned(),
            (_, _, own) => own.to_owned(),
        };
        let heading = Some(heading(path, several));
        found.push(Section { heading, of: "", description, needed: in_words(&needed, &choices), rows });
    }
    for (path, schema) in inner {
        push(found, root, &path, schema);
    }
}

fn names(list: &Value) -> impl Iterator<Item = &str> {
    list.as_array().into_iter().flatten().filter_map(Value::as_str)
}

fn heading(path: &[Step], several: bool) -> String {
    let parts: Vec<&str> = path
        .iter()
        .map(|step| match step {
            Step::Key(key) => key.as_str(),
            Step::Name => "NAME",
        })
        .collect();
    let name = parts.join(".");
    if several { format!("[[{name}]]") } else { format!("[{name}]") }
}

/// The required keys of a table as text; each of `choices` is an alternative set.
fn in_words(needed: &[&str], choices: &[Vec<&str>]) -> Option<String> {
    let quoted =
        |names: &[&str], between: &str| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(between);
    let all = choices.iter().map(|choice| quoted(choice, " with ")).collect::<Vec<_>>().join(", or ");
    match (needed, choices) {
        ([], []) => None,
        (needed, []) => Some(quoted(needed, ", ")),
        ([], _) => Some(all),
        (needed, _) => Some(format!("{}; {all}", quoted(needed, ", "))),
    }
}

fn row(root: &Value, key: &str, schema: &Value, path: &[Step], needed: &[&str], choices: &[Vec<&str>]) -> Row {
    let otherwise = match () {
        () if needed.contains(&key) => "needed",
        () if choices.iter().any(|choice| choice.contains(&key)) => "one of the choices above",
        () => "none",
    };
    let example = match table(root, schema) {
        Some((keys, several)) if schema["anyOf"].is_null() => {
            let holds_tables = keys["properties"].is_null() && table(root, &keys["additionalProperties"]).is_some();
            let name = if holds_tables { vec![Step::Name] } else { Vec::new() };
            Cell::Table(heading(&[path, &[Step::Key(key.to_owned())], &name].concat(), several))
        }
        _ => Cell::Lines(lines(root, path, Some(key))),
    };
    described(schema, absent(schema, otherwise), Some(key.to_owned()), example)
}

/// The meaning of leaving a key out, as text: the default, or `absent` of the schema.
fn absent(schema: &Value, otherwise: &str) -> String {
    match (&schema["default"], schema["absent"].as_str()) {
        (_, Some(words)) => words.to_owned(),
        (Value::Null, None) => otherwise.to_owned(),
        (Value::String(text), None) => format!("`{text}`"),
        (value, None) => format!("`{value}`"),
    }
}

fn described(schema: &Value, absent: String, key: Option<String>, example: Cell) -> Row {
    let choices: Vec<String> = names(&schema["enum"]).map(|name| format!("`{name}`")).collect();
    let unit = match (schema["unit"].as_str(), schema["type"].as_str()) {
        (Some(unit), _) => unit.to_owned(),
        (None, _) if !choices.is_empty() => choices.join(", "),
        (None, Some("boolean")) => "`true`, `false`".to_owned(),
        (None, Some("array")) => "list of texts".to_owned(),
        (None, _) => "text".to_owned(),
    };
    Row { key, meaning: schema["description"].as_str().unwrap_or_default().to_owned(), unit, absent, example }
}

/// The line of the first example with a key; for a table with free names, the lines of all examples.
fn lines(root: &Value, path: &[Step], key: Option<&str>) -> Vec<String> {
    let tables = examples(root, path);
    let entries = tables.iter().filter_map(|table| table.as_object());
    match key {
        Some(key) => {
            let found = entries.filter_map(|table| table.get(key)).next();
            found.map(|value| entry(key, value)).into_iter().collect()
        }
        None => entries
            .flatten()
            .filter(|(name, value)| !value.is_object() && table_key(root, path, name).is_none())
            .map(|(name, value)| entry(name, value))
            .collect(),
    }
}

/// The schema of a fixed key in a table with otherwise free names.
fn table_key<'a>(root: &'a Value, path: &[Step], name: &str) -> Option<&'a Value> {
    let [Step::Key(top)] = path else { return None };
    root["properties"][top]["properties"].get(name)
}

/// All tables at a path, from all examples of the schema.
pub fn examples<'a>(root: &'a Value, path: &[Step]) -> Vec<&'a Value> {
    let Some((Step::Key(top), rest)) = path.split_first() else {
        return root["examples"].as_array().into_iter().flatten().collect();
    };
    let schema = &root["properties"][top];
    let all = [&schema["examples"], &schema["items"]["examples"]];
    let mut tables: Vec<&Value> = all.iter().filter_map(|examples| examples.as_array()).flatten().collect();
    for step in rest {
        tables = tables
            .into_iter()
            .flat_map(|table| match step {
                Step::Key(key) => table.get(key).into_iter().collect::<Vec<_>>(),
                Step::Name => table.as_object().into_iter().flat_map(|entries| entries.values()).collect(),
            })
            .flat_map(|value| value.as_array().map_or_else(|| vec![value], |items| items.iter().collect()))
            .collect();
    }
    tables
}

impl Row {
    /// The key as it is shown in the reference.
    pub fn name(&self) -> &str {
        self.key.as_deref().unwrap_or("NAME")
    }
}

impl Cell {
    /// Whether the cell is empty.
    pub fn is_empty(&self) -> bool {
        matches!(self, Cell::Lines(lines) if lines.is_empty())
    }
}
