//! Conversion of TOML values to JSON, and of JSON values to TOML texts.

use serde_json::{Map, Value, json};
use toml::de::{DeTable, DeValue};

fn of_table(table: &DeTable<'_>) -> Value {
    let entries = table.iter().map(|(key, value)| (key.get_ref().to_string(), of_value(value.get_ref())));
    Value::Object(entries.collect::<Map<_, _>>())
}

fn of_value(value: &DeValue<'_>) -> Value {
    match value {
        DeValue::String(text) => json!(text),
        DeValue::Integer(number) => json!(number.as_str().parse::<i64>().expect("a decimal number")),
        DeValue::Float(number) => json!(number.as_str().parse::<f64>().expect("a number")),
        DeValue::Boolean(value) => json!(value),
        DeValue::Datetime(time) => json!(time.to_string()),
        DeValue::Array(items) => items.iter().map(|item| of_value(item.get_ref())).collect(),
        DeValue::Table(table) => of_table(table),
    }
}

/// The tables of a TOML text as JSON.
pub fn of_text(text: &str) -> Value {
    of_table(DeTable::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}")).get_ref())
}

/// A key of TOML, in quotes if it contains other characters than letters, digits, `_` and `-`.
pub fn key(name: &str) -> String {
    let is_bare = name.chars().all(|letter| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '-'));
    if is_bare { name.to_owned() } else { written(&json!(name)) }
}

/// A value as one line of TOML.
pub fn written(value: &Value) -> String {
    let list = |items: Vec<String>| items.join(", ");
    match value {
        Value::String(text) if text.contains('\\') => format!("'{text}'"),
        Value::Array(items) => format!("[{}]", list(items.iter().map(written).collect())),
        Value::Object(entries) => {
            format!("{{ {} }}", list(entries.iter().map(|(name, value)| entry(name, value)).collect()))
        }
        other => other.to_string(),
    }
}

/// A line `key = value`.
pub fn entry(name: &str, value: &Value) -> String {
    format!("{} = {}", key(name), written(value))
}

/// A TOML file with these tables.
pub fn file(tables: &Value) -> String {
    let entries = tables.as_object().expect("tables");
    entries.iter().map(|(name, value)| entry(name, value) + "\n").collect()
}
