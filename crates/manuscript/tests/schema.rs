//! The JSON schema of papers for editors: it is made of the schema of systems and of the reader's own kinds and verdicts.

use claims::Verdict;
use dalembert_manuscript::{Kind, PaperText};
use machines as _;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use toml::de::{DeTable, DeValue};

fn schemas() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schema")
}

fn read(name: &str) -> Value {
    let path = schemas().join(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).expect("it is JSON")
}

fn text(says: &str) -> Value {
    json!({ "type": "string", "description": says })
}

fn texts(says: &str) -> Value {
    json!({ "type": "array", "items": { "type": "string" }, "description": says })
}

/// The tables of a paper beside those of its system.
fn own() -> Value {
    let kinds = Kind::ALL.map(Kind::name);
    let verdicts = [
        Verdict::Proved,
        Verdict::Enclosed,
        Verdict::Identified,
        Verdict::Refuted,
        Verdict::Undecided,
        Verdict::Undefined,
    ];
    let claim = json!({
        "equation": text("Number of the formula in the paper, such as \"5\" or \"2.3\"."),
        "formula": text("Formula in LaTeX as printed, in single quotes; a display on several lines is a claim for each of them."),
        "kind": { "enum": kinds, "description": "Kind of statement." },
        "name": text("Tells claims of one formula apart."),
        "says": text("A sentence that the formula states."),
        "section": text("Section of the paper."),
        "note": text("Remark for a reader."),
        "given": texts("Hypotheses in LaTeX: equalities, signs, what does not vanish."),
        "resting": texts("Letters and rates that are constant on a steady motion, or on the motion of a linearised equation."),
        "expect": { "enum": verdicts.map(Verdict::name), "description": "Verdict that `judge --test` asks for." },
    });
    json!({
        "citation": text("Authors, title, journal, year."),
        "summary": text("Subject of the paper."),
        "model": text("File of the system, by its way from this file's folder, where its tables do not stand here."),
        "letters": {
            "type": "object",
            "description": "Each letter of the formulas in LaTeX with its meaning, an expression of the model; a vector has a list of them; 'f(q)' is a function.",
            "additionalProperties": { "type": ["string", "array"], "items": { "type": "string" } },
        },
        "claim": {
            "type": "array",
            "minItems": 1,
            "description": "What the paper claims, one table for each formula.",
            "items": {
                "type": "object",
                "required": ["equation", "kind", "formula"],
                "additionalProperties": false,
                "properties": claim,
            },
        },
    })
}

fn made() -> Value {
    let mut schema = read("model.schema.json");
    schema["title"] = json!("A paper as text");
    schema["description"] = json!(
        "A paper with [letters] and [[claim]] beside the tables of its system, or `model`, the file that has them: dalembert judge decides each claim."
    );
    schema["required"] = json!(["title", "letters", "claim"]);
    for (key, value) in own().as_object().expect("tables") {
        schema["properties"][key] = value.clone();
    }
    schema
}

#[test]
fn the_schema_is_made_of_the_readers_tables() {
    let path = schemas().join("paper.schema.json");
    let text = format!("{}\n", serde_json::to_string_pretty(&made()).expect("it is written"));
    if std::env::var_os("UPDATE_SCHEMA").is_some() {
        std::fs::write(&path, &text).expect("it is written");
    }
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(stored, text, "UPDATE_SCHEMA=1 writes {} anew", path.display());
}

#[test]
fn every_paper_has_keys_of_the_schema() {
    let schema = made();
    let papers = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../papers");
    for entry in std::fs::read_dir(papers).expect("there are papers") {
        let path = entry.expect("it can be listed").path();
        let text = std::fs::read_to_string(&path).expect("it can be read");
        let table = DeTable::parse(&text).expect("it is TOML");
        for (key, value) in table.get_ref() {
            let key = key.get_ref().as_ref();
            assert!(schema["properties"][key].is_object(), "{}: {key}", path.display());
            let (DeValue::Array(claims), "claim") = (value.get_ref(), key) else { continue };
            let DeValue::Table(claim) = claims[0].get_ref() else { panic!("a claim is a table") };
            let known = &schema["properties"]["claim"]["items"]["properties"];
            assert!(claim.keys().all(|key| known[key.get_ref().as_ref()].is_object()), "{}", path.display());
        }
    }
}

/// Whether the reader refuses a key of a claim.
fn is_refused(key: &str) -> bool {
    let system = "title = \"t\"\n[parameters]\nm = \"kg\"\n[coordinates]\nx = \"m\"\n[energies]\nkinetic = \"m/2*x'^2\"\n[letters]\n'm' = \"m\"\n";
    let claim = format!("[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = 'm = m'\n{key} = \"proved\"\n");
    let told =
        PaperText::parse(Path::new("paper.toml"), format!("{system}{claim}")).err().map(|error| error.to_string());
    told.is_some_and(|told| told.contains(&format!("unknown key `{key}`")))
}

#[test]
fn the_reader_knows_each_key_of_a_claim() {
    assert!(is_refused("nonsense"));
    let given = ["equation", "kind", "formula"];
    for key in own()["claim"]["items"]["properties"].as_object().expect("keys").keys() {
        assert!(given.contains(&key.as_str()) || !is_refused(key), "{key}");
    }
}
