//! Texts from outside the program, made safe to show in a terminal, a page or a picture.

use std::borrow::Cow;
use std::fmt::Write;

/// The text with control characters, and characters that break a line or change the direction of writing, replaced by escapes such as `\u001b`. A terminal
/// would obey such characters, and XML forbids some of them. Line feeds and tabs remain. The escapes are those of JSON,
/// so that the value of a JSON string is unchanged.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.chars().any(acts) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for letter in text.chars() {
        if acts(letter) {
            // writing to a string cannot fail
            let _ = write!(shown, "\\u{:04x}", u32::from(letter));
        } else {
            shown.push(letter);
        }
    }
    Cow::Owned(shown)
}

fn acts(letter: char) -> bool {
    match letter {
        '\n' | '\t' => false,
        // marks, embeddings, overrides and isolates of direction
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => true,
        // line and paragraph separators, and characters that XML forbids
        '\u{2028}' | '\u{2029}' | '\u{fffe}' | '\u{ffff}' => true,
        _ => letter.is_control(),
    }
}

#[cfg(test)]
mod tests {
    use super::visible;

    #[test]
    fn what_acts_on_a_reader_is_shown_by_its_code() {
        assert_eq!(visible("A\u{1b}[31m\u{7}\r\u{9b}2J\u{202e}B"), "A\\u001b[31m\\u0007\\u000d\\u009b2J\\u202eB");
        assert_eq!(visible("lines\n\tof γ̇, − and é"), "lines\n\tof γ̇, − and é");
    }
}
