//! Papers that are files, as they are judged: locked as pages for review, and beside the same paper in Rust.

use claims::Verdict;
use claims::catalogue::papers;
use dalembert_derivations as _;
use manuscript::{Finding, PaperText};
use std::path::{Path, PathBuf};

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("papers");
    let entries = std::fs::read_dir(folder).expect("there are papers");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("it can be listed").path()).collect();
    files.retain(|file| file.extension().is_some_and(|end| end == "toml"));
    files.sort();
    files
}

fn judged(file: &Path) -> (String, Vec<Finding>) {
    let paper = PaperText::read(file).unwrap_or_else(|error| panic!("{error}"));
    let found = paper.judge().unwrap_or_else(|error| panic!("{error}"));
    (paper.key, found)
}

#[test]
fn every_paper_that_is_a_file_reads_as_reviewed() {
    for file in files() {
        let (key, found) = judged(&file);
        let text: String = found.iter().map(Finding::text).collect();
        insta::with_settings!({
            snapshot_path => "../../snapshots/manuscripts", prepend_module_to_snapshot => false, omit_expression => true,
        }, { insta::assert_snapshot!(key, text) });
    }
}

/// Equations of section 3.1 that both ways have: (claim of the file, claim in Rust).
const IN_BOTH: [(&str, &str); 4] = [
    ("eq3.3/condition", "eq3.3/equations"),
    ("eq3.3/second_form", "eq3.3/equations"),
    ("eq3.3/wheel", "eq3.3/equations"),
    ("eq3.5", "eq3.5/law"),
];

#[test]
fn a_section_as_a_file_has_the_verdicts_of_the_page_in_rust() {
    let file = files().into_iter().find(|file| file.ends_with("manglieva2022_governor.toml")).expect("it is there");
    let (key, found) = judged(&file);
    let paper = papers().into_iter().find(|paper| paper.key == "manglieva2022").expect("it is linked");
    let page: Vec<_> = (paper.page)().judged(|claim| IN_BOTH.iter().any(|(_, id)| claim.id.ends_with(id))).collect();
    for (of_file, of_page) in IN_BOTH {
        let id = format!("{key}/{of_file}");
        let here = found.iter().find(|finding| finding.judged.id == id).expect("the file has the claim");
        let there = page.iter().find(|claim| claim.id.ends_with(of_page)).expect("the page has the claim");
        assert_eq!(here.judged.verdict, there.verdict, "{id}");
        assert_eq!(here.judged.verdict, Verdict::Proved, "{id}");
    }
}
