//! Uncompressed zip archives with one constant time for all files, so that equal files give equal bytes. An archive may contain a seal, a file with
//! the hash of all others.

use hmac_sha256::Hash;
use rawzip::time::UtcDateTime;
use rawzip::{Error, ZipArchive, ZipArchiveWriter};
use std::io::{self, Read, Write};

/// A file in an archive.
pub struct Entry<'a> {
    /// The path in the archive, with `/` between folders.
    pub path: String,
    pub bytes: &'a [u8],
}

/// The earliest time that a zip archive can contain, 1 January 1980, in Unix seconds.
const FIRST: i64 = 315_532_800;

/// The first bytes of an archive with files; [`END`] are the first bytes of its last record, and the length of this record without a comment.
const BEGIN: &[u8] = b"PK\x03\x04";
const END: (&[u8], usize) = (b"PK\x05\x06", 22);

/// Writes an archive of files.
///
/// # Errors
/// Writing to `out` fails.
pub fn write(out: impl Write, entries: &[Entry<'_>]) -> io::Result<()> {
    let written = || -> Result<(), Error> {
        let mut archive = ZipArchiveWriter::new(out);
        for entry in entries {
            let (mut file, config) =
                archive.new_file(entry.path.as_str()).last_modified(UtcDateTime::from_unix(FIRST)).start()?;
            let mut data = config.wrap(&mut file);
            data.write_all(entry.bytes)?;
            let (_, descriptor) = data.finish()?;
            file.finish(descriptor)?;
        }
        archive.finish()?;
        Ok(())
    };
    written().map_err(io::Error::other)
}

/// The last file of an archive, which contains the hash of all others.
#[derive(Clone, Copy, Debug)]
pub struct Seal {
    pub path: &'static str,
    /// The content of the file for the line with the hash.
    pub file: fn(String) -> Vec<u8>,
}

impl Seal {
    fn of<'a>(&self, files: impl Iterator<Item = (&'a str, &'a [u8])>) -> Vec<u8> {
        (self.file)(sealing(files))
    }

    /// Whether an archive contains exactly the files for which its seal was written; `None` where it has no seal.
    pub fn holds(&self, archive: &[u8]) -> Option<bool> {
        // an archive that cannot be read, or with bytes after its end, was changed
        let Ok(mut files) = files(archive) else { return Some(false) };
        let ends = archive.len().checked_sub(END.1).is_some_and(|at| archive[at..].starts_with(END.0));
        if !(ends && archive.starts_with(BEGIN)) {
            return Some(false);
        }
        if !files.iter().any(|(path, _)| path == self.path) {
            return None;
        }
        let (path, bytes) = files.pop()?;
        let others = files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice()));
        Some(path == self.path && bytes == self.of(others))
    }
}

/// Writes an archive of files with a seal.
///
/// # Errors
/// Writing to `out` fails.
pub fn write_sealed(out: impl Write, entries: &[Entry<'_>], seal: Seal) -> io::Result<()> {
    let bytes = seal.of(entries.iter().map(|entry| (entry.path.as_str(), entry.bytes)));
    let own = entries.iter().map(|entry| Entry { path: entry.path.clone(), bytes: entry.bytes });
    let last = Entry { path: seal.path.to_owned(), bytes: &bytes };
    write(out, &own.chain([last]).collect::<Vec<_>>())
}

/// The line with the hash of all paths and contents, each preceded by its length.
fn sealing<'a>(files: impl Iterator<Item = (&'a str, &'a [u8])>) -> String {
    let mut hash = Hash::new();
    for part in files.flat_map(|(path, bytes)| [path.as_bytes(), bytes]) {
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    let digits: String = hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    format!("sha256 of the other files: {digits}\n")
}

/// The files of an archive, in their order.
fn files(archive: &[u8]) -> Result<Vec<(String, Vec<u8>)>, Error> {
    let read = ZipArchive::from_slice(archive)?;
    let mut found = Vec::new();
    let mut listed = read.entries();
    while let Some(entry) = listed.next_entry()? {
        let path = entry.file_path().try_normalize()?.as_ref().to_owned();
        let stored = read.get_entry(entry.wayfinder())?;
        let mut bytes = Vec::new();
        stored.verifying_reader(stored.data()).read_to_end(&mut bytes)?;
        found.push((path, bytes));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_come_back_and_the_same_files_are_the_same_bytes() {
        let files = [("a.txt", &b"one"[..]), ("folder/b.bin", &[0, 255, 13, 10][..]), ("empty", &b""[..])];
        let entries = || files.map(|(path, bytes)| Entry { path: path.to_owned(), bytes });
        let mut archive = Vec::new();
        write(&mut archive, &entries()).expect("memory takes it");
        let found = super::files(&archive).expect("they can be read");
        let wanted = files.map(|(path, bytes)| (path.to_owned(), bytes.to_vec()));
        assert_eq!(found, wanted);
        let mut again = Vec::new();
        write(&mut again, &entries()).expect("memory takes it");
        assert!(archive == again);
    }

    #[test]
    fn a_seal_breaks_where_a_file_is_changed_added_or_lost() {
        let seal = Seal { path: "seal.txt", file: String::into_bytes };
        let archive = |files: &[(&str, &str)]| {
            let entries = files.iter().map(|(path, text)| Entry { path: (*path).to_owned(), bytes: text.as_bytes() });
            let mut archive = Vec::new();
            write_sealed(&mut archive, &entries.collect::<Vec<_>>(), seal).expect("memory takes it");
            archive
        };
        let whole = archive(&[("a", "one"), ("b", "two")]);
        assert_eq!(seal.holds(&whole), Some(true));
        assert_eq!(Seal { path: "other.txt", ..seal }.holds(&whole), None);
        let text = super::files(&whole).expect("it can be read").pop().expect("it has a seal").1;
        for files in [&[("a", "one"), ("b", "twO")][..], &[("a", "one")], &[("a", "onet"), ("b", "wo")]] {
            let mut entries: Vec<Entry> =
                files.iter().map(|(path, text)| Entry { path: (*path).to_owned(), bytes: text.as_bytes() }).collect();
            entries.push(Entry { path: "seal.txt".into(), bytes: &text });
            let mut changed = Vec::new();
            write(&mut changed, &entries).expect("memory takes it");
            assert_eq!(seal.holds(&changed), Some(false), "{files:?}");
        }
        let (longer, before) = ([&whole[..], b"\n"].concat(), [b"\n", &whole[..]].concat());
        for changed in [&b""[..], &whole[..whole.len() - 1], &longer, &before] {
            assert_eq!(seal.holds(changed), Some(false));
        }
    }
}
