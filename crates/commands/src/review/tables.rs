//! Changes of the entries of a file, by their keys.

use std::collections::BTreeMap;
use toml::{Table, Value};

/// Keys that are left out: those that other parts of the review report, such as parameters and claims, and texts for readers.
const TOLD_ELSEWHERE: [&str; 5] = ["title", "description", "parameters", "claim", "citation"];

/// The entries that were added, removed or changed; empty where a text is not valid TOML.
pub(super) fn changes(texts: [&str; 2]) -> Vec<String> {
    let tables = texts.map(|text| text.parse::<Table>().ok());
    let [Some(old), Some(new)] = &tables else { return Vec::new() };
    let [old, new] = [entries(old, new), entries(new, old)];
    let moved = new.iter().filter(|(key, value)| old.get(*key) != Some(value)).map(|(key, value)| match old.get(key) {
        Some(before) => format!("{key}: {before} before, {value} now"),
        None => format!("{key}: new, {value}"),
    });
    let gone =
        old.iter().filter(|(key, _)| !new.contains_key(*key)).map(|(key, value)| format!("{key}: gone, {value}"));
    moved.chain(gone).collect()
}

/// The keys whose values identify an entry of a list.
const LABELS: [&str; 6] = ["name", "when", "of", "on", "between", "turns"];

/// The entries of a table by their keys. An entry of a list is identified by its label if the other table has this list too, otherwise by its index.
fn entries(table: &Table, other: &Table) -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    for (key, value) in table.iter().filter(|(key, _)| !TOLD_ELSEWHERE.contains(&key.as_str())) {
        add(key, value, other.get(key), &mut all);
    }
    all
}

fn add(key: &str, value: &Value, other: Option<&Value>, all: &mut BTreeMap<String, String>) {
    match value {
        Value::Table(table) => table.iter().for_each(|(name, value)| {
            add(&format!("{key}.{name}"), value, other.and_then(|other| other.get(name)), all);
        }),
        Value::Array(values) if values.iter().any(Value::is_table) => {
            let others = other.and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
            let is_known = |label: &String| [values, others].into_iter().all(|list| count(list, label) == 1);
            for (place, value) in values.iter().enumerate() {
                let name = match label(value).filter(is_known) {
                    Some(label) => format!("{key} `{label}`"),
                    None => format!("{key} {}", place + 1),
                };
                add(&name, value, None, all);
            }
        }
        other => drop(all.insert(key.to_owned(), other.to_string())),
    }
}

fn label(entry: &Value) -> Option<String> {
    let of = |word: &&str| match entry.get(word)? {
        Value::String(text) => Some(text.clone()),
        Value::Array(texts) => Some(texts.iter().filter_map(Value::as_str).collect::<Vec<_>>().join(", ")),
        _ => None,
    };
    LABELS.iter().find_map(of)
}

/// The number of entries of a list with this label.
fn count(list: &[Value], wanted: &str) -> usize {
    list.iter().filter(|entry| label(entry).is_some_and(|own| own == wanted)).count()
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

    #[test]
    fn entries_of_a_list_are_followed_by_what_they_are_about() {
        let floor = "[[contact]]\nname = \"floor\"\nfriction = \"0.2\"\n";
        let event = "[[event]]\nwhen = \"x - a\"\ndirection = \"up\"\n";
        let wall = "[[contact]]\nname = \"wall\"\nfriction = \"0.1\"\n";
        let old = format!("{floor}{event}");
        let new = format!("{wall}{}{event}", floor.replace("0.2", "0.3"));
        let told = changes([&old, &new]);
        assert_eq!(told[0], "contact 1.friction: new, \"0.1\"");
        assert_eq!(told[2], "contact `floor`.friction: \"0.2\" before, \"0.3\" now");
        assert_eq!(told.len(), 3, "{told:?}");
    }
}
