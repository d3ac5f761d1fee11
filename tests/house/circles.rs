//! Modules that depend on each other in a cycle: none in the crates with content, and elsewhere no more than are listed
//! here.

use crate::rules::{read, root, rust_files};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Folders with the number of their modules that belong to cycles; in all other folders there is none.
const KNOWN: &[(&str, usize)] = &[
    ("crates/commands/src", 25),
    ("crates/model/src", 11),
    ("crates/motor/src", 2),
    ("crates/native/src", 2),
    ("crates/scenes/src", 12),
    ("crates/series/src", 10),
];

type Graph = BTreeMap<String, BTreeSet<String>>;

/// The modules of a crate, each with the modules that it uses.
fn graph(folder: &Path) -> Graph {
    let mut graph = Graph::new();
    for file in rust_files(folder) {
        let place = file.strip_prefix(folder).expect("it lies there").with_extension("");
        let mut names: Vec<&str> = place.iter().filter_map(|part| part.to_str()).collect();
        names.pop_if(|last| *last == "mod");
        if matches!(names[..], ["lib" | "main"]) {
            continue;
        }
        let code: String =
            read(&file).lines().map(|line| line.split("//").next().unwrap_or("").to_owned() + "\n").collect();
        let code = code.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
        graph.entry(names[0].to_owned()).or_default().extend(used(code, names.len()));
    }
    let modules: BTreeSet<String> = graph.keys().cloned().collect();
    for (module, uses) in &mut graph {
        uses.retain(|used| modules.contains(used) && used != module);
    }
    graph
}

/// The names that follow `crate::`, or as many `super::` as lead to the root of the crate.
fn used(code: &str, depth: usize) -> Vec<String> {
    let to_root = "super::".repeat(depth);
    let mut names = Vec::new();
    for prefix in ["crate::", &to_root] {
        for (place, _) in code.match_indices(prefix) {
            let before = code[..place].chars().next_back();
            let rest = &code[place + prefix.len()..];
            let goes_on = prefix != "crate::" && (code[..place].ends_with("super::") || rest.starts_with("super::"));
            if before.is_some_and(|letter| letter.is_alphanumeric() || letter == '_') || goes_on {
                continue;
            }
            let list = match rest.strip_prefix('{') {
                Some(list) => list.split('}').next().unwrap_or_default(),
                None => {
                    rest.split(|letter: char| !letter.is_alphanumeric() && letter != '_').next().unwrap_or_default()
                }
            };
            names.extend(list.split(',').filter_map(|name| name.trim().split("::").next()).map(str::to_owned));
        }
    }
    names
}

/// The modules from which a path leads back to themselves.
fn in_circles(graph: &Graph) -> Vec<&String> {
    let comes_back = |module: &&String| {
        let (mut open, mut seen) = (vec![*module], BTreeSet::new());
        while let Some(one) = open.pop() {
            open.extend(graph[one].iter().filter(|used| seen.insert(*used)));
        }
        seen.contains(*module)
    };
    graph.keys().filter(comes_back).collect()
}

#[test]
fn modules_of_the_content_use_each_other_in_no_circle_and_others_in_none_that_is_new() {
    let crates = ["crates", "derivations"].map(|part| std::fs::read_dir(root().join(part)).expect("there are crates"));
    let places = crates.into_iter().flatten().map(|entry| entry.expect("an entry").path().join("src"));
    for place in places.filter(|place| place.is_dir()) {
        let folder = place.strip_prefix(root()).expect("it lies there").to_string_lossy().into_owned();
        let graph = graph(&root().join(&folder));
        let known = KNOWN.iter().find(|(known, _)| *known == folder).map_or(0, |(_, count)| *count);
        let found = in_circles(&graph);
        assert_eq!(found.len(), known, "{folder}: {found:?}");
    }
}
