//! The JSON schema of scenes with a built-in gyrostat or bench; keys of runs and ensembles come from the schema of systems.

use super::schema::{refused, schema};
use super::values::{file, of_text};
use reader::Allowed;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use studies::scene::Scene;

const SPIN_UP: &str = include_str!("../../../../scenes/spin_up.toml");

fn key(unit: &str, description: &str) -> Value {
    optional(unit, description, "needed")
}

/// A key that only gyrostats have.
fn of_gyrostat(unit: &str, description: &str) -> Value {
    optional(unit, description, "needed; a bench has none")
}

fn optional(unit: &str, description: &str, absent: &str) -> Value {
    json!({ "type": "string", "description": description, "unit": unit, "absent": absent })
}

fn table(description: &str, keys: &Value, example: &Value) -> Value {
    json!({ "type": "object", "description": description, "properties": keys, "additionalProperties": false, "examples": [example] })
}

/// The tables that only these scenes have.
fn own() -> Value {
    let carrier = json!({
        "mass": of_gyrostat("number, kg", "Mass of the carrier."),
        "centre": of_gyrostat("three numbers, m", "Vector from the fixed point O to the carrier's centre of mass."),
        "inertia": of_gyrostat("three rows of three numbers, kg m^2", "Inertia tensor of the carrier about O, its rows with semicolons between."),
    });
    let rotor = json!({
        "mass": of_gyrostat("number, kg", "Mass of the rotor."),
        "centre": of_gyrostat("three numbers, m", "Vector from O to the rotor's centre of mass."),
        "axis": of_gyrostat("three numbers", "Unit vector of the rotor's axis."),
        "axial": key("number, kg m^2", "Moment of inertia of the rotor about its axis."),
        "transverse": of_gyrostat("number, kg m^2", "Moment of inertia of the rotor across its axis."),
    });
    let start = json!({
        "angular_velocity": of_gyrostat("three numbers, rad/s", "Angular velocity of the carrier."),
        "vertical": of_gyrostat("three numbers", "Unit vector of the vertical, downwards."),
        "rotor_angle": optional("number, rad", "Angle of the rotor against the stator's field.", "`0`"),
        "rotor_speed": optional("number, rad/s", "Speed of the rotor relative to the carrier.", "needed, but for a machine that keeps a speed"),
        "currents": optional("numbers, A", "Current of each winding, in the order of the states; of an excitation less its constant part.", "`0`"),
    });
    let mut example = of_text(SPIN_UP);
    let tensor = example["carrier"]["inertia"].as_str().expect("a text").split_whitespace();
    example["carrier"]["inertia"] = json!(tensor.collect::<Vec<_>>().join(" "));
    let mut starts = example["start"].clone();
    starts["currents"] = json!("0 0 0 0 0 0 0 0 0 A");
    json!({
        "system": {
            "enum": ["gyrostat", "bench"],
            "description": "A heavy gyrostat with a fixed point and a motor that drives its rotor, or a motor alone, its housing at rest.",
        },
        "allow": {
            "type": "array",
            "items": { "enum": Allowed::WORDS },
            "description": "Data of the motor that are usually a mistake: \"zero resistance\", \"negative resistance\", \"negative friction\", \"separate fluxes\".",
            "unit": "names",
        },
        "gravity": of_gyrostat("number, m/s^2", "Acceleration of free fall."),
        "carrier": table("The body with the fixed point O; none on a bench.", &carrier, &example["carrier"]),
        "rotor": table("The balanced rotor.", &rotor, &example["rotor"]),
        "machine": {
            "type": "object",
            "description": "The motor, by its name; its data stand beside the name, as under Motors.",
            "properties": { "model": key("name", "The name of a motor, or text for one that is written in this file.") },
            "required": ["model"],
            "examples": [example["machine"]],
        },
        "start": table("The initial state.", &start, &starts),
    })
}

/// The keys in common with systems as text.
const SHARED: [&str; 2] = ["title", "description"];

fn made() -> Value {
    let model = schema();
    let mut keys = json!({});
    for key in SHARED {
        keys[key] = model["properties"][key].clone();
    }
    for (key, value) in own().as_object().expect("tables") {
        keys[key] = value.clone();
    }
    keys["run"] = model["properties"]["run"].clone();
    let ensemble = &model["properties"]["ensemble"]["properties"];
    let vary = json!({ "type": "object", "description": "The numbers that differ from member to member, by their tables, such as rotor.axial." });
    keys["ensemble"] = json!({
        "type": "object",
        "description": model["properties"]["ensemble"]["description"],
        "properties": { "members": ensemble["members"], "seed": ensemble["seed"], "vary": vary },
        "additionalProperties": false,
    });
    json!({
        "$schema": model["$schema"],
        "title": "A gyrostat or a bench with a motor",
        "description": "A scene of a built-in system with a motor, which drives the rotor of a gyrostat or turns on a bench.",
        "type": "object",
        "required": ["title", "system", "rotor", "machine", "start", "run"],
        "additionalProperties": false,
        "properties": keys,
        "examples": [{ "system": "gyrostat", "allow": ["zero resistance"], "gravity": "9.81 m/s^2" }],
        "$defs": { "expression": model["$defs"]["expression"] },
    })
}

fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schema/gyrostat.schema.json")
}

/// The stored schema.
pub fn stored() -> Value {
    let text = std::fs::read_to_string(path()).unwrap_or_else(|error| panic!("{}: {error}", path().display()));
    serde_json::from_str(&text).expect("it is JSON")
}

#[test]
fn the_schema_of_gyrostats_is_made_of_the_tables() {
    let made = format!("{}\n", serde_json::to_string_pretty(&made()).expect("it is written"));
    if std::env::var_os("UPDATE_SCHEMA").is_some() {
        std::fs::write(path(), &made).expect("it is written");
    }
    let stored = std::fs::read_to_string(path()).unwrap_or_default();
    assert!(stored == made, "UPDATE_SCHEMA=1 writes {} anew", path().display());
}

#[test]
fn every_scene_of_a_gyrostat_has_keys_of_the_schema() {
    let (schema, mut count) = (made(), 0);
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let folders = ["", "machines", "closed_forms", "ensembles", "failures"].map(|folder| scenes.join(folder));
    for file in folders.iter().flat_map(|folder| std::fs::read_dir(folder).expect("it is there")) {
        let path = file.expect("it can be listed").path();
        let text = match path.extension() {
            Some(end) if end == "toml" => std::fs::read_to_string(&path).expect("it is text"),
            _ => continue,
        };
        if text.contains("\nsystem = \"") {
            assert_eq!(refused(&schema, &of_text(&text), ""), Vec::<String>::new(), "{}", path.display());
            count += 1;
        }
    }
    assert!(count >= 20, "{count}");
}

/// The keys that the reader lists as known in a table, in its message about an unknown key.
fn known(heading: &str) -> BTreeSet<String> {
    let key = "unheard_of_key = 1\n";
    let text = match heading {
        "" => format!("{key}{SPIN_UP}"),
        table => SPIN_UP.replace(&format!("[{table}]\n"), &format!("[{table}]\n{key}")),
    };
    let error = reader::parse::<Scene>("scene.toml", &text).expect_err("a key is not known");
    let issue = error.issues.iter().find(|issue| issue.title.contains("`unheard_of_key`")).expect("it is told");
    let list = issue.help.as_deref().and_then(|help| help.strip_prefix("known here: ")).expect("a list");
    list.split(", ").map(str::to_owned).collect()
}

#[test]
fn the_schema_of_gyrostats_has_every_key_that_the_reader_knows() {
    let schema = made();
    let keys = |keys: &Value| -> BTreeSet<String> { keys.as_object().expect("keys").keys().cloned().collect() };
    assert_eq!(known(""), keys(&schema["properties"]));
    for table in ["carrier", "rotor", "start"] {
        assert_eq!(known(table), keys(&schema["properties"][table]["properties"]), "{table}");
    }
}

#[test]
fn every_example_of_a_gyrostat_is_read() {
    let mut tables = of_text(SPIN_UP);
    for (table, of_table) in own().as_object().expect("tables") {
        if let Some(example) = of_table["examples"].get(0) {
            tables[table] = example.clone();
        }
    }
    for (key, value) in made()["examples"][0].as_object().expect("keys") {
        tables[key] = value.clone();
    }
    reader::parse::<Scene>("scene.toml", &file(&tables)).unwrap_or_else(|error| panic!("{error}"));
}
