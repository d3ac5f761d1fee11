//! NumPy's archives: named arrays in one file, which `numpy.load` opens.

use crate::archive::{self, Entry};
use std::io::{self, Write};

/// An array.
#[derive(Clone, Debug)]
pub enum Array {
    /// Numbers in a row.
    Numbers(Vec<f64>),
    /// Numbers in rows of one length.
    Rows(Vec<Vec<f64>>),
    Texts(Vec<String>),
}

/// Writes arrays under their names; the first of two with one name keeps it, and a later one gets a mark behind it.
///
/// # Errors
/// The output fails.
pub fn write(out: impl Write, arrays: &[(String, Array)]) -> io::Result<()> {
    let mut names: Vec<String> = Vec::new();
    for (name, _) in arrays {
        // a slash would be a folder
        let mut name = name.replace(['/', '\\'], " per ");
        while names.contains(&name) {
            name.push('_');
        }
        names.push(name);
    }
    let bytes: Vec<Vec<u8>> = arrays.iter().map(|(_, array)| array.bytes()).collect();
    let entries = names.iter().zip(&bytes).map(|(name, bytes)| Entry { path: format!("{name}.npy"), bytes });
    archive::write(out, &entries.collect::<Vec<_>>())
}

impl Array {
    /// A file of the format `.npy`, version 1.0.
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
        // the data begin at a multiple of 64 bytes
        let length = (10 + header.len() + 1).next_multiple_of(64) - 10;
        let header = format!("{header:width$}\n", width = length - 1);
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend(u16::try_from(header.len()).unwrap_or(u16::MAX).to_le_bytes());
        bytes.extend(header.as_bytes());
        bytes.extend(data);
        bytes
    }
}
