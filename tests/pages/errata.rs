//! Known errata of the papers that are written in Rust: whether the program finds the corrections if the known ones are
//! withheld.

use claims::catalogue::papers;
use claims::{Claim, Condition, Line, Page, Statement, Verdict};
use dalembert_derivations as _;
use manuscript::{LineCorrection, line_corrections, theorem_corrections};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};
use symbolic::{Hypotheses, Sym, decide};

/// The papers whose errata are recorded.
const PAPERS: [&str; 3] = ["konosevich2022", "manglieva2022", "mukharlyamov2007"];

/// The test tries one erratum out of this number; all with `EVERY_ERRATUM=1`, those whose name contains a text with
/// `ERRATUM=text`.
const STEP: usize = 12;

/// The time limit for one equation.
const LIMIT: Duration = Duration::from_secs(60);

/// The outcome for a refuted entry of the ledger.
enum Outcome {
    /// The entry is an implication, or an equation whose printed form was not recorded as an equation.
    NoFormula(String),
    Missed,
    Found {
        edits: String,
        /// Whether every equation found is one of the recorded correction.
        is_typed: bool,
    },
}

fn outcome(page: &Page, claim: &Claim) -> Outcome {
    if !is_equation(claim.correction.as_deref()) {
        return Outcome::NoFormula("the typed correction is a statement".to_owned());
    }
    let start = Instant::now();
    let goes_on = || start.elapsed() < LIMIT;
    let tried: Vec<(Vec<LineCorrection>, &Hypotheses)> = match &claim.statement {
        Statement::Equations { lines, hypotheses } => {
            let wrong = |line: &&Line| !decide(line.derived - line.printed(), hypotheses).is_zero();
            let of = |line: &Line| line_corrections(line, hypotheses, page.dimensions(), &goes_on);
            match lines.iter().filter(wrong).map(of).collect::<Result<Vec<_>, _>>() {
                Ok(found) => found.into_iter().map(|found| (found, hypotheses)).collect(),
                Err(why) => return Outcome::NoFormula(why.0),
            }
        }
        Statement::Theorem(theorem) => match theorem_corrections(theorem, page.dimensions(), &goes_on) {
            Ok(found) => vec![(found, &theorem.rules)],
            Err(why) => return Outcome::NoFormula(why.0),
        },
        Statement::Definition(_) => return Outcome::NoFormula("a definition".to_owned()),
    };
    if tried.iter().any(|(found, _)| found.is_empty()) {
        return Outcome::Missed;
    }
    for (found, _) in &tried {
        println!("{}: {}", claim.id, found[0].correction.says());
    }
    let kinds = tried.iter().flat_map(|(found, _)| &found[0].correction.changes).map(|change| change.kind.name());
    let mut edits: Vec<&str> = kinds.collect();
    edits.dedup();
    let is_typed = tried.iter().all(|(found, known)| found.iter().any(|found| is_typed(claim, &found.line, known)));
    Outcome::Found { edits: edits.join(", "), is_typed }
}

/// Whether the recorded correction contains an equality, which edits of a formula could produce.
fn is_equation(typed: Option<&Claim>) -> bool {
    match typed.map(|typed| &typed.statement) {
        Some(Statement::Equations { .. }) => true,
        Some(Statement::Theorem(theorem)) => {
            theorem.then.iter().any(|then| matches!(then, Condition::Equal(..) | Condition::Zero(_)))
        }
        _ => false,
    }
}

/// Whether a corrected equation is one of the recorded correction, up to a constant factor.
fn is_typed(claim: &Claim, found: &Line, known: &Hypotheses) -> bool {
    // the difference of any two identities is zero, so that they cannot be distinguished
    if decide(found.printed(), &Hypotheses::none()).is_zero() {
        return false;
    }
    let is_same = |typed: Sym, rules: &Hypotheses| {
        [found.printed() - typed, found.printed() + typed].into_iter().any(|zero| decide(zero, rules).is_zero())
    };
    match claim.correction.as_ref().map(|correction| &correction.statement) {
        Some(Statement::Equations { lines, hypotheses }) => {
            let mut typed = lines.iter().map(Line::printed);
            typed.any(|typed| is_same(typed, hypotheses) || is_same(typed, known))
        }
        Some(Statement::Theorem(theorem)) => theorem.then.iter().any(|conclusion| match conclusion {
            Condition::Equal(left, right) => is_same(*left - *right, &theorem.rules) || is_same(*right, &theorem.rules),
            Condition::Zero(zero) => is_same(*zero, &theorem.rules),
            _ => false,
        }),
        _ => false,
    }
}

#[test]
fn known_errata_are_corrected_as_they_were_by_hand() {
    let all = std::env::var_os("EVERY_ERRATUM").is_some();
    let named = std::env::var("ERRATUM").ok();
    let step = if all || named.is_some() { 1 } else { STEP };
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for paper in papers().into_iter().filter(|paper| PAPERS.contains(&paper.key)) {
        let page = (paper.page)();
        let refuted = page.claims().iter().filter(|claim| claim.expected == Verdict::Refuted);
        let is_named = |claim: &&Claim| named.as_ref().is_none_or(|named| claim.id.contains(named));
        for claim in refuted.filter(is_named).step_by(step) {
            let (word, told) = match outcome(&page, claim) {
                Outcome::NoFormula(why) => ("no formula", why),
                Outcome::Missed => ("not found", claim.why.clone()),
                Outcome::Found { edits, is_typed: true } => ("found", edits),
                Outcome::Found { edits, is_typed: false } => ("found in another form", edits),
            };
            *counts.entry(word).or_default() += 1;
            println!("| {} | {word} | {told} |", claim.id);
        }
    }
    println!("{counts:?}");
    let of = |word: &str| counts.get(word).copied().unwrap_or_default();
    let found = of("found") + of("found in another form");
    // most of those that have one; the table in the book contains all of them
    let [above, below] = if all { [9, 10] } else { [3, 4] };
    assert!(found > 0 && below * found >= above * (found + of("not found")), "{counts:?}");
}
