//! Every command in README, CONTRIBUTING and the book runs as printed there, and prints the lines shown below it.
//!
//! In a block ```` ```console ```` a line `$ dalembert ...` is a command. Text after ` # ` is a remark; `exit code N` in it states the exit
//! code, which is 0 otherwise. The lines below a command must be printed in this order; `...` stands for any number of other lines.
//! A block ```` ```toml ```` whose first line is `# NAME.toml` is the file of that name.

use crate::{program_in, root};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// A command in a document.
struct Shown {
    words: Vec<String>,
    code: i32,
    /// The lines that the command must print; empty if the document shows none.
    lines: Vec<String>,
}

/// The commands of the program in the blocks of a document.
fn commands(text: &str) -> Vec<Shown> {
    let mut found: Vec<Shown> = Vec::new();
    let mut inside = false;
    let mut ours = false;
    for line in text.lines() {
        match line.strip_prefix("```") {
            Some(kind) => inside = !inside && kind == "console",
            None if !inside => {}
            None => match line.strip_prefix("$ ") {
                Some(command) => {
                    let (command, remark) = command.split_once(" # ").unwrap_or((command, ""));
                    ours = command.starts_with("dalembert ");
                    if ours {
                        let words = words(command).into_iter().skip(1).collect();
                        let code =
                            remark.split("exit code ").nth(1).and_then(|rest| rest[..1].parse().ok()).unwrap_or(0);
                        found.push(Shown { words, code, lines: Vec::new() });
                    }
                }
                None if ours => found.last_mut().expect("a command stands first").lines.push(line.to_owned()),
                None => {}
            },
        }
    }
    found
}

/// The names and texts of the files in the blocks of a document.
fn files(text: &str) -> Vec<(&str, &str)> {
    let blocks = text.split("\n```toml\n").skip(1).filter_map(|rest| rest.split_once("\n```").map(|(block, _)| block));
    let named = |block| str::strip_prefix(block, "# ").and_then(|rest| rest.lines().next()).zip(Some(block));
    blocks.filter_map(named).filter(|(name, _)| name.ends_with(".toml") && !name.contains([' ', '/'])).collect()
}

/// The words of a command line; a text in quotes is one word, without the quotes.
fn words(command: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let (mut is_quoted, mut is_inside) = (false, false);
    for letter in command.chars() {
        match letter {
            '"' => is_quoted = !is_quoted,
            space if space.is_whitespace() && !is_quoted => {
                is_inside = false;
                continue;
            }
            _ => {}
        }
        if !std::mem::replace(&mut is_inside, true) {
            words.push(String::new());
        }
        if letter != '"' {
            words.last_mut().expect("a word has begun").push(letter);
        }
    }
    words
}

/// The first shown line that is missing in the output at its position; `None` if all are printed.
fn missing<'a>(shown: &'a [String], printed: &str) -> Option<&'a str> {
    let mut printed = printed.lines().map(str::trim_end);
    let mut next_one = true;
    for line in shown {
        if line.trim() == "..." {
            next_one = false;
            continue;
        }
        let stands = if next_one {
            printed.next() == Some(line.trim_end())
        } else {
            printed.any(|other| other == line.trim_end())
        };
        if !stands {
            return Some(line);
        }
        next_one = true;
    }
    None
}

/// Runs the commands of some documents in a temporary folder with copies of the scenes and papers, since some commands write files.
fn run_all(documents: &[&Path], least: usize) {
    let folder = tempfile::tempdir().expect("a folder can be made");
    for shown in ["scenes", "papers"] {
        copy(&root().join(shown), &folder.path().join(shown));
    }
    let (mut wrong, mut count) = (String::new(), 0);
    for document in documents {
        let text = fs::read_to_string(document).expect("a document is text");
        for (name, content) in files(&text) {
            fs::write(folder.path().join(name), content).expect("a file can be written");
        }
        for Shown { words, code, lines } in commands(&text) {
            count += 1;
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            // `review` reads an earlier text from git, and needs the project's folder
            let place = if words[0] == "review" { &root() } else { folder.path() };
            let output = program_in(place, &words).output().expect("the program starts");
            let (printed, told) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
            let command = format!("{}: dalembert {}", document.display(), words.join(" "));
            // writing to a string cannot fail
            if output.status.code() != Some(code) {
                let _ = writeln!(wrong, "{command}\n  ends with {}, not with {code}: {told}", output.status);
            } else if let Some(line) = missing(&lines, &printed) {
                let _ = writeln!(wrong, "{command}\n  does not print in its place: {line}\n  but:\n{printed}");
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(count >= least, "only {count} commands were found");
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder can be made");
    for entry in fs::read_dir(from).expect("a folder can be listed") {
        let (path, name) = entry.map(|entry| (entry.path(), entry.file_name())).expect("an entry can be read");
        match path.is_dir() {
            true => copy(&path, &to.join(name)),
            false => fs::copy(&path, to.join(name)).map(drop).expect("a file can be copied"),
        }
    }
}

#[test]
fn every_command_of_the_readme_runs_as_it_stands_there() {
    run_all(&[&root().join("README.md"), &root().join("CONTRIBUTING.md")], 5);
}

#[test]
fn every_command_of_the_book_runs_as_it_stands_there() {
    let chapters = fs::read_dir(root().join("book/src")).expect("the book has chapters");
    let mut chapters: Vec<_> = chapters.map(|entry| entry.expect("a chapter can be listed").path()).collect();
    chapters.sort();
    run_all(&chapters.iter().map(|path| &**path).collect::<Vec<_>>(), 20);
}

#[test]
fn a_line_that_is_not_printed_in_its_place_is_found() {
    let lines = |text: &str| text.split('|').map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(missing(&lines("a|b"), "a\nb\nc"), None);
    assert_eq!(missing(&lines("a|...|c"), "a\nb\nc"), None);
    assert_eq!(missing(&lines("a|c"), "a\nb\nc"), Some("c"));
    assert_eq!(missing(&lines("...|c|b"), "a\nb\nc"), Some("b"));
    let [first, second] = &commands(
        "```console\n$ dalembert run x  # exit code 1: it ends\nout\n$ cargo test\n$ dalembert y\n```\n$ dalembert z",
    )[..] else {
        panic!("two commands are shown")
    };
    assert_eq!((&first.words[..], first.code, &first.lines[..]), (&lines("run|x")[..], 1, &lines("out")[..]));
    assert_eq!((&second.words[..], second.code), (&lines("y")[..], 0));
}
