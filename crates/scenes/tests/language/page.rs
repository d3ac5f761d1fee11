//! The chapter `language.md` of the book, generated from the schemas and from the tables of functions, units and motors.

use super::examples::CRANE;
use super::expressions::{functions, operators, units};
use super::gyrostat::stored;
use super::motors::motors;
use super::schema::schema;
use super::sections::{Cell, Section, sections};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const HEAD: &str = "# Reference of the language

This chapter lists every table and key of a system as text, in the order in which a file is usually written. Expressions, functions, units, motors, and the tables of a paper follow.
[Your own system](own-system.md) introduces the language. A test generates this chapter from the tables with which it compares the reader of files: no key is missing, and each example and each default is read.
The [index](#index-of-keys-and-tables) leads from a key to its tables.

Scenes of a built-in gyrostat or bench have [tables of their own](#tables-of-a-gyrostat-or-a-bench).

Examples belong to this system, to a circuit with the charge `q`, or to a body with the free frame `F`:

```toml
";

const COLUMNS: &str = "
The column \"kind, unit\" says what a key holds. Scalars, vectors and points are [expressions](#expressions); a number with its unit is a text such as `\"20 mm\"`. The column
\"left out\" has the default value of the key.

";

/// The generated page.
fn page() -> String {
    let (model, paper) = (schema(), paper());
    let all = [
        sections(&model, &json!({}), ""),
        sections(&stored(), &shared(), OF_GYROSTATS),
        sections(&paper, &model, OF_PAPERS),
    ];
    let [of_systems, of_gyrostats, of_papers] = &all;
    let mut page = format!("{HEAD}{CRANE}```\n{COLUMNS}## Tables of a system\n");
    of_systems.iter().for_each(|section| write(&mut page, section));
    page.push_str("\n## Expressions\n\n");
    operators(&mut page);
    page.push_str("\n## Functions\n\n");
    functions(&mut page);
    page.push_str("\n## Units\n\nA unit is a product of the units below with integer powers: `kg m^2/s^2`, `N/m`, `km/h`. A slash divides by the next unit only, or by a product in parentheses: `N/(m s)`. `Hz` is refused, since it may mean turns or radians per second; write `rev/s` or `rad/s`. `lb` is the pound of mass, `lbf` that of force; `rev` is a turn.\n\n");
    units(&mut page);
    page.push_str("\n## Motors\n\n`[drive.machine]` has the name of one of these motors as `model`, and the motor's data as keys. The data become parameters of the system, such as `winch_voltage` for the drive `winch`.\n\n");
    motors(&mut page);
    page.push_str("## Tables of a paper\n\n[Check a paper's equations](judging.md) has the meaning of letters and kinds. The tables of the system stand in the same file, or in the file that `model` names.\n");
    of_papers.iter().for_each(|section| write(&mut page, section));
    page.push_str("\n## Tables of a gyrostat or a bench\n\nScenes with `system = \"gyrostat\"` or `system = \"bench\"`, such as `scenes/spin_up.toml` and `scenes/bench.toml`, have the tables below, `[run]` as above, and `[ensemble]` whose `vary` names data by their tables: `rotor.axial`, `start.rotor_angle`.\n");
    of_gyrostats.iter().for_each(|section| write(&mut page, section));
    page.push_str("\n## Index of keys and tables\n\n");
    index(&mut page, all.iter().flatten());
    page
}

fn paper() -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schema/paper.schema.json");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).expect("it is JSON")
}

/// Additions to the headings of files that are not systems as text.
const OF_GYROSTATS: &str = " of a gyrostat or a bench";
const OF_PAPERS: &str = " of a paper";

/// The tables of gyrostats that are described among those of systems.
fn shared() -> Value {
    json!({ "properties": { "title": {}, "description": {}, "run": {}, "ensemble": {} } })
}

impl Section {
    fn title(&self) -> String {
        match &self.heading {
            Some(heading) => format!("`{heading}`{}", self.of),
            None => format!("Keys above all tables{}", self.of),
        }
    }
}

/// The anchor of a heading in Markdown.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|letter| letter.is_alphanumeric() || matches!(letter, ' ' | '-' | '_'));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

fn write(page: &mut String, section: &Section) {
    if section.rows.is_empty() {
        return;
    }
    // writing to a string cannot fail
    let _ = writeln!(page, "\n### {}\n", section.title());
    if !section.description.is_empty() {
        let _ = writeln!(page, "{}\n", section.description);
    }
    if let Some(needed) = &section.needed {
        let _ = writeln!(page, "Needed: {needed}.\n");
    }
    page.push_str("| key | meaning | kind, unit | left out | example |\n|---|---|---|---|---|\n");
    for row in &section.rows {
        let example = match &row.example {
            Cell::Lines(lines) => lines.iter().map(|line| format!("`{line}`")).collect::<Vec<_>>().join("<br>"),
            Cell::Table(heading) => format!("[`{heading}`](#{})", anchor(&format!("{heading}{}", section.of))),
        };
        let cells = [&format!("`{}`", row.name()), &row.meaning, &row.unit, &row.absent, &example];
        let _ = writeln!(page, "| {} |", cells.map(|cell| cell.replace('|', "\\|")).join(" | "));
    }
}

fn index<'a>(page: &mut String, sections: impl Iterator<Item = &'a Section>) {
    let mut places: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for section in sections.filter(|section| !section.rows.is_empty()) {
        let link = format!("[{0}](#{1})", section.title(), anchor(&section.title()));
        let heading = section.heading.as_deref().unwrap_or_default();
        let name = heading.trim_matches(['[', ']']).split('.').rfind(|part| !matches!(*part, "NAME" | ""));
        for key in name.into_iter().chain(section.rows.iter().filter_map(|row| row.key.as_deref())) {
            places.entry(key).or_default().push(link.clone());
        }
    }
    for (key, links) in places {
        let _ = writeln!(page, "* `{key}`: {}", links.join(", "));
    }
}

#[test]
fn every_key_of_the_reference_has_an_example() {
    let (model, paper) = (schema(), paper());
    let all = [sections(&model, &json!({}), ""), sections(&stored(), &shared(), ""), sections(&paper, &model, "")];
    for section in all.iter().flatten() {
        for row in &section.rows {
            let heading = section.heading.as_deref().unwrap_or("the top");
            assert!(!row.example.is_empty(), "{heading}: {} has no example", row.name());
            assert!(!row.meaning.is_empty(), "{heading}: {} has no meaning", row.name());
        }
    }
}

#[test]
fn the_reference_in_the_book_is_made_of_the_tables() {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/language.md");
    let made = page();
    if std::env::var_os("UPDATE_BOOK").is_some() {
        std::fs::write(&path, &made).expect("it is written");
    }
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(stored == made, "UPDATE_BOOK=1 writes {} anew", path.display());
}
