//! Verdicts on papers given as files: snapshots for review, and comparison with the same papers in Rust.

use claims::catalogue::papers;
use claims::{Statement, Verdict};
use dalembert_derivations as _;
use manuscript::{Finding, PaperText};
use std::path::{Path, PathBuf};
use symbolic::decide;

/// Papers that exist only as files, and those that also have a page in Rust; the report shows them.
const FOLDERS: [&str; 2] = ["papers", "papers/beside_pages"];

fn files() -> Vec<PathBuf> {
    let entries = |folder: &&str| {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        std::fs::read_dir(folder).expect("there are papers")
    };
    let mut files: Vec<PathBuf> =
        FOLDERS.iter().flat_map(entries).map(|entry| entry.expect("it can be listed").path()).collect();
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

/// Claims that occur both in a file and in a page in Rust: the file, its claim, the page, the claim there.
const IN_BOTH: [(&str, &str, &str, &str); 33] = [
    ("manglieva2022_governor", "eq3.3/energy", "manglieva2022", "eq3.3/energy"),
    ("manglieva2022_governor", "eq3.3/condition", "manglieva2022", "eq3.3/equations"),
    ("manglieva2022_governor", "eq3.3/second_form", "manglieva2022", "eq3.3/equations"),
    ("manglieva2022_governor", "eq3.3/wheel", "manglieva2022", "eq3.3/equations"),
    ("manglieva2022_governor", "eq3.5", "manglieva2022", "eq3.5/law"),
    ("manglieva2022_two_discs", "wheel", "manglieva2022", "section3.1-governor2/wheel-half"),
    ("manglieva2022_two_discs", "equation/first_form", "manglieva2022", "section3.1-governor2/equation"),
    ("manglieva2022_two_discs", "equation/second_form", "manglieva2022", "section3.1-governor2/equation"),
    ("manglieva2022_two_discs", "axis", "manglieva2022", "section3.1-governor2/wheel-axis"),
    ("manglieva2022_released", "eq3.25", "manglieva2022", "eq3.25/energy"),
    ("manglieva2022_released", "eq3.26/rotation", "manglieva2022", "eq3.26/rotation"),
    ("manglieva2022_released", "eq3.26/wheel", "manglieva2022", "eq3.26/wheel"),
    ("manglieva2022_released", "eq3.27/1", "manglieva2022", "eq3.27/equations"),
    ("manglieva2022_released", "eq3.27/2", "manglieva2022", "eq3.27/equations"),
    ("mukharlyamov2007_drive", "rod/row/1", "mukharlyamov2007", "section6-drive/row"),
    ("mukharlyamov2007_drive", "rod/row/2", "mukharlyamov2007", "section6-drive/row"),
    ("mukharlyamov2007_top", "eq21/first", "mukharlyamov2007", "eq21/first"),
    ("mukharlyamov2007_top", "eq21/second", "mukharlyamov2007", "eq21/second"),
    ("mukharlyamov2007_top", "eq21/third", "mukharlyamov2007", "eq21/first"),
    ("mukharlyamov2007_top", "eq21/vertical/1", "mukharlyamov2007", "eq21/vertical"),
    ("mukharlyamov2007_top", "eq17/energy", "mukharlyamov2007", "eq21/integrals"),
    ("mukharlyamov2007_top", "eq17/momentum", "mukharlyamov2007", "eq21/integrals"),
    ("mukharlyamov2007_top", "eq17/axial", "mukharlyamov2007", "eq21/integrals"),
    ("mukharlyamov2007_top", "eq22/spin/1", "mukharlyamov2007", "eq22/rotation"),
    ("mukharlyamov2007_varying", "eq16/equations/1", "mukharlyamov2007", "eq16/solidified"),
    ("mukharlyamov2007_varying", "eq19/first", "mukharlyamov2007", "eq19/first"),
    ("mukharlyamov2007_varying", "eq19/second", "mukharlyamov2007", "eq19/second"),
    ("mukharlyamov2007_varying", "eq19/denominator", "mukharlyamov2007", "eq19/denominator"),
    // the published disc: its three equations are the lines of one claim of the page
    ("rolling_disc", "eq3", "principles", "museum/disc#1"),
    ("rolling_disc", "eq4", "principles", "museum/disc#2"),
    ("rolling_disc", "eq5", "principles", "museum/disc#0"),
    ("rolling_disc", "eq4", "principles", "museum/disc"),
    ("rolling_disc", "eq5", "principles", "museum/disc"),
];

#[test]
fn a_file_and_a_page_in_rust_have_the_same_verdicts() {
    for file in files() {
        let name = file.file_stem().and_then(|name| name.to_str()).unwrap_or_default().to_owned();
        let pairs: Vec<_> = IN_BOTH.iter().filter(|(of_file, ..)| *of_file == name).collect();
        if pairs.is_empty() {
            continue;
        }
        let (key, found) = judged(&file);
        for (_, of_file, paper, of_page) in pairs {
            let here = found.iter().find(|finding| finding.judged.id == format!("{key}/{of_file}"));
            let here = here.unwrap_or_else(|| panic!("{key} has no claim {of_file}"));
            let (there, is_corrected) = verdict_in_rust(paper, of_page);
            assert_eq!(here.judged.verdict, there, "{key}/{of_file}: {}", here.text());
            // the recorded correction is found from the printed formula
            let is_found = !here.corrections.is_empty();
            assert_eq!(is_found, is_corrected && there == Verdict::Refuted, "{key}/{of_file}: {}", here.text());
        }
    }
}

/// The verdict on a claim of a page (`entry#line` for one of its equations), and whether it has a proved correction.
fn verdict_in_rust(paper: &str, id: &str) -> (Verdict, bool) {
    let paper = papers().into_iter().find(|one| one.key == paper).expect("it is linked");
    let page = (paper.page)();
    let (entry, line) = id.split_once('#').map_or((id, None), |(entry, line)| (entry, line.parse::<usize>().ok()));
    let id = format!("{}/{entry}", paper.key);
    let claim = page.claims().iter().find(|claim| claim.id == id).unwrap_or_else(|| panic!("no claim {id}"));
    let judged = page.judged(|one| one.id == id).next().expect("it is judged");
    let is_corrected = judged.correction.is_some_and(|correction| correction.verdict == Verdict::Proved);
    match (&claim.statement, line) {
        (Statement::Equations { lines, hypotheses }, Some(line)) => {
            let holds = decide(lines[line].derived - lines[line].printed(), hypotheses).is_zero();
            (if holds { Verdict::Proved } else { Verdict::Refuted }, is_corrected)
        }
        _ => (judged.verdict, is_corrected),
    }
}
