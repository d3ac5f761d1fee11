//! The JSON schema for editors has exactly the keys of the reader, and accepts every system in the repository.

use super::values::of_text;
use dalembert_scenes::ModelScene;
use serde_json::Value;
use std::collections::BTreeSet;

pub const SCHEMA: &str = include_str!("../../../../schema/model.schema.json");

pub fn schema() -> Value {
    serde_json::from_str(SCHEMA).expect("it is JSON")
}

/// Whether a value has a type of JSON schemas.
fn is_of(kind: &str, value: &Value) -> bool {
    match kind {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64(),
        "boolean" => value.is_boolean(),
        other => panic!("no type is called {other}"),
    }
}

/// The parts of a value that a schema refuses, with their paths. Unknown keywords of the schema panic, so that all are checked.
pub fn refused(schema: &Value, value: &Value, way: &str) -> Vec<String> {
    let mut all = Vec::new();
    let number = |limit: &Value| limit.as_f64().expect("a limit");
    let length = value.as_array().map(Vec::len);
    for (keyword, says) in schema.as_object().expect("a schema") {
        let own = match keyword.as_str() {
            "title" | "description" | "$schema" | "$defs" | "examples" | "default" | "unit" | "absent" => Vec::new(),
            "$ref" => {
                let place = says.as_str().and_then(|place| place.strip_prefix('#')).expect("a place in this schema");
                let root = self::schema();
                refused(root.pointer(place).unwrap_or_else(|| panic!("{place}")), value, way)
            }
            "type" => {
                let kinds: Vec<&Value> = says.as_array().map_or_else(|| vec![says], |kinds| kinds.iter().collect());
                let fits = kinds.iter().any(|kind| is_of(kind.as_str().expect("a name"), value));
                wrong(fits, way, "another type")
            }
            "const" => wrong(says == value, way, "another value"),
            "enum" => wrong(says.as_array().expect("values").contains(value), way, "another value"),
            "minimum" => wrong(value.as_f64().is_none_or(|found| found >= number(says)), way, "too small"),
            "maximum" => wrong(value.as_f64().is_none_or(|found| found <= number(says)), way, "too large"),
            "exclusiveMaximum" => wrong(value.as_f64().is_none_or(|found| found < number(says)), way, "too large"),
            "minItems" => wrong(length.is_none_or(|found| found as f64 >= number(says)), way, "too few"),
            "maxItems" => wrong(length.is_none_or(|found| found as f64 <= number(says)), way, "too many"),
            "items" => {
                let items = value.as_array().into_iter().flatten().enumerate();
                items.flat_map(|(place, item)| refused(says, item, &format!("{way}/{place}"))).collect()
            }
            "required" => {
                let keys = says.as_array().expect("keys").iter().map(|key| key.as_str().expect("a key"));
                let absent = keys.filter(|key| value.is_object() && value.get(*key).is_none());
                absent.map(|key| format!("{way}: no {key}")).collect()
            }
            "properties" => {
                let known = says.as_object().expect("keys").iter();
                let there = known.filter_map(|(key, schema)| Some((key, schema, value.get(key)?)));
                there.flat_map(|(key, schema, value)| refused(schema, value, &format!("{way}/{key}"))).collect()
            }
            "additionalProperties" => {
                let is_known = |key: &str| schema["properties"].get(key).is_some();
                let others = value.as_object().into_iter().flatten().filter(|(key, _)| !is_known(key));
                match says {
                    Value::Bool(false) => others.map(|(key, _)| format!("{way}: unknown {key}")).collect(),
                    says => others.flat_map(|(key, value)| refused(says, value, &format!("{way}/{key}"))).collect(),
                }
            }
            "anyOf" | "oneOf" => {
                let fitting =
                    says.as_array().expect("schemas").iter().filter(|one| refused(one, value, way).is_empty());
                let count = fitting.count();
                wrong(if keyword == "oneOf" { count == 1 } else { count > 0 }, way, "none of the alternatives")
            }
            other => panic!("the keyword {other} is not checked here"),
        };
        all.extend(own);
    }
    all
}

fn wrong(fits: bool, way: &str, what: &str) -> Vec<String> {
    if fits { Vec::new() } else { vec![format!("{way}: {what}")] }
}

#[test]
fn every_file_of_the_project_is_accepted() {
    let mut count = 0;
    for folder in ["models", "foreign", "failures"] {
        let folder = format!("{}/../../scenes/{folder}", env!("CARGO_MANIFEST_DIR"));
        for file in std::fs::read_dir(folder).expect("it is there") {
            let path = file.expect("it can be listed").path();
            if path.extension().is_some_and(|end| end == "toml") {
                let text = std::fs::read_to_string(&path).expect("it is text");
                if !text.contains("[coordinates]") {
                    // a file with a named system
                    continue;
                }
                assert_eq!(refused(&schema(), &of_text(&text), ""), Vec::<String>::new(), "{}", path.display());
                count += 1;
            }
        }
    }
    assert!(count >= 9, "{count}");
}

#[test]
fn what_the_reader_refuses_by_its_form_the_schema_refuses() {
    let file = |more: &str| of_text(&format!("title = \"t\"\n[coordinates]\nx = \"m\"\n{more}"));
    for accepted in ["", "[start]\nequilibrium = true\nx = \"1 m\""] {
        assert_eq!(refused(&schema(), &file(accepted), ""), Vec::<String>::new());
    }
    for (more, way) in [
        ("[[force]]\non = \"a\"\nbetween = [\"a\", \"b\"]\nis = \"F\"", "/force/0"),
        ("[[force]]\nis = \"F\"", "/force/0"),
        ("[[torque]]\nbetween = [\"a\"]\nis = \"T\"", "/torque/0/between"),
        ("[[event]]\nwhen = \"x\"", "/event/0"),
        ("[[event]]\nwhen = \"x\"\nend = \"yes\"", "/event/0/end"),
        ("[[event]]\nwhen = \"x\"\nend = true\ndirection = \"left\"", "/event/0/direction"),
        ("[run]\ntolerance = 1e-8", "/run: no span"),
        ("[start]\nequilibrium = \"yes\"", "/start/equilibrium"),
        ("[run]\nspan = \"1 s\"\nsamples = 0", "/run/samples"),
        ("[[contact]]\nof = \"x\"", "/contact/0"),
        ("[[contact]]\nbetween = \"b, N along x\"\nsides = \"two\"", "/contact/0/sides"),
        ("[[drive]]\nturns = \"x\"\n[[drive.winding]]\nresistance = \"R\"", "/drive/0/winding/0"),
        ("[bodies.b]\nmas = \"m\"", "/bodies/b: unknown mas"),
    ] {
        let found = refused(&schema(), &file(more), "");
        assert!(found.len() == 1 && found[0].starts_with(way), "{more}: {found:?}");
    }
}

const READ: &str = "title = \"t\"\nTOP\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies.b]\ncentre = \"O + x*N.x\"\nmass = \"m\"\nBODY\n\
                    [[force]]\non = \"b\"\nis = \"0\"\nFORCE\n[[torque]]\non = \"N\"\nis = \"0\"\nTORQUE\n[[constraint]]\nzero = \"x\"\nCONSTRAINT\n[[contact]]\nof = \"b\"\nthrough = \"O\"\nnormal = \"N.x\"\nCONTACT\n[[drive]]\nturns = \"x/(1 m)\"\nDRIVE\n[[drive.winding]]\ninductance = \"(1 H)\"\nWINDING\n\
                    [[event]]\nwhen = \"x\"\nend = true\nEVENT\n[inputs]\nu = { unit = \"N\"INPUT }\n[run]\nspan = \"1 s\"\nRUN\n";

/// The file with a text inserted at one of its markers.
fn with(place: &str, written: &str) -> String {
    let places =
        ["TOP", "BODY", "FORCE", "TORQUE", "CONSTRAINT", "CONTACT", "DRIVE", "WINDING", "EVENT", "INPUT", "RUN"];
    places
        .iter()
        .fold(READ.to_owned(), |text, other| text.replacen(other, if *other == place { written } else { "" }, 1))
}

/// The keys that the reader lists as known, in its message about an unknown key at a marker.
fn known(place: &str, written: &str) -> BTreeSet<String> {
    let text = with(place, written);
    let error = ModelScene::parse("scene.toml", &text).expect_err("a key is not known");
    let issue =
        error.issues.iter().find(|issue| issue.title.contains("`unheard_of_key`")).unwrap_or_else(|| panic!("{error}"));
    let list =
        issue.help.as_deref().and_then(|help| help.strip_prefix("known here: ")).unwrap_or_else(|| panic!("{error}"));
    list.split(", ").map(str::to_owned).collect()
}

#[test]
fn the_schema_has_every_key_that_the_reader_knows_and_no_other() {
    let schema = schema();
    let keys = |place: &str| -> BTreeSet<String> {
        let properties = schema.pointer(&format!("{place}/properties")).unwrap_or_else(|| panic!("{place}"));
        properties.as_object().expect("keys").keys().cloned().collect()
    };
    let one = "unheard_of_key = 1";
    for (place, written, of_schema) in [
        ("TOP", one, ""),
        ("BODY", one, "/$defs/body"),
        ("BODY", "inertia = { unheard_of_key = 1 }", "/$defs/tensor"),
        ("FORCE", one, "/properties/force/items"),
        ("TORQUE", one, "/properties/torque/items"),
        ("CONSTRAINT", one, "/properties/constraint/items"),
        (
            "CONSTRAINT",
            "programmed = { gains = [\"(1 1/s)\"], unheard_of_key = 1 }",
            "/properties/constraint/items/properties/programmed",
        ),
        ("CONTACT", one, "/properties/contact/items"),
        ("DRIVE", one, "/properties/drive/items"),
        ("WINDING", one, "/properties/drive/items/properties/winding/items"),
        ("EVENT", one, "/properties/event/items"),
        ("INPUT", ", unheard_of_key = 1", "/properties/inputs/additionalProperties/anyOf/1"),
        ("RUN", one, "/properties/run"),
    ] {
        assert_eq!(known(place, written), keys(of_schema), "{place} {written}");
    }
    let text = with("BODY", "[energies]\nunheard_of_key = \"0\"");
    let error = ModelScene::parse("scene.toml", &text).expect_err("no such energy").to_string();
    let listed = keys("/properties/energies").into_iter().collect::<Vec<_>>().join(", ");
    assert_eq!(listed, "coenergy, dissipation, kinetic, potential");
    assert!(
        error.contains("no energy is called `unheard_of_key`") && error.contains("kinetic, potential, dissipation"),
        "{error}"
    );
}
