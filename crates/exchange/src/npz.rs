//! NumPy archives: named arrays in one file, which `numpy.load` opens.

use crate::archive::{self, Entry, Seal};
use std::io::{self, Write};

/// An array.
#[derive(Clone, Debug)]
pub enum Array {
    /// A one-dimensional array of doubles.
    Numbers(Vec<f64>),
    /// A two-dimensional array of doubles; all rows have one length.
    Rows(Vec<Vec<f64>>),
    Texts(Vec<String>),
}

/// The seal: the last array of the archive, a text with the hash of all others.
const SEAL: Seal = Seal { path: "sha256.npy", file: |said| Array::Texts(vec![said.trim_end().to_owned()]).bytes() };

/// Whether an archive contains the arrays for which its seal was written; `None` where it has no seal.
pub fn seal_holds(archive: &[u8]) -> Option<bool> {
    SEAL.holds(archive)
}

/// Writes arrays under their names, and the hash of all arrays under the name `sha256`. Of two arrays with equal names the second gets a suffix.
///
/// # Errors
/// Writing to `out` fails.
pub fn write(out: impl Write, arrays: &[(String, Array)]) -> io::Result<()> {
    let mut names = vec!["sha256".to_owned()];
    for (name, _) in arrays {
        // a slash in the name would denote a folder
        let mut name = name.replace(['/', '\\'], " per ");
        while names.contains(&name) {
            name.push('_');
        }
        names.push(name);
    }
    let bytes: Vec<Vec<u8>> = arrays.iter().map(|(_, array)| array.bytes()).collect();
    let entries = names.iter().skip(1).zip(&bytes).map(|(name, bytes)| Entry { path: format!("{name}.npy"), bytes });
    archive::write_sealed(out, &entries.collect::<Vec<_>>(), SEAL)
}

impl Array {
    /// The array as a file in the format `.npy`, version 1.0.
    fn bytes(&self) -> Vec<u8> {
        let numbers =
            |values: &mut dyn Iterator<Item = &f64>| values.flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
        let (kind, shape, data) = match self {
            Array::Numbers(values) => ("<f8".to_owned(), format!("({},)", values.len()), numbers(&mut values.iter())),
            Array::Rows(rows) => {
                let columns = rows.first().map_or(0, Vec::len);
                ("<f8".to_owned(), format!("({}, {columns})", rows.len()), numbers(&mut rows.iter().flatten()))
            }
            Array::Texts(texts) => {
                let width = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
                let padded = |text: &String| {
                    text.chars().map(u32::from).chain(std::iter::repeat(0)).take(width).collect::<Vec<_>>()
                };
                let data = texts.iter().flat_map(padded).flat_map(u32::to_le_bytes).collect();
                (format!("<U{width}"), format!("({},)", texts.len()), data)
            }
        };
        let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
        // the format requires data at a multiple of 64 bytes
        let length = (10 + header.len() + 1).next_multiple_of(64) - 10;
        let header = format!("{header:width$}\n", width = length - 1);
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend(u16::try_from(header.len()).unwrap_or(u16::MAX).to_le_bytes());
        bytes.extend(header.as_bytes());
        bytes.extend(data);
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_array_has_its_header_and_its_data_behind_a_multiple_of_64_bytes() {
        for array in [
            Array::Numbers(vec![1.5, -2.0, f64::NAN]),
            Array::Rows(vec![vec![1.0, 2.0], vec![3.0, 4.0]]),
            Array::Texts(vec!["theta'".to_owned(), "\u{3b8}".to_owned()]),
            Array::Texts(Vec::new()),
        ] {
            let bytes = array.bytes();
            assert!(bytes.starts_with(b"\x93NUMPY\x01\x00"));
            let length = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
            assert_eq!((length % 64, bytes[length - 1]), (0, b'\n'));
            let data = &bytes[length..];
            match &array {
                Array::Numbers(values) => {
                    let found =
                        data.chunks_exact(8).map(|part| f64::from_le_bytes(part.try_into().expect("eight bytes")));
                    assert!(found.zip(values).all(|(found, value)| found.to_bits() == value.to_bits()));
                }
                Array::Rows(rows) => assert_eq!(data.len(), 8 * rows.len() * 2),
                Array::Texts(texts) => assert_eq!(data.len(), 4 * 6 * texts.len()),
            }
        }
    }

    #[test]
    fn of_two_arrays_with_one_name_the_later_is_marked() {
        let mut archive = Vec::new();
        let arrays = ["x", "x", "m/s"].map(|name| (name.to_owned(), Array::Numbers(vec![0.0])));
        write(&mut archive, &arrays).expect("memory takes it");
        let text = String::from_utf8_lossy(&archive);
        assert!(["x.npy", "x_.npy", "m per s.npy"].iter().all(|name| text.contains(name)));
    }

    #[test]
    fn an_archive_is_sealed_and_a_column_may_have_the_name_of_the_seal() {
        let mut archive = Vec::new();
        write(&mut archive, &[("sha256".to_owned(), Array::Numbers(vec![0.5]))]).expect("memory takes it");
        assert_eq!(seal_holds(&archive), Some(true));
        assert!(String::from_utf8_lossy(&archive).contains("sha256_.npy"));
        let place = archive.windows(8).position(|part| part == 0.5_f64.to_le_bytes()).expect("it is there");
        archive[place] ^= 1;
        assert_eq!(seal_holds(&archive), Some(false));
    }
}
