//! Every row of the ledger must be understandable on its own: tests of all its sentences.

use claims::catalogue::papers;
use claims::{Judged, Verdict};
use dalembert_derivations as _;
use std::sync::LazyLock;

/// The greatest length of a statement.
const MOST_CHARACTERS: usize = 600;

/// Every row, corrections included.
static ROWS: LazyLock<Vec<Judged>> = LazyLock::new(|| {
    std::thread::scope(|scope| {
        let running: Vec<_> = papers().into_iter().map(|paper| scope.spawn(|| (paper.page)().judge())).collect();
        running
            .into_iter()
            .flat_map(|judging| judging.join().expect("pages are judged"))
            .flat_map(with_correction)
            .collect()
    })
});

fn with_correction(mut claim: Judged) -> Vec<Judged> {
    let correction = claim.correction.take();
    std::iter::once(claim).chain(correction.into_iter().flat_map(|correction| with_correction(*correction))).collect()
}

/// Asserts that no row has a fault, and lists the rows that have it.
fn none(fault: &str, at_fault: impl Fn(&Judged) -> bool) {
    let offenders: Vec<String> =
        ROWS.iter().filter(|row| at_fault(row)).map(|row| format!("{}  {}", row.id, row.statement())).collect();
    assert!(offenders.is_empty(), "{} rows {fault}:\n{}", offenders.len(), offenders.join("\n"));
}

/// The visible text of a row: its sentence and the remarks with it.
fn sentences(row: &Judged) -> [&str; 4] {
    [&row.says, &row.why, &row.reading, &row.note]
}

#[test]
fn every_statement_says_something_and_none_ends_in_a_colon() {
    none("say nothing", |row| row.statement().trim().is_empty());
    none("end in a colon", |row| {
        sentences(row).into_iter().chain([row.statement().as_str()]).any(|text| text.trim_end().ends_with(':'))
    });
}

#[test]
fn a_sentence_that_announces_a_formula_is_followed_by_one() {
    let announces =
        |text: &str| [" by", " is", " are", " with", " of", " and", ","].iter().any(|end| text.ends_with(end));
    none("announce a formula that is not shown", |row| row.text.is_empty() && announces(row.says.trim_end()));
}

#[test]
fn no_statement_equates_an_expression_with_itself() {
    let repeated = |formula: &String| formula.split_once(" = ").is_some_and(|(left, right)| left == right);
    none("read X = X", |row| row.text.iter().any(repeated));
}

#[test]
fn no_statement_is_longer_than_can_be_read_at_once() {
    none("are longer than 600 characters", |row| {
        sentences(row).into_iter().chain([row.statement().as_str()]).any(|text| text.chars().count() > MOST_CHARACTERS)
    });
}

#[test]
fn nothing_is_called_the_same_that_is_not_named() {
    none("point to the same that is not named", |row| sentences(row).into_iter().any(points_into_the_air));
}

/// Whether the text contains "the same" without a noun after it, or at the start of a sentence; "the same as ..." is
/// allowed, since it names what is meant.
fn points_into_the_air(text: &str) -> bool {
    let lower = text.to_lowercase();
    let without_noun = |rest: &str| {
        let first = rest.split_whitespace().next().unwrap_or_default();
        let ends = rest.is_empty() || rest.starts_with([',', '.', ';', ':', ')']);
        ends || ["of", "with", "for", "in", "by", "to", "from", "at", "and", "where", "under", "but", "on", "if"]
            .contains(&first)
    };
    let begins = lower.starts_with("the same");
    begins || lower.match_indices("the same").any(|(place, found)| without_noun(&lower[place + found.len()..]))
}

#[test]
fn every_refuted_row_says_what_is_printed_what_is_correct_and_why() {
    let refuted = |row: &Judged| row.verdict == Verdict::Refuted;
    none("are refuted and do not say why", |row| refuted(row) && row.why.is_empty());
    none("give a reason and are not refuted", |row| !refuted(row) && !row.why.is_empty());
    for paper in papers() {
        for claim in (paper.page)().judge().iter().filter(|claim| refuted(claim)) {
            let correct = claim.correction.as_ref().map(|correction| correction.statement()).unwrap_or_default();
            assert!(!correct.is_empty() && correct != claim.statement(), "{}: {correct}", claim.id);
        }
    }
}

#[test]
fn a_row_that_depends_on_the_sign_of_the_rim_says_which_sign_was_read() {
    let of_rim = |row: &Judged| row.text.iter().any(|formula| formula.contains("aᵉ*") || formula.contains("bᵉ"));
    let alone: Vec<Judged> = papers().into_iter().flat_map(|paper| (paper.page)().judge()).collect();
    let silent: Vec<&str> =
        alone.iter().filter(|row| of_rim(row) && row.reading.is_empty()).map(|row| row.id.as_str()).collect();
    assert!(alone.iter().any(of_rim) && silent.is_empty(), "{silent:?}");
}

#[test]
fn the_detector_of_the_same_knows_what_is_named() {
    for named in ["both routes give the same polynomial", "the value is the same as in (5.3)"] {
        assert!(!points_into_the_air(named), "{named}");
    }
    for bare in ["the same of virtual displacements", "The same polynomial", "it does the same.", "they are the same:"]
    {
        assert!(points_into_the_air(bare), "{bare}");
    }
}
