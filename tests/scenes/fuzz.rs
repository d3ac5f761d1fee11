//! For any scene file the reader terminates, with a scene or with messages whose positions lie in the text.
//!
//! The files are mutations of the project's own: pieces are deleted, duplicated or exchanged, numbers and words
//! replaced. By default there are a few thousand; a million with `PROPTEST_CASES=1000000 cargo test --release --test
//! scenes fuzz`.

use dalembert_derivations::studies::AnyScene;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::{RngSeed, TestRunner};
use reader::Family;
use simulation::Axes;
use std::path::{Path, PathBuf};

/// Words that are likely to reveal errors of a reader.
const WORDS: &[&str] = &[
    "0",
    "-0",
    "-1",
    "1e308",
    "-1e308",
    "1e-308",
    "1e999",
    "nan",
    "inf",
    "9223372036854775807",
    "-9223372036854775808",
    "0x7f",
    "1_0",
    "\"\"",
    "\"0 kg\"",
    "\"-1 kg\"",
    "\"1 kg m\"",
    "\"-1 ohm\"",
    "\"-1 N m s\"",
    "\"0 H\"",
    "\"nan N m s\"",
    "\"cos(40*g)\"",
    "\"t\"",
    "\"x'\"",
    "\"l1*x + l1*i1\"",
    "allow = [\"negative resistance\", 3]",
    "mutual = \"1 H\"",
    "\u{1b}[31m",
    "\"\\u001b[2J\\u202e\"",
    "\"1e400 m\"",
    "\"NaN s\"",
    "\"1 2 3 rad/s\"",
    "\"0 0 0\"",
    "\"1e200 deg\"",
    "\"1;2;3\"",
    "\"0.1 N m N m\"",
    "\"m/s/s\"",
    "true",
    "[]",
    "[[]]",
    "{}",
    "[1, \"a\"]",
    "1979-05-27",
    "[run]",
    "[machine]",
    "[[run]]",
    "=",
    "\"\"\"",
    "'''",
    "#",
    ".",
    ",",
    "\u{feff}",
    "\u{0}",
    "é",
    "\u{202e}",
    "γ̇",
    "\\u",
    "\r",
    "\t",
    "model = ",
    "method = ",
    "\"runge_kutta_4:0\"",
    "\"taylor\"",
    "\"gauss:99\"",
    "bars = 1000000000",
    "samples = 4294967296",
    "members = 4294967296",
];

/// A change of a text, at positions given as fractions of its length.
#[derive(Clone, Debug)]
enum Tear {
    /// Deletes a piece.
    Cut(Index, Index),
    /// Repeats a piece at another position.
    Double(Index, Index, Index),
    /// Inserts a word.
    Word(Index, Index),
    /// Replaces a value by a word.
    Value(Index, Index),
    /// Exchanges two lines.
    Lines(Index, Index),
    /// Replaces a character.
    Letter(Index, char),
}

fn tear() -> impl Strategy<Value = Tear> {
    let at = any::<Index>;
    prop_oneof![
        1 => (at(), at()).prop_map(|(a, b)| Tear::Cut(a, b)),
        1 => (at(), at(), at()).prop_map(|(a, b, c)| Tear::Double(a, b, c)),
        1 => (at(), at()).prop_map(|(a, b)| Tear::Word(a, b)),
        4 => (at(), at()).prop_map(|(a, b)| Tear::Value(a, b)),
        1 => (at(), at()).prop_map(|(a, b)| Tear::Lines(a, b)),
        1 => (at(), any::<char>()).prop_map(|(a, letter)| Tear::Letter(a, letter)),
    ]
}

/// The start of a character at this position, or the end of the text.
fn place(text: &str, at: Index) -> usize {
    let mut place = at.index(text.len() + 1);
    while !text.is_char_boundary(place) {
        place -= 1;
    }
    place
}

/// A range of at most about two lines.
fn piece(text: &str, a: Index, b: Index) -> std::ops::Range<usize> {
    let (start, mut end) = (place(text, a), place(text, a) + b.index(80));
    while !text.is_char_boundary(end.min(text.len())) {
        end -= 1;
    }
    start..end.min(text.len()).max(start)
}

impl Tear {
    fn apply(&self, text: &mut String) {
        match self {
            Tear::Cut(a, b) => drop(text.drain(piece(text, *a, *b))),
            Tear::Double(a, b, c) => {
                let piece = text[piece(text, *a, *b)].to_owned();
                text.insert_str(place(text, *c), &piece);
            }
            Tear::Word(a, word) => text.insert_str(place(text, *a), word.get::<&str>(WORDS)),
            Tear::Value(a, word) => {
                let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
                let assigned: Vec<usize> = (0..lines.len()).filter(|&k| lines[k].contains('=')).collect();
                if !assigned.is_empty() {
                    let line = &mut lines[*a.get(&assigned)];
                    let key = line.split('=').next().unwrap_or_default().to_owned();
                    *line = format!("{key}= {}", word.get(WORDS));
                    *text = lines.join("\n");
                }
            }
            Tear::Lines(a, b) => {
                let mut lines: Vec<&str> = text.lines().collect();
                if !lines.is_empty() {
                    let (a, b) = (a.index(lines.len()), b.index(lines.len()));
                    lines.swap(a, b);
                    *text = lines.join("\n");
                }
            }
            Tear::Letter(a, letter) => {
                let place = place(text, *a);
                if let Some(old) = text[place..].chars().next() {
                    text.replace_range(place..place + old.len_utf8(), letter.encode_utf8(&mut [0; 4]));
                }
            }
        }
    }
}

/// The scene files of a folder and its subfolders.
fn scenes(folder: &Path, texts: &mut Vec<String>) {
    let mut entries: Vec<PathBuf> =
        std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            scenes(&path, texts);
        } else if path.extension().is_some_and(|extension| extension == "toml") {
            texts.push(std::fs::read_to_string(&path).expect("a scene is text"));
        }
    }
}

#[test]
fn a_torn_scene_is_read_or_refused_with_its_places() {
    let mut texts = Vec::new();
    scenes(&Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes"), &mut texts);
    let cases = std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(3000);
    let config = ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(1743),
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let torn = (any::<Index>(), prop::collection::vec(tear(), 1..5)).prop_map(move |(which, tears)| {
        let mut text = which.get(&texts).clone();
        tears.iter().for_each(|tear| tear.apply(&mut text));
        text
    });
    let outcome = TestRunner::new(config).run(&torn, |text| {
        match AnyScene::parse("torn.toml", &text) {
            Ok(scene) => {
                let problem = scene.smooth().problem(Axes::First);
                prop_assert!(problem.state.iter().all(|value| value.is_finite()), "a start that is no number");
                prop_assert!(problem.state.len() < 10_000, "a scene that asks for all memory");
            }
            Err(error) => {
                let message = error.render(false);
                prop_assert!(message.contains("torn.toml") && !error.issues.is_empty(), "{message}");
                let inside = |span: &std::ops::Range<usize>| text.get(span.clone()).is_some();
                prop_assert!(error.issues.iter().filter_map(|issue| issue.span.as_ref()).all(inside), "{message}");
            }
        }
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}
