//! Seals in a table to which rows are appended: each row ends with the hash of its other cells.
//!
//! The table of an ensemble is continued after a kill and joined from the tables of its parts; the result must equal, byte for byte, the table of
//! a single run. A hash of the whole table would change with each row; a hash of each row does not. Missing rows are recognised by the numbers of members.

use super::hex;
use hmac_sha256::Hash;
use std::io::{self, BufRead};

/// The name of the column of hashes.
pub const COLUMN: &str = "row_sha256";

/// The number of hexadecimal digits of a hash that are written. They suffice to detect changes by hand, not attacks.
const DIGITS: usize = 16;

/// A row with its hash as the last cell, without a line end.
pub fn sealed(row: &str) -> String {
    format!("{row},{}", digits(row.as_bytes()))
}

/// Whether a row, without its line end, ends with the hash of its other cells.
pub fn is_whole(row: &[u8]) -> bool {
    let comma = row.len().checked_sub(DIGITS + 1);
    comma.is_some_and(|at| row[at] == b',' && &row[at + 1..] == digits(&row[..at]).as_bytes())
}

/// Whether all lines below the heading are rows that end with their hashes.
///
/// # Errors
/// The table cannot be read.
pub fn holds(mut table: impl BufRead) -> io::Result<bool> {
    let mut line = Vec::new();
    table.read_until(b'\n', &mut line)?;
    loop {
        line.clear();
        table.read_until(b'\n', &mut line)?;
        match line.strip_suffix(b"\n") {
            Some(row) if is_whole(row) => {}
            Some(_) => return Ok(false),
            // an incomplete last line may come from a killed run or from an editor
            None => return Ok(line.is_empty()),
        }
    }
}

fn digits(cells: &[u8]) -> String {
    let mut hash = Hash::new();
    hash.update(cells);
    let mut digits = hex(hash);
    digits.truncate(DIGITS);
    digits
}

#[cfg(test)]
mod tests {
    use super::{COLUMN, holds, sealed};

    fn told(text: &str) -> bool {
        holds(text.as_bytes()).expect("memory can be read")
    }

    #[test]
    fn a_table_is_the_same_in_one_piece_and_joined() {
        let heading = format!("member,x,{COLUMN}\n");
        let rows = ["1,0.5", "2,\"a, b\""].map(|row| sealed(row) + "\n");
        let whole = format!("{heading}{}{}", rows[0], rows[1]);
        for table in [&heading, &format!("{heading}{}", rows[0]), &whole] {
            assert!(told(table), "{table}");
        }
    }

    #[test]
    fn every_change_of_a_row_breaks_it() {
        let text = format!("member,x,{COLUMN}\n{}\n{}\n", sealed("1,0.5"), sealed("2,0.25"));
        for changed in [
            text.replace("0.5", "0.6"),
            text.replace("0.25", "0.250"),
            text.replace('\n', "\r\n"),
            format!("{text}3,0.125\n"),
            format!("{text}\n"),
            format!("{text}note"),
            text.trim_end().to_owned(),
            text.replace(&sealed("1,0.5"), "1,0.5"),
        ] {
            assert!(!told(&changed), "{changed}");
        }
    }
}
