//! Warnings about texts that are accepted but may not mean what the author intended.

use model::Fault;
use std::sync::OnceLock;

/// A function that prints a warning of one line.
pub type Warn = fn(&str);

static WARN: OnceLock<Warn> = OnceLock::new();

/// Sets the function that prints warnings. Only the first call has an effect; without one, warnings are dropped.
pub(crate) fn warn_by(warn: Warn) {
    WARN.get_or_init(|| warn);
}

/// Prints the warnings about a text, each with the name of the text, line and column.
pub(crate) fn warn_of(name: &str, text: &str, warnings: &[Fault]) {
    let Some(warn) = WARN.get() else { return };
    warnings.iter().for_each(|warning| warn(&line(name, text, warning)));
}

/// The line of a warning: `warning: file.toml:12:9: title: label; a text without doubt`.
fn line(name: &str, text: &str, Fault { span, title, label, accepted }: &Fault) -> String {
    let before = text.get(..span.start).unwrap_or(text);
    let (row, column) = (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1);
    format!("warning: {name}:{row}:{column}: {title}: {label}; {accepted}")
}
