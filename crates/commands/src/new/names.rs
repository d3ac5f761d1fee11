//! Checks of names of new motors: each must serve as a file, a module, a type and a test on every system, without a clash of names.

use super::{LIST, MACHINE, TEST, camel};
use crate::exit::Exit;
use std::fs;
use std::path::Path;

/// Keywords of Rust, which no module can have as its name; a test called `main` has a special meaning.
const WORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "main",
    "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static", "struct", "super",
    "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Rust's own crates, those of the tests, and those that motors use: a module of such a name would hide them.
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

/// Names of Rust's prelude: a motor's type would hide them.
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

/// Names of devices, which cannot be names of files on some systems, with any extension.
const DEVICES: &[&str] = &["aux", "con", "nul", "prn"];

/// Accepts letters, digits and _, beginning with a letter, and no keyword of Rust.
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

/// Refuses a name that Rust, an operating system or the project uses already.
pub fn check_free(name: &str, project: &Path) -> Result<(), Exit> {
    match taken(name, project) {
        None => Ok(()),
        Some(by) => Err(Exit::refused(format!(
            "`{name}` cannot name a motor: {by}; another name is accepted, such as `salient_pole`"
        ))),
    }
}

/// The present owner of the name, or of the type's name.
fn taken(name: &str, project: &Path) -> Option<String> {
    let capital = camel(name);
    if is_device(name) {
        return Some("files of this name are devices under some systems".to_owned());
    }
    if CRATES.contains(&name) || PRIMITIVES.contains(&name) || PRELUDE.contains(&&*capital) {
        return Some(format!("the language has `{name}` or `{capital}` already"));
    }
    let manifest = fs::read_to_string(project.join("Cargo.toml")).unwrap_or_default();
    // lines of a manifest begin with a key, for dependencies the name of the crate
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

/// Whether a name is that of a device, also with a number, as for the first serial port.
fn is_device(name: &str) -> bool {
    let port = name.strip_prefix("com").or_else(|| name.strip_prefix("lpt"));
    DEVICES.contains(&name)
        || port.is_some_and(|number| number.len() == 1 && number.bytes().all(|n| n.is_ascii_digit()))
}

/// The identifiers in a Rust text, without those in its comments.
fn identifiers(text: &str) -> impl Iterator<Item = &str> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')).filter(|word| !word.is_empty())
}
