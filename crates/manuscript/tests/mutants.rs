//! Proved claims of the papers, each made false by one edit of its text: the corrections must restore the claim.

use dalembert_manuscript::{ClaimText, EditKind, Finding, Kind, PaperText};
use machines as _;
use std::collections::BTreeMap;
use std::path::Path;

/// A formula made false by one edit, with the name of the edit.
struct Mutant {
    kind: &'static str,
    formula: String,
}

/// Adds a mutant for each occurrence of a text, with that occurrence replaced.
fn replaced(kind: &'static str, formula: &str, from: &str, to: &str, all: &mut Vec<Mutant>) {
    for (at, _) in formula.match_indices(from) {
        let behind = &formula[at + from.len()..];
        // `from` is only the beginning of a longer command
        if from.starts_with('\\')
            && from.ends_with(|l: char| l.is_ascii_alphabetic())
            && behind.starts_with(|l: char| l.is_ascii_alphabetic())
        {
            continue;
        }
        all.push(Mutant { kind, formula: format!("{}{to}{behind}", &formula[..at]) });
    }
}

/// The ranges of the terms outside groups, between signs and relations.
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
    /// The number of corrections that are not proved when judged as claims.
    wrong: usize,
}

fn paper(name: &str) -> PaperText {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../papers").join(name);
    PaperText::read(&path).unwrap_or_else(|error| panic!("{error}"))
}

/// Whether a correction is the original formula, or has the same difference of its sides up to sign.
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
        let mut identity = claim.clone();
        identity.kind = Kind::Identity;
        [format!("{a} - {b} = {c} - {d}"), format!("{a} - {b} = {d} - {c}")].into_iter().any(|formula| {
            judged(whole, &identity, &formula, false).is_some_and(|found| found.judged.verdict.name() == "proved")
        })
    })
}

/// One mutant in this many is judged; with `EVERY_MUTANT=1` every mutant is judged, and those not restored are printed.
const SAMPLE: usize = 12;

const PAPERS: [(&str, &[&str]); 5] = [
    ("cart_pole.toml", &["m", "l", r"\cos\theta"]),
    ("furuta_pendulum.toml", &["m", "l", "r", r"\cos\theta"]),
    ("rolling_disc.toml", &["m", "r", r"\Omega"]),
    ("beside_pages/manglieva2022_governor.toml", &[r"\rho", "u"]),
    ("beside_pages/manglieva2022_two_discs.toml", &[r"\omega_2"]),
];

/// All mutants of the proved claims of the papers.
fn broken_claims() -> Vec<(PaperText, ClaimText, Finding, Mutant)> {
    let mut all = Vec::new();
    for (name, letters) in PAPERS {
        let whole = paper(name);
        let known = whole.judge_each(|_| (), || false).unwrap_or_else(|error| panic!("{error}"));
        for (claim, original) in whole.claims.iter().zip(&known) {
            if original.judged.verdict.name() == "proved" {
                let each = mutants(&claim.formula.text, letters).into_iter();
                all.extend(each.map(|mutant| (whole.clone(), claim.clone(), original.clone(), mutant)));
            }
        }
    }
    all
}

/// The finding on a paper with this formula as its only claim; `None` if it is refused.
fn judged(paper: &PaperText, claim: &ClaimText, formula: &str, corrects: bool) -> Option<Finding> {
    let mut alone = paper.clone();
    alone.claims = vec![claim.clone()];
    alone.claims[0].formula.text = formula.to_owned();
    alone.judge_each(|_| (), || corrects).ok()?.into_iter().next()
}

#[test]
fn an_edit_that_breaks_a_proved_claim_is_found_back() {
    let is_whole = std::env::var_os("EVERY_MUTANT").is_some();
    let mut rows: BTreeMap<&str, Row> = BTreeMap::new();
    for (paper, claim, original, mutant) in broken_claims().into_iter().step_by(if is_whole { 1 } else { SAMPLE }) {
        let Some(found) = judged(&paper, &claim, &mutant.formula, true) else { continue };
        let row = rows.entry(mutant.kind).or_default();
        row.broken += 1;
        if found.judged.verdict.name() != "refuted" {
            continue;
        }
        row.refuted += 1;
        row.corrected += usize::from(!found.corrections.is_empty());
        // every correction is judged again as a claim
        for correction in found.corrections.iter().filter(|one| one.changes[0].kind != EditKind::Hypothesis) {
            let anew = judged(&paper, &claim, &correction.formula, false);
            row.wrong += usize::from(anew.is_none_or(|anew| anew.judged.verdict.name() != "proved"));
        }
        let is_back = is_back(&paper, &claim, &original, &found);
        row.back += usize::from(is_back);
        if is_whole && !is_back {
            println!("{}\n{}", mutant.kind, found.text());
        }
    }
    println!("{:<16} {:>6} {:>8} {:>10} {:>6} {:>6}", "edit", "broken", "refuted", "corrected", "back", "wrong");
    for (kind, Row { broken, refuted, corrected, back, wrong }) in &rows {
        println!("{kind:<16} {broken:>6} {refuted:>8} {corrected:>10} {back:>6} {wrong:>6}");
    }
    let sum = |of: fn(&Row) -> usize| rows.values().map(of).sum::<usize>();
    assert_eq!(sum(|row| row.wrong), 0);
    assert!(10 * sum(|row| row.back) >= 9 * sum(|row| row.refuted), "fewer than nine tenths are found back");
}
