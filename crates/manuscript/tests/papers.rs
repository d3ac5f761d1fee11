//! Each claim of each paper under `papers/` is a separate test: `cargo test -p dalembert-manuscript --test papers -- cart_pole/eq5`.

use dalembert_manuscript::PaperText;
use libtest_mimic::{Arguments, Failed, Trial};
use machines as _;
use std::path::{Path, PathBuf};

fn main() {
    let arguments = Arguments::from_args();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../papers");
    let mut files = Vec::new();
    collect(&root, &mut files);
    files.sort();
    let mut trials = vec![Trial::test("papers are found", {
        let count = files.len();
        move || if count > 0 { Ok(()) } else { Err(Failed::from("no file papers/**/*.toml was found")) }
    })];
    trials.extend(files.iter().flat_map(|file| trials_of(file)));
    libtest_mimic::run(&arguments, trials).exit();
}

/// One test for each claim, or one that reports why the file cannot be read.
fn trials_of(file: &Path) -> Vec<Trial> {
    let findings = PaperText::read(file).and_then(|paper| paper.judge());
    match findings {
        Ok(findings) => findings
            .into_iter()
            .map(|finding| Trial::test(finding.judged.id.clone(), move || finding.as_expected().map_err(Failed::from)))
            .collect(),
        Err(error) => {
            let name = format!("{} is read", file.file_stem().unwrap_or_default().to_string_lossy());
            vec![Trial::test(name, move || Err(Failed::from(error.to_string())))]
        }
    }
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|end| end == "toml") {
            files.push(path);
        }
    }
}
