//! Seals in tables with comments: the first comment ends with the hash of the rest of the table.
//!
//! The seal adds no line, so that readers that skip a fixed number of comments, or take the last line as a row, remain correct.
//! Since the seal stands at the beginning, rows that are appended or cut off do not remove it, and it no longer agrees with the table.

use super::{Hashed, hex};
use hmac_sha256::Hash;
use std::io::{self, BufRead, Seek, SeekFrom, Write};

const BEFORE: &str = "; sha256 of all else here: ";

/// The number of hexadecimal digits of a hash.
const DIGITS: usize = 64;

/// Writes a file from its beginning. If its first line is a comment, the hash of the content is inserted at the end of this line.
///
/// # Errors
/// Writing to `out` fails.
pub fn sealed<W: Write + Seek>(out: &mut W, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut opened = Opened { out, length: 0, digits: Digits::Unknown };
    let mut hashed = Hashed::of(&mut opened);
    content(&mut hashed)?;
    let hash = hashed.hash;
    let Opened { out, digits, .. } = opened;
    if let Digits::At(place) = digits {
        out.seek(SeekFrom::Start(place))?;
        out.write_all(hex(hash).as_bytes())?;
        out.seek(SeekFrom::End(0))?;
    }
    Ok(())
}

/// The position of the digits of the hash in the file.
#[derive(Clone, Copy)]
enum Digits {
    /// Unknown, since the first line has not ended.
    Unknown,
    At(u64),
    /// No position, since the first line is not a comment.
    Nowhere,
}

/// A writer that leaves space for the hash at the end of the first line.
struct Opened<'a, W> {
    out: &'a mut W,
    /// The number of bytes of the first line written so far.
    length: u64,
    digits: Digits,
}

impl<W: Write> Write for Opened<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let (Digits::Unknown, 0, Some(first)) = (self.digits, self.length, bytes.first())
            && *first != b'#'
        {
            self.digits = Digits::Nowhere;
        }
        let Digits::Unknown = self.digits else { return self.out.write(bytes) };
        let Some(end) = bytes.iter().position(|byte| *byte == b'\n') else {
            self.out.write_all(bytes)?;
            self.length += bytes.len() as u64;
            return Ok(bytes.len());
        };
        self.out.write_all(&bytes[..end])?;
        self.digits = Digits::At(self.length + (end + BEFORE.len()) as u64);
        write!(self.out, "{BEFORE}{:0>DIGITS$}", "")?;
        self.out.write_all(b"\n")?;
        Ok(end + 1)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// Whether the hash in the first line is the hash of the rest of the table; `None` where the comments contain no hash.
///
/// # Errors
/// The table cannot be read.
pub fn holds(mut table: impl BufRead) -> io::Result<Option<bool>> {
    let mut first = Vec::new();
    table.read_until(b'\n', &mut first)?;
    let seal =
        first.len().checked_sub(BEFORE.len() + DIGITS + 1).filter(|at| first[*at..].starts_with(BEFORE.as_bytes()));
    let Some(seal) = seal else { return in_other_comments(&first, table) };
    let mut hash = Hash::new();
    hash.update(&first[..seal]);
    hash.update(b"\n");
    loop {
        let read = table.fill_buf()?;
        if read.is_empty() {
            break;
        }
        hash.update(read);
        let length = read.len();
        table.consume(length);
    }
    let told = &first[seal + BEFORE.len()..first.len() - 1];
    Ok(Some(told == hex(hash).as_bytes()))
}

/// False where the hash stands elsewhere in the comments than at the end of the first line; `None` where there is no hash.
fn in_other_comments(first: &[u8], table: impl BufRead) -> io::Result<Option<bool>> {
    let is_seal = |line: &[u8]| line.windows(BEFORE.len()).any(|part| part == BEFORE.as_bytes());
    if is_seal(first) {
        return Ok(Some(false));
    }
    for line in table.split(b'\n') {
        let line = line?;
        if !line.starts_with(b"#") {
            break;
        }
        if is_seal(&line) {
            return Ok(Some(false));
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::{holds, sealed};
    use std::io::{Cursor, Write};

    fn of(parts: &[&str]) -> String {
        let mut text = Cursor::new(Vec::new());
        let content = |out: &mut dyn Write| parts.iter().try_for_each(|part| out.write_all(part.as_bytes()));
        sealed(&mut text, content).expect("memory can be written");
        String::from_utf8(text.into_inner()).expect("it is text")
    }

    fn told(text: &str) -> Option<bool> {
        holds(text.as_bytes()).expect("memory can be read")
    }

    #[test]
    fn the_first_comment_ends_with_the_hash_and_no_line_is_added() {
        for parts in [&["# made by: x\n# b\nx,y\n1,2\n"][..], &["# made", " by: x", "\n# b\nx,y\n", "1,2\n"]] {
            let text = of(parts);
            assert!(text.starts_with("# made by: x; sha256 of all else here: ") && text.ends_with("\n# b\nx,y\n1,2\n"));
            assert_eq!((text.lines().count(), told(&text)), (4, Some(true)));
        }
        assert_eq!(of(&["# only a comment"]), "# only a comment");
    }

    #[test]
    fn every_change_breaks_it() {
        let text = of(&["# made by: x\n# b\nx,y\n1,2\n"]);
        for changed in [
            text.replace("1,2", "1,3"),
            text.replace("# b\n", ""),
            text.replace("made", "Made"),
            format!("{text}3,4\n"),
            text.replace("1,2\n", ""),
            text.trim_end().to_owned(),
            format!("# mine\n{text}"),
            text.replacen('\n', " \n", 1),
            text.replace('\n', "\r\n"),
        ] {
            assert_eq!(told(&changed), Some(false), "{changed}");
        }
    }

    #[test]
    fn a_table_without_comments_has_no_seal() {
        for text in ["x,y\n1,2\n", "", "#", "# made by: x\nx,y\n1,2\n"] {
            assert_eq!(told(text), None, "{text}");
        }
        assert_eq!(of(&["x,y\n", "# 1,2\n"]), "x,y\n# 1,2\n");
    }
}
