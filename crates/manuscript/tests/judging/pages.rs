//! The papers of the repository as they are judged, locked as pages for review.

use dalembert_manuscript::PaperText;
use machines as _;
use std::path::Path;

#[test]
fn every_paper_reads_as_reviewed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../papers");
    let entries = std::fs::read_dir(folder).expect("there are papers");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("it can be listed").path()).collect();
    files.retain(|file| file.extension().is_some_and(|end| end == "toml"));
    files.sort();
    for file in files {
        let paper = PaperText::read(&file).unwrap_or_else(|error| panic!("{error}"));
        let found = paper.judge().unwrap_or_else(|error| panic!("{error}"));
        let text: String = found.iter().map(|finding| finding.text()).collect();
        insta::with_settings!({
            snapshot_path => "../../../../snapshots/manuscripts", prepend_module_to_snapshot => false, omit_expression => true,
        }, { insta::assert_snapshot!(paper.key.as_str(), text) });
    }
}
