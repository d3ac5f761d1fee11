//! Entries of a file that differ, by their keys.

use std::collections::BTreeMap;
use toml::{Table, Value};

/// Entries that other parts tell better: parameters by their names, claims by their verdicts; texts for reading.
const TOLD_ELSEWHERE: [&str; 5] = ["title", "description", "parameters", "claim", "citation"];

/// Every entry that came, went, or has another value; nothing of texts that are no TOML.
pub(super) fn changes(texts: [&str; 2]) -> Vec<String> {
    let [Some(old), Some(new)] = texts.map(entries) else { return Vec::new() };
    let moved = new.iter().filter(|(key, value)| old.get(*key) != Some(value)).map(|(key, value)| match old.get(key) {
        Some(before) => format!("{key}: {before} before, {value} now"),
        None => format!("{key}: new, {value}"),
    });
    let gone =
        old.iter().filter(|(key, _)| !new.contains_key(*key)).map(|(key, value)| format!("{key}: gone, {value}"));
    moved.chain(gone).collect()
}

fn entries(text: &str) -> Option<BTreeMap<String, String>> {
    let table: Table = text.parse().ok()?;
    let mut all = BTreeMap::new();
    for (key, value) in table.iter().filter(|(key, _)| !TOLD_ELSEWHERE.contains(&key.as_str())) {
        add(key, value, &mut all);
    }
    Some(all)
}

fn add(key: &str, value: &Value, all: &mut BTreeMap<String, String>) {
    match value {
        Value::Table(table) => table.iter().for_each(|(name, value)| add(&format!("{key}.{name}"), value, all)),
        Value::Array(values) if values.iter().any(Value::is_table) => {
            values.iter().enumerate().for_each(|(place, value)| add(&format!("{key} {}", place + 1), value, all));
        }
        other => drop(all.insert(key.to_owned(), other.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::changes;

    #[test]
    fn entries_are_told_by_their_keys() {
        let old = "[run]\nspan = \"1 s\"\n[[contact]]\nfriction = \"0.2\"\n";
        let new = "[run]\nspan = \"2 s\"\n[[contact]]\nfriction = \"0.2\"\none_sided = true\n";
        let wanted = ["contact 1.one_sided: new, true", "run.span: \"1 s\" before, \"2 s\" now"];
        assert_eq!(changes([old, new]), wanted);
    }
}
