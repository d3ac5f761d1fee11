//! Every file in the book is read and runs to its end; so does every fragment of one, inserted into the file before it, or into the
//! crane model in chapters without a file.

// the motors that scenes name
use dalembert_scenes::{ModelScene, parse_ensemble};
use machines as _;
use model::Fault;
use simulation::{Choice, IvpScene};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Chapters whose pieces are no systems, or belong to files of the repository: papers, and entries of the catalogue of failures.
const OTHERS: [&str; 3] = ["judging.md", "failures.md", "adding.md"];

fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src")
}

/// The chapters in the order of the book, each with its name.
fn chapters() -> Vec<(String, String)> {
    let read =
        |name: &str| std::fs::read_to_string(book().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let summary = read("SUMMARY.md");
    let names = summary.lines().filter_map(|line| line.split_once("](")?.1.strip_suffix(')'));
    names.filter(|name| !OTHERS.contains(name)).map(|name| (name.to_owned(), read(name))).collect()
}

/// The blocks of a language in a chapter.
fn blocks<'a>(chapter: &'a str, language: &str) -> Vec<&'a str> {
    // outside and inside in turn
    let inside = chapter.split("\n```").skip(1).step_by(2);
    inside.filter_map(|block| block.strip_prefix(language)?.strip_prefix('\n')).collect()
}

/// A file in pieces, each from its heading on; the first one has none.
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

/// A file with a piece: its tables take the place of those with the same heading.
fn with(file: &str, piece: &str) -> String {
    let added = pieces(piece);
    let replaced = |old: &&String| !heading(old).is_empty() && added.iter().any(|new| heading(new) == heading(old));
    let kept: String = pieces(file).iter().filter(|old| !replaced(old)).cloned().collect();
    format!("{kept}\n{piece}\n")
}

/// A block as a file runs to its end; the parameters that nothing in it uses.
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
    // parameters of the crane are used by it, or by a piece that is put into it
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
