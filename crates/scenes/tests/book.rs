//! Every file printed in the book is read and runs to its end. Fragments of files are inserted into the file before them, or in chapters without
//! a file into the model of the crane.

// registers the motors of the catalogue
use dalembert_scenes::{ModelScene, parse_ensemble};
use machines as _;
use model::Fault;
use simulation::{Choice, IvpScene};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Chapters without systems, or whose files are in the repository: papers, and entries of the catalogue of failures.
const OTHERS: [&str; 3] = ["judging.md", "failures.md", "adding.md"];

fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src")
}

/// Names and texts of the chapters, in the order of the book.
fn chapters() -> Vec<(String, String)> {
    let read =
        |name: &str| std::fs::read_to_string(book().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let summary = read("SUMMARY.md");
    let names = summary.lines().filter_map(|line| line.split_once("](")?.1.strip_suffix(')'));
    names.filter(|name| !OTHERS.contains(name)).map(|name| (name.to_owned(), read(name))).collect()
}

/// The code blocks of a language in a chapter.
fn blocks<'a>(chapter: &'a str, language: &str) -> Vec<&'a str> {
    // text between fences is outside and inside a block in turn
    let inside = chapter.split("\n```").skip(1).step_by(2);
    inside.filter_map(|block| block.strip_prefix(language)?.strip_prefix('\n')).collect()
}

/// The sections of a file, each from its heading on; the first section has no heading.
fn pieces(text: &str) -> Vec<String> {
    let mut pieces = vec![String::new()];
    for line in text.lines() {
        if line.starts_with('[') {
            pieces.push(String::new());
        }
        let last = pieces.last_mut().expect("one stands there");
        *last += &format!("{line}\n");
    }
    pieces
}

fn heading(piece: &str) -> &str {
    piece.split(']').next().filter(|heading| heading.starts_with('[')).unwrap_or("")
}

/// A file with a fragment, whose sections replace those with equal headings.
fn with(file: &str, piece: &str) -> String {
    let added = pieces(piece);
    let replaced = |old: &&String| !heading(old).is_empty() && added.iter().any(|new| heading(new) == heading(old));
    let kept: String = pieces(file).iter().filter(|old| !replaced(old)).cloned().collect();
    format!("{kept}\n{piece}\n")
}

/// Runs a block as a file to its end; returns the warnings about unused parameters.
fn unused_in(text: &str, block: &str) -> BTreeSet<String> {
    let scene = ModelScene::parse("book", text).unwrap_or_else(|error| panic!("{error}"));
    let (unused, others): (Vec<&Fault>, Vec<&Fault>) =
        scene.model.warnings.iter().partition(|warning| warning.title.ends_with("` is not used"));
    assert!(others.is_empty(), "{others:?}\n{block}");
    let choice = Choice { allowed: Duration::from_secs(60), ..scene.run().choice() };
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    assert_eq!(trajectory.stopped(), None, "{block}");
    assert!(trajectory.last.iter().all(|value| value.is_finite()), "{block}");
    if text.contains("members = ") {
        assert!(parse_ensemble("book", text).is_ok(), "{block}");
    }
    unused.iter().map(|warning| text[warning.span.clone()].to_owned()).collect()
}

#[test]
fn every_file_and_piece_of_the_book_runs() {
    let chapters = chapters();
    let is_file = |block: &&str| block.contains("coordinates]") || block.contains("\ncoordinates = ");
    let crane = chapters.iter().flat_map(|(_, text)| blocks(text, "toml")).find(|block| block.contains("A crane"));
    let crane = crane.expect("the book has the crane");
    // each parameter of the crane is used by the crane or by a fragment inserted into it
    let (mut open, mut count) = (unused_in(crane, crane), 0);
    for (_, chapter) in &chapters {
        let mut file = crane;
        for block in blocks(chapter, "toml") {
            count += 1;
            if is_file(&block) {
                file = block;
                let unused = unused_in(block, block);
                assert!(file == crane || unused.is_empty(), "nothing uses {unused:?}\n{block}");
            } else {
                let still = unused_in(&with(file, block), block);
                if file == crane {
                    open.retain(|parameter| still.contains(parameter));
                }
            }
        }
    }
    assert!(open.is_empty(), "no piece uses {open:?}");
    assert!(count >= 30, "only {count} blocks were found");
}
