//! The second check: snapshots of the ledger as pages for review, one for each section of a paper.

use claims::catalogue::papers;
use claims::{Judged, Verdict, render};
use dalembert_derivations as _;
use std::collections::HashSet;
use std::sync::LazyLock;

/// The greatest size of a page, so that a reviewer can read it at once.
const MOST_BYTES: usize = 20 * 1024;

/// Each paper with its claims, which are checked once. Each paper has its own thread, since expressions cannot leave
/// their thread.
static JUDGED: LazyLock<Vec<(&str, Vec<Judged>)>> = LazyLock::new(|| {
    std::thread::scope(|scope| {
        let running = papers().into_iter().map(|paper| (paper.key, scope.spawn(|| (paper.page)().judge())));
        let running: Vec<_> = running.collect();
        running.into_iter().map(|(key, judging)| (key, judging.join().expect("pages are judged"))).collect()
    })
});

#[test]
fn every_section_reads_as_reviewed() {
    for (paper, judged) in JUDGED.iter() {
        for section in sections(judged) {
            let claims: Vec<Judged> = judged.iter().filter(|claim| claim.section == section).cloned().collect();
            let text = render(&claims);
            let name = format!("{paper}-{}", slug(&section));
            assert!(text.len() <= MOST_BYTES, "{name} has {} bytes", text.len());
            insta::with_settings!({
                snapshot_path => format!("../../snapshots/{paper}"), prepend_module_to_snapshot => false,
                omit_expression => true,
            }, { insta::assert_snapshot!(name, text) });
        }
    }
}

#[test]
fn no_claim_is_open_and_no_id_stands_twice() {
    for (_, judged) in JUDGED.iter() {
        assert!(judged.iter().all(|claim| claim.verdict != Verdict::Open));
        let ids: HashSet<&str> = judged.iter().flat_map(with_correction).map(|claim| claim.id.as_str()).collect();
        assert_eq!(ids.len(), judged.iter().flat_map(with_correction).count());
    }
}

#[test]
fn every_refuted_claim_says_where_it_fails_and_what_holds_instead() {
    for (_, judged) in JUDGED.iter() {
        for claim in judged.iter().filter(|claim| claim.verdict == Verdict::Refuted) {
            assert!(!claim.counterexample.is_empty(), "{} has no counterexample", claim.id);
            let correction = claim.correction.as_ref().map(|correction| correction.verdict);
            assert_eq!(correction, Some(Verdict::Proved), "{} has no proved correction", claim.id);
        }
    }
}

fn with_correction(claim: &Judged) -> impl Iterator<Item = &Judged> {
    std::iter::once(claim).chain(claim.correction.as_deref())
}

fn sections(judged: &[Judged]) -> Vec<String> {
    let mut sections: Vec<String> = judged.iter().map(|claim| claim.section.clone()).collect();
    sections.dedup();
    sections
}

fn slug(section: &str) -> String {
    let words: Vec<String> = section
        .split(|c: char| !c.is_ascii_alphanumeric())
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    words.join("-")
}
