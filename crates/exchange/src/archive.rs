//! Zip archives, uncompressed and with one time for all files, so that equal files give equal bytes.

use rawzip::time::UtcDateTime;
use rawzip::{Error, ZipArchiveWriter};
use std::io::{self, Write};

/// A file of an archive.
pub struct Entry<'a> {
    /// The path in the archive, with `/` between folders.
    pub path: String,
    pub bytes: &'a [u8],
}

/// The earliest time in a zip archive, the beginning of 1980, in Unix seconds.
const FIRST: i64 = 315_532_800;

/// Writes an archive.
///
/// # Errors
/// The output fails.
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

#[cfg(test)]
mod tests {
    use super::*;
    use rawzip::ZipArchive;
    use std::io::Read;

    #[test]
    fn files_come_back_and_the_same_files_are_the_same_bytes() {
        let files = [("a.txt", &b"one"[..]), ("folder/b.bin", &[0, 255, 13, 10][..]), ("empty", &b""[..])];
        let entries = || files.map(|(path, bytes)| Entry { path: path.to_owned(), bytes });
        let mut archive = Vec::new();
        write(&mut archive, &entries()).expect("memory takes it");
        let read = ZipArchive::from_slice(&archive).expect("it is one");
        let mut found = Vec::new();
        let mut listed = read.entries();
        while let Some(entry) = listed.next_entry().expect("an entry") {
            let path = entry.file_path().try_normalize().expect("a plain path").as_ref().to_owned();
            let stored = read.get_entry(entry.wayfinder()).expect("its data");
            let mut bytes = Vec::new();
            stored.verifying_reader(stored.data()).read_to_end(&mut bytes).expect("its sum is right");
            found.push((path, bytes));
        }
        let wanted = files.map(|(path, bytes)| (path.to_owned(), bytes.to_vec()));
        assert_eq!(found, wanted);
        let mut again = Vec::new();
        write(&mut again, &entries()).expect("memory takes it");
        assert!(archive == again);
    }
}
