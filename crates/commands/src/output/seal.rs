//! The last line of a written program: the hash of the lines above it. A file whose lines were changed by hand is not replaced.

use hmac_sha256::Hash;
use std::io::{self, Write};

const SAID: &str = "sha256 of the lines above:";

/// Writes content, then the hash of it as a comment.
pub fn sealed(
    out: &mut dyn Write,
    comment: &str,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut hashed = Hashed { out, hash: Hash::new() };
    content(&mut hashed)?;
    let Hashed { out, hash } = hashed;
    writeln!(out, "{comment} {SAID} {}", hex(hash))
}

/// Whether the last line is the hash of the lines above it.
pub fn is_whole(text: &[u8], comment: &str) -> bool {
    let Some((last, content)) = text.split_last().filter(|(end, _)| **end == b'\n').and_then(|(_, rest)| {
        let begin = rest.iter().rposition(|byte| *byte == b'\n')? + 1;
        Some((&rest[begin..], &text[..begin]))
    }) else {
        return false;
    };
    let mut hash = Hash::new();
    hash.update(content);
    last == format!("{comment} {SAID} {}", hex(hash)).as_bytes()
}

fn hex(hash: Hash) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

struct Hashed<'a> {
    out: &'a mut dyn Write,
    hash: Hash,
}

impl Write for Hashed<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.hash.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::{is_whole, sealed};

    #[test]
    fn a_seal_breaks_where_a_line_is_changed_added_or_lost() {
        let mut text = Vec::new();
        sealed(&mut text, "//", |out| out.write_all(b"// made\nint a;\n")).expect("memory can be written");
        assert!(is_whole(&text, "//") && !is_whole(&text, "#"));
        let told = String::from_utf8(text).expect("it is text");
        for changed in [told.replace("int a", "int b"), format!("{told}int b;\n"), told.replace("// made\n", "")] {
            assert!(!is_whole(changed.as_bytes(), "//"), "{changed}");
        }
        assert!(!is_whole(b"", "//") && !is_whole(b"int a;\n", "//") && !is_whole(told.trim_end().as_bytes(), "//"));
    }
}
