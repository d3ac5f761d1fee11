//! A zip archive of files, uncompressed and without times, so that the same files are the same bytes.

use rawzip::{Error, ZipArchiveWriter};
use std::io::{self, Write};

/// A file of an archive.
pub struct Entry<'a> {
    /// Its path, folders by `/`.
    pub path: String,
    pub bytes: &'a [u8],
}

/// Writes an archive.
///
/// # Errors
/// The output fails.
pub fn write(out: impl Write, entries: &[Entry<'_>]) -> io::Result<()> {
    let written = || -> Result<(), Error> {
        let mut archive = ZipArchiveWriter::new(out);
        for entry in entries {
            let (mut file, config) = archive.new_file(entry.path.as_str()).start()?;
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
