//! Sizes beyond a limit are refused with their location and with the accepted sizes.

use crate::{root, run, temporary};

fn refused(text: &str, name: &str, options: &[&str]) -> String {
    let path = temporary(name);
    std::fs::write(&path, text).expect("it can be written");
    let output = run(&[&["run", &path.to_string_lossy()], options].concat());
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(output.status.code(), Some(2));
    String::from_utf8(output.stderr).expect("text")
}

/// A scene whose motor has 1000 bars.
fn of_many_bars() -> String {
    let text = std::fs::read_to_string(root().join("scenes/spin_up.toml")).expect("it is there");
    text.replace("bars = 8", "bars = 1000")
}

#[test]
fn samples_that_would_fill_the_memory_are_refused() {
    let many = of_many_bars();
    let message = refused(&many.replace("samples = 600", "samples = 1_000_000"), "samples.toml", &[]);
    assert!(message.contains("samples.toml:") && message.contains("`samples` is out of range"), "{message}");
    assert!(message.contains("a whole number from 1 to 3"), "{message}");
    let message = refused(&many, "many_bars.toml", &["--samples", "1000000"]);
    assert!(message.contains("--samples 1000000") && message.contains("a whole number from 1 to 3"), "{message}");
}

#[test]
fn a_file_that_is_no_scene_by_its_size_is_refused() {
    let text = std::fs::read_to_string(root().join("scenes/spin_up.toml")).expect("it is there");
    let message = refused(&(text + &"# more\n".repeat(200_000)), "large.toml", &[]);
    assert!(message.contains("more than 1000000 bytes"), "{message}");
}

#[test]
fn thirty_errors_are_shown_and_the_rest_counted() {
    let unknown: String = (0..40_000).map(|n| format!("key{n} = {n}\n")).collect();
    let text = std::fs::read_to_string(root().join("scenes/bench.toml")).expect("it is there");
    let message = refused(&(unknown + &text), "unknown_keys.toml", &[]);
    assert_eq!(message.matches("unknown key `key").count(), 30, "{message}");
    assert!(message.contains("and 39970 more errors in "), "{message}");
}

#[test]
fn tables_within_tables_end_somewhere() {
    for nested in ["[".repeat(300_000), "a = ".to_owned() + &"{a = ".repeat(100_000)] {
        let message = refused(&nested, "nested.toml", &[]);
        assert!(message.contains("this is not TOML"), "{message}");
    }
}
