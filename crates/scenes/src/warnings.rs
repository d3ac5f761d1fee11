//! Warnings of files: accepted texts that may not mean what their author intended.

use model::Fault;
use std::sync::OnceLock;

/// A function that reports a warning of one line.
pub type Warn = fn(&str);

static WARN: OnceLock<Warn> = OnceLock::new();

/// Sets the function that reports warnings; only the first call counts, and without one warnings are dropped.
pub(crate) fn warn_by(warn: Warn) {
    WARN.get_or_init(|| warn);
}

/// Reports the warnings of a text, each with the text's name, line and column.
pub(crate) fn warn_of(name: &str, text: &str, warnings: &[Fault]) {
    let Some(warn) = WARN.get() else { return };
    warnings.iter().for_each(|warning| warn(&line(name, text, warning)));
}

/// The line of a warning: `file.toml:12:9: warning: title; what would say it plainly`
fn line(name: &str, text: &str, Fault { span, title, label, accepted }: &Fault) -> String {
    let before = text.get(..span.start).unwrap_or(text);
    let (row, column) = (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1);
    format!("warning: {name}:{row}:{column}: {title}: {label}; {accepted}")
}
