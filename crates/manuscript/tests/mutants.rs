//! Proved claims of the papers, each broken by one edit of its text: the correction is found back.

use dalembert_manuscript::{ClaimText, Finding, Kind, PaperText};
use machines as _;

use std::collections::BTreeMap;
use std::path::Path;

/// A formula that one edit breaks, with the name of the edit.
struct Mutant {
    kind: &'static str,
    formula: String,
}

/// Every place of one text replaced by another, one at a time.
fn replaced(kind: &'static str, formula: &str, from: &str, to: &str, all: &mut Vec<Mutant>) {
    for (at, _) in formula.match_indices(from) {
        let behind = &formula[at + from.len()..];
        // a longer command begins in the same way
        if from.starts_with('\\')
            && from.ends_with(|l: char| l.is_ascii_alphabetic())
            && behind.starts_with(|l: char| l.is_ascii_alphabetic())
        {
            continue;
        }
        all.push(Mutant { kind, formula: format!("{}{to}{behind}", &formula[..at]) });
    }
}

/// Terms outside of groups, as they stand between signs and relations.
fn terms(formula: &str) -> Vec<std::ops::Range<usize>> {
    let (mut depth, mut start) = (0, 0);
    let mut found = Vec::new();
    for (at, letter) in formula.char_indices() {
        match letter {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            '+' | '-' | '=' if depth == 0 => {
                found.push(start..at);
                start = if letter == '=' { at + 1 } else { at };
            }
            _ => {}
        }
    }
    found.push(start..formula.len());
    found.retain(|range| !matches!(formula[range.clone()].trim(), "" | "0"));
    found
}

fn mutants(formula: &str, letters: &[&str]) -> Vec<Mutant> {
    let mut all = Vec::new();
    replaced("sign", formula, " + ", " - ", &mut all);
    replaced("sign", formula, " - ", " + ", &mut all);
    replaced("function", formula, r"\sin", r"\cos", &mut all);
    replaced("function", formula, r"\cos", r"\sin", &mut all);
    replaced("exponent", formula, "^2", "", &mut all);
    replaced("exponent", formula, "^2", "^3", &mut all);
    replaced("dot", formula, r"\ddot", r"\dot", &mut all);
    replaced("dot", formula, r"\dot{\theta}", r"\theta", &mut all);
    replaced("dot", formula, r"\dot{\varphi}", r"\ddot{\varphi}", &mut all);
    replaced("letter", formula, r"\theta", r"\varphi", &mut all);
    replaced("letter", formula, r"\dot{\varphi}", r"\dot{\theta}", &mut all);
    replaced("letter", formula, " l ", " r ", &mut all);
    replaced("letter", formula, " r ", " l ", &mut all);
    replaced("number", formula, r"\frac12", "", &mut all);
    replaced("number", formula, "{4}{3}", "{2}{3}", &mut all);
    replaced("number", formula, r"\frac14", r"\frac12", &mut all);
    replaced("number", formula, r"\frac54", r"\frac14", &mut all);
    replaced("number", formula, "2 m", "m", &mut all);
    for letter in letters {
        replaced("lost factor", formula, &format!(" {letter} "), " ", &mut all);
        replaced("doubled factor", formula, &format!(" {letter} "), &format!(" {letter} {letter} "), &mut all);
    }
    let parts = terms(formula);
    for term in &parts {
        let held = formula[term.clone()].trim();
        let factor = held.trim_start_matches(['+', '-']).trim_start();
        let at = term.end - formula[term.clone()].trim_end().len().abs_diff(term.len()) - factor.len();
        all.push(Mutant {
            kind: "numeric factor",
            formula: format!("{}2 {}", &formula[..at], &formula[at..]).replace("2 2", r"2 \cdot 2"),
        });
        let is_first = !held.starts_with(['+', '-']);
        if !is_first {
            all.push(Mutant {
                kind: "lost term",
                formula: format!("{}{}", &formula[..term.start], &formula[term.end..]),
            });
            let doubled = format!("{}{} {}", &formula[..term.end], held, &formula[term.end..]);
            all.push(Mutant { kind: "doubled term", formula: doubled });
        }
    }
    all.retain(|mutant| mutant.formula != formula);
    all
}

#[derive(Default)]
struct Row {
    broken: usize,
    refuted: usize,
    corrected: usize,
    back: usize,
}

fn paper(name: &str) -> PaperText {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../papers").join(name);
    PaperText::read(&path).unwrap_or_else(|error| panic!("{error}"))
}

/// Whether a correction is the original formula, or one whose sides have the same difference for all values of the letters.
fn is_back(whole: &PaperText, claim: &ClaimText, original: &Finding, found: &Finding) -> bool {
    let sides =
        |formula: &str| formula.split_once('=').map(|(left, right)| (left.trim().to_owned(), right.trim().to_owned()));
    let brackets = |side: &str| format!("({side})");
    found.corrections.iter().any(|correction| {
        if correction.judged.text == original.judged.text {
            return true;
        }
        let (Some((a, b)), Some((c, d))) = (sides(&claim.formula.text), sides(&correction.formula)) else {
            return false;
        };
        let [a, b, c, d] = [a, b, c, d].map(|side| brackets(&side));
        [format!("{a} - {b} = {c} - {d}"), format!("{a} - {b} = {d} - {c}")].into_iter().any(|formula| {
            let mut equal = whole.clone();
            equal.claims = vec![claim.clone()];
            equal.claims[0].formula.text = formula;
            equal.claims[0].kind = Kind::Identity;
            equal.judge_each(|_| (), || false).is_ok_and(|found| found[0].judged.verdict.name() == "proved")
        })
    })
}

#[test]
fn an_edit_that_breaks_a_claim_is_found_back() {
    let only = std::env::var("MUTANTS_OF").unwrap_or_default();
    let mut rows: BTreeMap<&str, Row> = BTreeMap::new();
    for (name, letters) in [
        ("cart_pole.toml", vec!["m", "l", r"\cos\theta"]),
        ("furuta_pendulum.toml", vec!["m", "l", "r", r"\cos\theta"]),
        ("rolling_disc.toml", vec!["m", "r", r"\Omega"]),
        ("manglieva2022_governor.toml", vec!["\\rho", "u"]),
    ] {
        if !name.contains(&only) {
            continue;
        }
        let whole = paper(name);
        let known = whole.judge_each(|_| (), || false).unwrap_or_else(|error| panic!("{error}"));
        for (claim, original) in whole.claims.iter().zip(&known) {
            if original.judged.verdict.name() != "proved" || matches!(claim.kind, Kind::SteadyMotion | Kind::Inequality)
            {
                continue;
            }
            for mutant in mutants(&claim.formula.text, &letters) {
                let mut broken = whole.clone();
                broken.claims = vec![claim.clone()];
                broken.claims[0].formula.text = mutant.formula.clone();
                let start = std::time::Instant::now();
                let Ok(found) = broken.judge() else { continue };
                let Some(found) = found.first() else { continue };
                let row = rows.entry(mutant.kind).or_default();
                row.broken += 1;
                if found.judged.verdict.name() != "refuted" {
                    println!("{} {}: {} {}", found.judged.verdict.name(), mutant.kind, found.judged.id, mutant.formula);
                    continue;
                }
                row.refuted += 1;
                row.corrected += usize::from(!found.corrections.is_empty());
                let back = is_back(&whole, claim, original, found);
                row.back += usize::from(back);
                for correction in &found.corrections {
                    assert_eq!(correction.judged.verdict.name(), "proved", "{}", found.text());
                }
                if !back {
                    println!("{} {:?} {}", mutant.kind, start.elapsed(), found.text());
                } else {
                    println!(
                        "ok {} {:?} {} of {}",
                        mutant.kind,
                        start.elapsed(),
                        found.corrections[0].says(),
                        found.corrections.len()
                    );
                }
            }
        }
    }
    println!("{:<16} {:>6} {:>8} {:>10} {:>6}", "edit", "broken", "refuted", "corrected", "back");
    for (kind, row) in &rows {
        println!("{kind:<16} {:>6} {:>8} {:>10} {:>6}", row.broken, row.refuted, row.corrected, row.back);
    }
}
