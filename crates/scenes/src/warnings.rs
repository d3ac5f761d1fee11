//! Warnings of files: texts that are accepted, and perhaps mean something else.

use model::Fault;
use std::sync::OnceLock;

/// Tells a warning of one line.
pub type Warn = fn(&str);

static WARN: OnceLock<Warn> = OnceLock::new();

/// Gives warnings their reader; the first one given holds, and without one nothing is told.
pub(crate) fn warn_by(warn: Warn) {
    WARN.get_or_init(|| warn);
}

/// Tells the warnings of a text, which is called by a name, each with its line and column.
pub(crate) fn warn_of(name: &str, text: &str, warnings: &[Fault]) {
    let Some(warn) = WARN.get() else { return };
    warnings.iter().for_each(|warning| warn(&line(name, text, warning)));
}

/// `file.toml:12:9: warning: title; what would say it plainly`
fn line(name: &str, text: &str, Fault { span, title, label, accepted }: &Fault) -> String {
    let before = text.get(..span.start).unwrap_or(text);
    let (row, column) = (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1);
    format!("warning: {name}:{row}:{column}: {title}: {label}; {accepted}")
}
