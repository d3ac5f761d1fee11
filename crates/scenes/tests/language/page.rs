//! The chapter `language.md` of the book, made of the schema, of the functions of expressions, of the units and of the motors.

use super::examples::CRANE;
use super::expressions::{functions, operators, units};
use super::motors::motors;
use super::schema::schema;
use super::sections::{Cell, Section, sections};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const HEAD: &str = "# Reference of the language

Every table and key of a system as text, in the order in which a file is usually written, then expressions, units and motors. [Your own system](own-system.md) is
the way in; this chapter is for looking up. A test makes it of the tables that the reader of files is checked against: it lists all keys, and each example is read.

Examples belong to this system, to a circuit with the charge `q`, or to a body with the free frame `F`:

```toml
";

const COLUMNS: &str = "
The column \"kind, unit\" says what a key holds. A scalar, a vector, a point is an [expression](#expressions); a number with its unit is a text such as `\"20 mm\"`. The column
\"left out\" has the value that holds without the key.

";

/// The page as the schemas, the functions, the units and the motors have it.
fn page() -> String {
    let (model, paper) = (schema(), paper());
    let (of_systems, of_papers) = (sections(&model, &json!({})), sections(&paper, &model));
    let mut page = format!("{HEAD}{CRANE}```\n{COLUMNS}## Tables of a system\n");
    of_systems.iter().for_each(|section| write(&mut page, section, "Keys above all tables"));
    page.push_str("\n## Expressions\n\n");
    operators(&mut page);
    page.push_str("\n## Functions\n\n");
    functions(&mut page);
    page.push_str("\n## Units\n\nA unit is a product of these with whole powers: `kg m^2/s^2`, `N/m`, `km/h`. One slash divides by what follows it directly. `Hz` is refused, since it may mean turns or radians per second: `rev/s` or `rad/s`. `lb` is the pound of mass, `lbf` that of force; `rev` is a turn.\n\n");
    units(&mut page);
    page.push_str("\n## Motors\n\n`[drive.machine]` has the name of one of these motors as `model`, and the motor's data as keys. They become parameters of the system, `winch_voltage` of the drive `winch`.\n\n");
    motors(&mut page);
    page.push_str("## Tables of a paper\n\n[Check a paper's equations](judging.md) has the meaning of letters and kinds. The tables of the system stand in the same file, or in the file that `model` names.\n");
    of_papers.iter().for_each(|section| write(&mut page, section, "Keys of a paper above all tables"));
    page.push_str("\n## Index of keys and tables\n\n");
    index(&mut page, of_systems.iter().chain(&of_papers));
    page
}

fn paper() -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schema/paper.schema.json");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).expect("it is JSON")
}

/// The anchor of a heading, as Markdown makes it.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|letter| letter.is_alphanumeric() || matches!(letter, ' ' | '-' | '_'));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

fn write(page: &mut String, section: &Section, top: &str) {
    if section.rows.is_empty() {
        return;
    }
    // writing to a string cannot fail
    let _ = match &section.heading {
        Some(heading) => writeln!(page, "\n### `{heading}`\n\n{}\n", section.description),
        None => writeln!(page, "\n### {top}\n"),
    };
    if let Some(needed) = &section.needed {
        let _ = writeln!(page, "Needed: {needed}.\n");
    }
    page.push_str("| key | meaning | kind, unit | left out | example |\n|---|---|---|---|---|\n");
    for row in &section.rows {
        let example = match &row.example {
            Cell::Lines(lines) => lines.iter().map(|line| format!("`{line}`")).collect::<Vec<_>>().join("<br>"),
            Cell::Table(heading) => format!("[`{heading}`](#{})", anchor(heading)),
        };
        let cells = [&format!("`{}`", row.name()), &row.meaning, &row.unit, &row.absent, &example];
        let _ = writeln!(page, "| {} |", cells.map(|cell| cell.replace('|', "\\|")).join(" | "));
    }
}

fn index<'a>(page: &mut String, sections: impl Iterator<Item = &'a Section>) {
    let mut places: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for section in sections {
        let heading = section.heading.as_deref().unwrap_or("Keys above all tables");
        let name = heading.trim_matches(['[', ']']).split('.').rfind(|part| *part != "NAME");
        if let Some(table) = name.filter(|_| section.heading.is_some()) {
            places.entry(table).or_default().push(heading);
        }
        for key in section.rows.iter().filter_map(|row| row.key.as_deref()) {
            places.entry(key).or_default().push(heading);
        }
    }
    for (key, headings) in places {
        let links: Vec<String> =
            headings.iter().map(|heading| format!("[`{heading}`](#{})", anchor(heading))).collect();
        let _ = writeln!(page, "* `{key}`: {}", links.join(", ").replace("`Keys above all tables`", "top of the file"));
    }
}

#[test]
fn every_key_of_the_reference_has_an_example() {
    let (model, paper) = (schema(), paper());
    for section in sections(&model, &json!({})).iter().chain(&sections(&paper, &model)) {
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
