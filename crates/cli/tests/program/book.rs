//! The commands of the book can be given as they stand there.

use crate::{root, run};

#[test]
fn every_command_of_the_book_is_accepted() {
    let chapters = std::fs::read_dir(root().join("book/src")).expect("the book has chapters");
    let chapters = chapters.map(|entry| entry.expect("a chapter can be listed").path());
    let text: String = chapters.map(|path| std::fs::read_to_string(path).expect("a chapter is text")).collect();
    let commands: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("$ dalembert ")).collect();
    assert!(commands.len() >= 10);
    for command in commands {
        let output = run(&command.split_whitespace().collect::<Vec<_>>());
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(0 | 1)) && !output.stdout.is_empty(), "{command}: {message}");
    }
}
