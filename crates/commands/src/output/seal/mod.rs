//! Seals: hashes in output files, by which a command detects that a file was changed by hand.

pub mod each_row;
pub mod first_line;
pub mod last_line;

use hmac_sha256::Hash;
use std::io::{self, Write};

/// A SHA-256 hash as hexadecimal digits.
fn hex(hash: Hash) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A writer that passes its bytes on and hashes them.
struct Hashed<'a> {
    out: &'a mut dyn Write,
    hash: Hash,
    /// The last byte written.
    last: u8,
}

impl<'a> Hashed<'a> {
    fn of(out: &'a mut dyn Write) -> Self {
        Hashed { out, hash: Hash::new(), last: b'\n' }
    }
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
