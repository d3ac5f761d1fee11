//! Help for syntax errors of TOML, most often a key with a prime and without quotes.

use reader::SceneError;

/// Adds help to each syntax error of TOML: the key that needs quotes, if the line has one, or the forms that TOML accepts.
pub fn with_quoted_primes(mut error: SceneError) -> SceneError {
    let SceneError { text, issues, .. } = &mut error;
    for issue in issues.iter_mut().filter(|issue| issue.help.is_none()) {
        let Some(place) = issue.span.as_ref().map(|span| span.start.min(text.len())) else { continue };
        let begin = text.as_bytes()[..place].iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
        let line = text.get(begin..).and_then(|rest| rest.lines().next()).unwrap_or("");
        let help = match (primed_key(line), unquoted_key(line)) {
            (Some(key), _) => format!("a key with a prime stands in quotes: \"{key}\" = ..."),
            (None, Some(key)) => {
                format!(
                    "a key with other characters than ASCII letters, digits, `-` and `_` stands in quotes: \"{key}\" = ..."
                )
            }
            _ if issue.label.contains("duplicate") => "each name stands once in its table".to_owned(),
            _ => "keys, tables and texts as TOML has them: key = \"text\", [table], [[list of tables]]".to_owned(),
        };
        issue.help = Some(help);
    }
    error
}

/// The name with a prime before `=`, if it has no quotes.
fn primed_key(line: &str) -> Option<&str> {
    line.split('=').rev().skip(1).find_map(|before| {
        let before = before.trim_end();
        let name = before.rsplit(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '\'' | '′'))).next()?;
        let is_primed = name.ends_with(['\'', '′']) && name.starts_with(char::is_alphabetic);
        is_primed.then_some(name)
    })
}

/// The text before the first `=`, if it needs quotes and has none.
fn unquoted_key(line: &str) -> Option<&str> {
    let key = line.split_once('=')?.0.trim();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.' | ' ');
    let is_quoted = key.starts_with(['"', '\'', '[', '#', '{']);
    (!key.is_empty() && !is_quoted && !key.chars().all(is_plain)).then_some(key)
}
