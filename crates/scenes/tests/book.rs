//! Every file that the book shows is read and runs to its end; so does every piece of one, put into the file before it.

// the motors that scenes name
use dalembert_scenes::ModelScene;
use machines as _;
use model::Fault;
use simulation::{Choice, IvpScene};
use std::time::Duration;

const BOOK: &str = include_str!("../../../book/src/models.md");

/// The blocks of a language.
fn blocks(language: &str) -> Vec<&'static str> {
    let parts = BOOK.split("\n```").collect::<Vec<_>>();
    // outside and inside in turn
    let inside = parts.iter().skip(1).step_by(2);
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

#[test]
fn every_file_and_piece_of_the_book_runs() {
    let (mut file, mut count, mut open) = ("", 0, Vec::<String>::new());
    for block in blocks("toml") {
        let text = match block.contains("[coordinates]") {
            true => {
                file = block;
                block.to_owned()
            }
            false => with(file, block),
        };
        let scene = ModelScene::parse("book", &text).unwrap_or_else(|error| panic!("{error}"));
        let (unused, others): (Vec<&Fault>, Vec<&Fault>) =
            scene.model.warnings.iter().partition(|warning| warning.title.starts_with("nothing uses the parameter `"));
        assert!(others.is_empty(), "{others:?}\n{block}");
        // parameters of a file are used by it, or by a piece that is put into it
        let name = |warning: &&Fault| text[warning.span.clone()].to_owned();
        match block.contains("[coordinates]") {
            true => {
                assert!(open.is_empty(), "no piece uses {open:?}");
                open = unused.iter().map(name).collect();
            }
            false => {
                let still: Vec<String> = unused.iter().map(name).collect();
                open.retain(|parameter| still.contains(parameter));
            }
        }
        let choice = Choice { allowed: Duration::from_secs(60), ..scene.run().choice() };
        let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
        assert_eq!(trajectory.stopped(), None, "{block}");
        assert!(trajectory.last.iter().all(|value| value.is_finite()), "{block}");
        count += 1;
    }
    assert!(open.is_empty(), "no piece uses {open:?}");
    assert!(count >= 14, "only {count} blocks were found");
}

/// The table of units in the book is the one of the reader.
#[test]
fn the_book_lists_every_unit_that_is_read() {
    let section = BOOK.split("\n### Units\n").nth(1).and_then(|rest| rest.split("\n#").next()).expect("it is there");
    let listed = |row: &str| -> Vec<String> {
        let line = section.lines().find(|line| line.starts_with(&format!("| {row} |"))).expect("the row is there");
        let mut names: Vec<String> = line.split('`').skip(1).step_by(2).map(str::to_owned).collect();
        names.sort();
        names
    };
    let read = |names: &mut dyn Iterator<Item = &'static str>| -> Vec<String> {
        let mut names: Vec<String> = names.map(str::to_owned).collect();
        names.sort();
        names
    };
    assert_eq!(listed("with a prefix or without"), read(&mut units::Unit::with_prefixes()));
    assert_eq!(listed("without prefixes"), read(&mut units::Unit::without_prefixes()));
    assert_eq!(listed("prefixes"), read(&mut units::Unit::prefixes()));
}
