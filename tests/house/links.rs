//! Every link between documents leads to an existing file, and to an existing heading if it names one.

use super::rules::root;
use std::collections::HashMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

fn documents() -> Vec<PathBuf> {
    let chapters = fs::read_dir(root().join("book/src")).expect("the book has chapters");
    let chapters = chapters.map(|chapter| chapter.expect("a chapter can be listed").path());
    let of_the_root = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"].map(|name| root().join(name));
    chapters.filter(|path| path.extension().is_some_and(|end| end == "md")).chain(of_the_root).collect()
}

/// A document with the files it includes.
fn read(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    match text.trim().strip_prefix("{{#include ").and_then(|rest| rest.strip_suffix("}}")) {
        Some(other) => read(&path.parent().expect("a folder").join(other)),
        None => text,
    }
}

/// The lines of a document outside code blocks.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    let mut inside = false;
    text.lines().filter(move |line| {
        let is_fence = line.starts_with("```");
        inside ^= is_fence;
        !inside && !is_fence
    })
}

/// The anchors of a document's headings, as Markdown generates them.
fn anchors(text: &str) -> Vec<String> {
    let headings = prose(text).filter(|line| line.starts_with('#')).map(|line| line.trim_start_matches('#').trim());
    let kept = |letter: &char| letter.is_alphanumeric() || matches!(letter, ' ' | '-' | '_');
    headings.map(|heading| heading.chars().filter(kept).collect::<String>().to_lowercase().replace(' ', "-")).collect()
}

/// The targets of a document's links: the text in parentheses after brackets.
fn links(text: &str) -> Vec<String> {
    let of_line = |line: &str| {
        let targets = line.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        targets.map(str::to_owned).collect::<Vec<_>>()
    };
    prose(text).flat_map(of_line).collect()
}

#[test]
fn every_link_between_documents_leads_somewhere() {
    let mut wrong = String::new();
    let mut known: HashMap<PathBuf, Vec<String>> = HashMap::new();
    for document in documents() {
        let folder = document.parent().expect("a folder");
        for link in links(&fs::read_to_string(&document).expect("a document is text")) {
            if link.contains("://") {
                continue;
            }
            let (file, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target = if file.is_empty() { document.clone() } else { folder.join(file) };
            let leads = target.exists()
                && (anchor.is_empty()
                    || known
                        .entry(target.clone())
                        .or_insert_with(|| anchors(&read(&target)))
                        .iter()
                        .any(|one| one == anchor));
            if !leads {
                // writing to a string cannot fail
                let _ = writeln!(wrong, "{}: {link}", document.display());
            }
        }
    }
    assert!(wrong.is_empty(), "links that lead nowhere:\n{wrong}");
}
