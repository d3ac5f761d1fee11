//! The JSON schema of papers for editors is made of the schema of systems and of the kinds and verdicts that the reader knows.

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
    json!({ "type": "string", "description": says, "unit": "text" })
}

fn formula(says: &str) -> Value {
    json!({ "type": "string", "description": says, "unit": "LaTeX" })
}

fn formulas(says: &str) -> Value {
    json!({ "type": "array", "items": { "type": "string" }, "description": says, "unit": "list of LaTeX" })
}

/// Claims about a pendulum that use every key.
fn claims() -> Value {
    json!([
        {
            "equation": "1",
            "section": "2.1",
            "name": "damped",
            "kind": "equation of motion",
            "formula": r"m l^2 \ddot{\theta} + m g l \sin\theta = 0",
            "says": "The equation of motion of the pendulum.",
            "note": "Without damping.",
            "given": [r"l > 0"],
            "expect": "proved",
        },
        { "equation": "2", "kind": "steady motion", "formula": r"\sin\theta = 0", "resting": [r"\theta"] },
    ])
}

fn letters() -> Value {
    json!({ "m": "m", "l": "l", "g": "g", r"\theta": "theta", r"\mathbf{v}": ["l*theta'*cos(theta)", "l*theta'*sin(theta)"] })
}

/// The tables of a paper that a system does not have.
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
        "formula": formula("Formula in LaTeX as printed, in single quotes; a display on several lines is a claim for each of them."),
        "kind": { "enum": kinds, "description": "Kind of statement." },
        "name": text("A name that tells claims of one formula apart."),
        "says": text("A sentence that the formula states."),
        "section": text("Section of the paper."),
        "note": text("Remark for a reader."),
        "given": formulas("Hypotheses in LaTeX: equalities, signs, expressions that do not vanish."),
        "resting": formulas("Letters and rates that are constant on a steady motion, or on the motion of a linearised equation."),
        "expect": { "enum": verdicts.map(Verdict::name), "description": "Verdict that `judge --test` asks for." },
    });
    json!({
        "citation": text("Authors, title, journal, year."),
        "summary": text("Subject of the paper."),
        "model": text("File of the system, by its path from the folder of this file, if this file does not contain the tables of the system."),
        "letters": {
            "type": "object",
            "description": "Each letter of the formulas in LaTeX with its meaning, an expression of the model; a vector has a list of them; 'f(q)' is a function.",
            "examples": [letters()],
            "additionalProperties": {
                "type": ["string", "array"],
                "items": { "type": "string" },
                "description": "The meaning of the letter.",
                "unit": "expression, or a list of such",
            },
        },
        "claim": {
            "type": "array",
            "minItems": 1,
            "description": "The statements of the paper, one [[claim]] for each formula.",
            "items": {
                "type": "object",
                "description": "A claim is a formula with its kind and its hypotheses.",
                "required": ["equation", "kind", "formula"],
                "additionalProperties": false,
                "properties": claim,
                "examples": claims(),
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
    schema["examples"] = json!([{
        "citation": "A. Author, Pendula, Journal of Examples 1 (2020) 1-9",
        "summary": "Small and large oscillations of a pendulum.",
        "model": "../scenes/models/cart_pole.toml",
    }]);
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
    let files = |folder: &Path| -> Vec<PathBuf> {
        let entries = std::fs::read_dir(folder).expect("there are papers");
        entries.map(|entry| entry.expect("it can be listed").path()).collect()
    };
    let all = files(&papers).into_iter().flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] });
    for path in all {
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

#[test]
fn every_example_of_a_paper_is_read() {
    let line = |(key, value): (&String, &Value)| format!("{} = {value}\n", Value::from(key.as_str()));
    let lines = |table: &Value| table.as_object().expect("keys").iter().map(line).collect::<String>();
    let claim = |claim: &Value| format!("[[claim]]\n{}", lines(claim));
    let claims: String = claims().as_array().expect("claims").iter().map(claim).collect();
    let system = "[parameters]\nm = \"kg\"\nl = \"m\"\ng = \"m/s^2\"\n[coordinates]\ntheta = \"rad\"\n[energies]\nkinetic = \"m*l^2*theta'^2/2\"\npotential = \"-m*g*l*cos(theta)\"\n";
    let keys = |keys: &Value| {
        let mut keys = keys.clone();
        keys.as_object_mut().expect("keys").shift_remove("model").expect("a file is named");
        format!("title = \"A pendulum\"\n{}", lines(&keys))
    };
    let examples = &made()["examples"][0];
    let own = format!("{}{system}[letters]\n{}{claims}", keys(examples), lines(&letters()));
    let other = format!(
        "title = \"A cart\"\n{}[letters]\nm = \"m\"\n[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = \"m = m\"\n",
        lines(examples)
    );
    for text in [own, other] {
        let path = schemas().join("../papers/example.toml");
        let paper = PaperText::parse(&path, text).unwrap_or_else(|error| panic!("{error}"));
        assert!(paper.claims.iter().all(|claim| claim.faults.is_empty()), "{:?}", paper.claims);
    }
}

/// Whether the reader refuses a key of a claim.
fn is_refused(key: &str) -> bool {
    let system = "title = \"t\"\n[parameters]\nm = \"kg\"\n[coordinates]\nx = \"m\"\n[energies]\nkinetic = \"m/2*x'^2\"\n[letters]\n'm' = \"m\"\n";
    let claim = format!("[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = 'm = m'\n{key} = \"proved\"\n");
    let judged = PaperText::parse(Path::new("paper.toml"), format!("{system}{claim}")).and_then(|paper| paper.judge());
    let told = judged.err().map(|error| error.to_string());
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
