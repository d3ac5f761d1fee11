//! Seals in programs, pictures, pages, references and certificates: the last line contains the hash of the lines above it.

use super::{Hashed, hex};
use hmac_sha256::Hash;
use std::io::{self, Write};

/// The text before and after the hash in the last line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Around {
    pub before: &'static str,
    pub after: &'static str,
}

impl Around {
    /// A comment after `//`.
    pub const SLASHES: Around = Around { before: "// sha256 of the lines above: ", after: "" };
    /// A comment after `#`.
    pub const SHARP: Around = Around { before: "# sha256 of the lines above: ", after: "" };
    /// A comment of XML and HTML.
    pub const MARKUP: Around = Around { before: "<!-- sha256 of the lines above: ", after: " -->" };
    /// The last key of a JSON object; the content must leave the object open.
    pub const JSON: Around = Around { before: ",\"sha256_of_the_lines_above\":\"", after: "\"}" };

    fn line(self, hash: Hash) -> String {
        format!("{}{}{}", self.before, hex(hash), self.after)
    }
}

/// Writes the content, a line end where its last line has none, then the line with the hash of all of this.
///
/// # Errors
/// Writing to `out` fails.
pub fn sealed(
    out: &mut dyn Write,
    around: Around,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut hashed = Hashed::of(out);
    content(&mut hashed)?;
    if hashed.last != b'\n' {
        hashed.write_all(b"\n")?;
    }
    let Hashed { out, hash, .. } = hashed;
    writeln!(out, "{}", around.line(hash))
}

/// Whether the last line contains the hash of the lines above it; `None` where no line looks like a seal.
pub fn holds(text: &[u8], around: Around) -> Option<bool> {
    let is_seal = |line: &[u8]| line.starts_with(around.before.as_bytes());
    text.split(|byte| *byte == b'\n').any(is_seal).then(|| is_whole(text, around))
}

fn is_whole(text: &[u8], around: Around) -> bool {
    let Some((last, content)) = text.split_last().filter(|(end, _)| **end == b'\n').and_then(|(_, rest)| {
        let begin = rest.iter().rposition(|byte| *byte == b'\n')? + 1;
        Some((&rest[begin..], &text[..begin]))
    }) else {
        return false;
    };
    let mut hash = Hash::new();
    hash.update(content);
    last == around.line(hash).as_bytes()
}

#[cfg(test)]
mod tests {
    use super::{Around, holds, sealed};

    #[test]
    fn a_seal_breaks_where_a_line_is_changed_added_or_lost() {
        for (around, content) in [
            (Around::SLASHES, "// made\nint a;\n"),
            (Around::SHARP, "# // made\nint a;"),
            (Around::MARKUP, "<!-- // made\n -->\n<svg>int a;</svg>"),
            (Around::JSON, "{\"// made\n\":\"int a\""),
        ] {
            let mut text = Vec::new();
            sealed(&mut text, around, |out| out.write_all(content.as_bytes())).expect("memory can be written");
            assert_eq!(holds(&text, around), Some(true));
            let told = String::from_utf8(text).expect("it is text");
            for changed in [
                told.replace("int a", "int b"),
                format!("{told}int b;\n"),
                told.replace("// made\n", ""),
                told.trim_end().to_owned(),
            ] {
                assert_eq!(holds(changed.as_bytes(), around), Some(false), "{changed}");
            }
            assert!([&b""[..], b"int a;\n", content.as_bytes()].iter().all(|text| holds(text, around).is_none()));
        }
    }

    #[test]
    fn an_object_of_json_stays_one() {
        let mut text = Vec::new();
        sealed(&mut text, Around::JSON, |out| out.write_all(b"{\"a\":1")).expect("memory can be written");
        let object: serde_json::Value = serde_json::from_slice(&text).expect("it is JSON");
        assert_eq!((&object["a"], object.as_object().map(serde_json::Map::len)), (&1.into(), Some(2)));
    }
}
