//! The last line of a written program or picture: the hash of the lines above it. A file whose lines were changed by hand is not replaced.

use hmac_sha256::Hash;
use std::io::{self, Write};

const SAID: &str = "sha256 of the lines above:";

/// The signs about a comment of one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comment {
    pub opens: &'static str,
    /// Empty where the end of the line ends it.
    pub closes: &'static str,
}

impl Comment {
    fn line(self, hash: Hash) -> String {
        format!("{} {SAID} {}{}", self.opens, hex(hash), self.closes)
    }
}

/// Writes content, a line end where its last line has none, then the hash of all that as a comment.
pub fn sealed(
    out: &mut dyn Write,
    comment: Comment,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut hashed = Hashed { out, hash: Hash::new(), last: b'\n' };
    content(&mut hashed)?;
    if hashed.last != b'\n' {
        hashed.write_all(b"\n")?;
    }
    let Hashed { out, hash, .. } = hashed;
    writeln!(out, "{}", comment.line(hash))
}

/// Whether the last line is the hash of the lines above it.
pub fn is_whole(text: &[u8], comment: Comment) -> bool {
    let Some((last, content)) = text.split_last().filter(|(end, _)| **end == b'\n').and_then(|(_, rest)| {
        let begin = rest.iter().rposition(|byte| *byte == b'\n')? + 1;
        Some((&rest[begin..], &text[..begin]))
    }) else {
        return false;
    };
    let mut hash = Hash::new();
    hash.update(content);
    last == comment.line(hash).as_bytes()
}

fn hex(hash: Hash) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

struct Hashed<'a> {
    out: &'a mut dyn Write,
    hash: Hash,
    /// The last byte so far.
    last: u8,
}

impl Write for Hashed<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.hash.update(&bytes[..written]);
        self.last = bytes[..written].last().copied().unwrap_or(self.last);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::{Comment, is_whole, sealed};

    const C: Comment = Comment { opens: "//", closes: "" };
    const XML: Comment = Comment { opens: "<!--", closes: " -->" };

    #[test]
    fn a_seal_breaks_where_a_line_is_changed_added_or_lost() {
        for (comment, content) in [(C, "// made\nint a;\n"), (XML, "<!-- // made\n -->\n<svg>int a;</svg>")] {
            let mut text = Vec::new();
            sealed(&mut text, comment, |out| out.write_all(content.as_bytes())).expect("memory can be written");
            let other = if comment == C { XML } else { C };
            assert!(is_whole(&text, comment) && !is_whole(&text, other));
            let told = String::from_utf8(text).expect("it is text");
            for changed in [told.replace("int a", "int b"), format!("{told}int b;\n"), told.replace("// made\n", "")] {
                assert!(!is_whole(changed.as_bytes(), comment), "{changed}");
            }
            let cut = told.trim_end();
            assert!([&b""[..], b"int a;\n", cut.as_bytes()].iter().all(|text| !is_whole(text, comment)));
        }
    }
}
