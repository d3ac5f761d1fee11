//! Consistency of the list of mutants: each of them can be applied, and the reviewed table of detections corresponds to
//! the list.
//!
//! The run itself takes minutes: `tests/mutants/run.py`.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A mutant: a law with one change.
struct Mutant {
    file: String,
    name: String,
    old: String,
    new: String,
    /// The reason why no test can detect it.
    equivalent: Option<String>,
}

/// A row of the table.
struct Row<'a> {
    file: &'a str,
    name: &'a str,
    /// The numbers of claims and of tests that detect the mutant, and one of them; or another outcome.
    cells: Vec<&'a str>,
}

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The mutants in the order of the list.
fn mutants() -> Vec<Mutant> {
    let text = read("tests/mutants/mutants.toml");
    let table = DeTable::parse(&text).unwrap_or_else(|error| panic!("mutants.toml: {error}"));
    let files = in_order(table.get_ref()).into_iter();
    files
        .flat_map(|(file, mutants)| {
            let mutants = mutants.as_table().unwrap_or_else(|| panic!("{file} is no table of mutants"));
            in_order(mutants).into_iter().map(move |(name, texts)| mutant(file, name, texts))
        })
        .collect()
}

fn in_order<'a>(table: &'a DeTable<'a>) -> Vec<(&'a str, &'a DeValue<'a>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries.into_iter().map(|(key, value)| (key.get_ref().as_ref(), value.get_ref())).collect()
}

fn mutant(file: &str, name: &str, texts: &DeValue) -> Mutant {
    let texts: Option<Vec<String>> = texts
        .as_array()
        .and_then(|texts| texts.iter().map(Spanned::get_ref).map(|text| text.as_str().map(str::to_owned)).collect());
    let (old, new, equivalent) = match texts.as_deref() {
        Some([old, new]) => (old, new, None),
        Some([old, new, reason]) => (old, new, Some(reason.clone())),
        _ => panic!("{file}: {name}: [old, new] or [old, new, why nothing can notice it] is accepted"),
    };
    Mutant { file: file.into(), name: name.into(), old: old.clone(), new: new.clone(), equivalent }
}

fn rows(page: &str) -> Vec<Row<'_>> {
    let mut rows = Vec::new();
    for section in page.split("\n## ").skip(1) {
        let mut lines = section.lines();
        let file = lines.next().unwrap_or_default();
        for line in lines.filter(|line| line.starts_with("| ")).skip(1) {
            let mut cells = line.trim_matches(['|', ' ']).split(" | ");
            rows.push(Row { file, name: cells.next().unwrap_or_default(), cells: cells.collect() });
        }
    }
    rows
}

/// Whether some claim or some test detects the mutant.
fn caught(cells: &[&str]) -> bool {
    let [claims, laws, _one] = cells else { return false };
    [claims, laws].iter().filter_map(|count| count.parse::<u32>().ok()).sum::<u32>() > 0
}

#[test]
fn every_mutant_breaks_one_place() {
    for Mutant { file, name, old, new, .. } in mutants() {
        let count = read(&file).matches(&old).count();
        assert_eq!(count, 1, "{file}: {name}: `{old}` stands there {count} times, not once");
        assert_ne!(old, new, "{file}: {name} changes nothing");
    }
}

/// The page of a mutant: that of its crate, of its study, or, in a crate with many mutants, of its folder.
fn page_of(mutant: &Mutant) -> String {
    let parts: Vec<&str> = mutant.file.split('/').collect();
    match parts[..] {
        [_, "studies", _, study, ..] => study.trim_end_matches(".rs").to_owned(),
        [_, name @ ("model" | "scenes"), _, folder, _, ..] => format!("{name}_{folder}"),
        [_, name, ..] => name.to_owned(),
        _ => panic!("{} lies in no crate", mutant.file),
    }
}

#[test]
fn the_table_is_of_this_list_and_nothing_survived_without_a_reason() {
    let mut seen = 0;
    for of in mutants().iter().map(page_of).collect::<BTreeSet<String>>() {
        let page = read(&format!("snapshots/mutants/{of}.md"));
        let (mutants, rows) = (mutants().into_iter().filter(|mutant| page_of(mutant) == of), rows(&page));
        let mutants: Vec<Mutant> = mutants.collect();
        for (Mutant { file, name, equivalent, .. }, row) in mutants.iter().zip(&rows) {
            assert_eq!((row.file, row.name), (file.as_str(), name.as_str()), "run tests/mutants/run.py again");
            match equivalent {
                Some(reason) => assert_eq!(row.cells, [format!("equivalent: {reason}")], "{file}: {name}"),
                None => assert!(caught(&row.cells), "{file}: {name}: {:?}", row.cells),
            }
        }
        assert_eq!(rows.len(), mutants.len(), "run tests/mutants/run.py again");
        seen += rows.len();
    }
    assert_eq!(seen, mutants().len(), "a mutant of another folder");
}
