//! Checks of the name of a new motor: it must be valid as a file, a module, a type and a test on every system, and not be in use.

use super::{LIST, MACHINE, TEST, camel};
use crate::exit::Exit;
use std::fs;
use std::path::Path;

/// Keywords of Rust, which cannot name a module, and `main`, which has a special meaning for a test.
const WORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "main",
    "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static", "struct", "super",
    "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Rust's own crates, and the crates that tests and motors use; a module with such a name would hide the crate.
const CRATES: &[&str] = &[
    "alloc",
    "claims",
    "core",
    "dalembert",
    "dalembert_derivations",
    "derivations",
    "field",
    "motor",
    "proc_macro",
    "reader",
    "simulation",
    "std",
    "symbolic",
    "test",
];

/// Rust's primitive types.
const PRIMITIVES: &[&str] = &[
    "bool", "char", "f16", "f32", "f64", "f128", "i8", "i16", "i32", "i64", "i128", "isize", "str", "u8", "u16", "u32",
    "u64", "u128", "usize",
];

/// Names of Rust's prelude, which a type of such a name would hide.
const PRELUDE: &[&str] = &[
    "AsMut",
    "AsRef",
    "AsyncFn",
    "AsyncFnMut",
    "AsyncFnOnce",
    "Box",
    "Clone",
    "Copy",
    "Debug",
    "Default",
    "DoubleEndedIterator",
    "Drop",
    "Eq",
    "Err",
    "ExactSizeIterator",
    "Extend",
    "Fn",
    "FnMut",
    "FnOnce",
    "From",
    "FromIterator",
    "Future",
    "Hash",
    "Into",
    "IntoFuture",
    "IntoIterator",
    "Iterator",
    "None",
    "Ok",
    "Option",
    "Ord",
    "PartialEq",
    "PartialOrd",
    "Result",
    "Self",
    "Send",
    "Sized",
    "Some",
    "String",
    "Sync",
    "ToOwned",
    "ToString",
    "TryFrom",
    "TryInto",
    "Unpin",
    "Vec",
];

/// Names of devices, which some systems do not accept as names of files, with any extension.
const DEVICES: &[&str] = &["aux", "con", "nul", "prn"];

/// Accepts lower-case letters, digits and _, beginning with a letter; refuses keywords of Rust.
pub fn check_letters(name: &str) -> Result<(), Exit> {
    let begins = name.bytes().next().is_some_and(|byte| byte.is_ascii_lowercase());
    let goes_on = name.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_');
    let word = WORDS.contains(&name) || name.starts_with("text");
    if !(begins && goes_on && name.len() <= 40) || word {
        return Err(Exit::refused(format!(
            "`{name}` cannot name a motor: up to 40 lower case letters, digits and _ are accepted, a letter first, and no \
             word of the language, and nothing that begins with `text`: such as `salient_pole`"
        )));
    }
    Ok(())
}

/// Refuses a name that Rust, an operating system or the project already uses.
pub fn check_free(name: &str, project: &Path) -> Result<(), Exit> {
    match taken(name, project) {
        None => Ok(()),
        Some(by) => Err(Exit::refused(format!(
            "`{name}` cannot name a motor: {by}; another name is accepted, such as `salient_pole`"
        ))),
    }
}

/// The reason for which the name, or the name of the type, is in use; `None` if it is free.
fn taken(name: &str, project: &Path) -> Option<String> {
    let capital = camel(name);
    if is_device(name) {
        return Some("files of this name are devices under some systems".to_owned());
    }
    if CRATES.contains(&name) || PRIMITIVES.contains(&name) || PRELUDE.contains(&&*capital) {
        return Some(format!("the language has `{name}` or `{capital}` already"));
    }
    let manifest = fs::read_to_string(project.join("Cargo.toml")).unwrap_or_default();
    // a line of a manifest begins with a key, which for a dependency is the name of the crate
    let key = |line: &str| line.split(['.', '=', ' ']).next().is_some_and(|key| key.replace('-', "_") == name);
    if manifest.lines().any(key) {
        return Some("Cargo.toml has a crate or a key of this name".to_owned());
    }
    let list = fs::read_to_string(project.join(LIST)).unwrap_or_default();
    if identifiers(&list).any(|known| known == name || known == capital) {
        return Some(format!("`{name}` or `{capital}` stands in {LIST} already"));
    }
    let used = [MACHINE, TEST].into_iter().flat_map(identifiers).any(|known| known == capital);
    used.then(|| format!("the files of a new motor use `{capital}` for something else"))
}

/// Whether a name is that of a device, also with a digit: `com1` is the first serial port.
fn is_device(name: &str) -> bool {
    let port = name.strip_prefix("com").or_else(|| name.strip_prefix("lpt"));
    DEVICES.contains(&name)
        || port.is_some_and(|number| number.len() == 1 && number.bytes().all(|n| n.is_ascii_digit()))
}

/// The identifiers in a Rust text except those in comments.
fn identifiers(text: &str) -> impl Iterator<Item = &str> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')).filter(|word| !word.is_empty())
}
