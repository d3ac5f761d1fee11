//! Tables as CSV: comments with their origin, a line with the names and units of the columns, then rows with all digits of every number. A cell
//! without a value is empty. A trajectory may also be written as a NumPy archive.

use crate::exit::Exit;
use crate::output::{Form, Output, Provenance, Writes, Written};
use csv::{ByteRecord, Terminator, Writer, WriterBuilder};
use exchange::npz::{self, Array};
use std::io::{self, Write};
use std::path::Path;

/// The file for a trajectory, if one is requested.
pub struct Table {
    output: Option<Output>,
    heading: Vec<String>,
    provenance: Provenance,
}

impl Table {
    /// Checks the destination before the run. `columns` are names with units, without the time, which is added as the first column.
    ///
    /// # Errors
    /// The destination cannot be written, or contains a file of another origin.
    pub fn at(
        writes: &Writes<'_>,
        path: Option<&Path>,
        columns: &[String],
        provenance: Provenance,
    ) -> Result<Self, Exit> {
        let heading: Vec<String> = std::iter::once(headed("time", "s")).chain(columns.iter().cloned()).collect();
        let output = writes.optional(path, &[Form::Table(line(&heading)), Form::Archive])?;
        Ok(Table { output, heading, provenance })
    }

    /// The destination.
    pub fn output(&self) -> Option<&Output> {
        self.output.as_ref()
    }

    /// Writes the samples of a run, and its last state where the run ends after the last sample, for example at an event.
    ///
    /// # Errors
    /// The file system fails.
    pub fn write(self, times: &[f64], rows: &[Vec<f64>], end: (f64, &[f64])) -> Result<Option<Written>, Exit> {
        let Table { output, heading, provenance } = self;
        let samples = times.iter().copied().zip(rows.iter().map(Vec::as_slice));
        let after = Some(end).filter(|(time, _)| times.last().is_none_or(|last| last < time));
        let rows: Vec<(f64, &[f64])> = samples.chain(after).collect();
        let content = |out: &mut dyn Write| {
            out.write_all(provenance.comment("#").as_bytes())?;
            let mut table = table(out);
            table.write_record(&heading).map_err(of_system)?;
            let mut record = ByteRecord::new();
            for (time, row) in &rows {
                record.clear();
                std::iter::once(time).chain(*row).for_each(|value| record.push_field(cell(*value).as_bytes()));
                table.write_byte_record(&record).map_err(of_system)?;
            }
            table.flush()
        };
        let arrays = |out: &mut dyn Write| npz::write(out, &columns(&heading, &rows, &provenance));
        let written = |output: Output| match output.form() {
            Form::Archive => output.write(arrays),
            _ => output.write(content),
        };
        output.map(written).transpose()
    }
}

/// The arrays of an archive: the origin, the names with their units, then each column under its name.
fn columns(heading: &[String], rows: &[(f64, &[f64])], provenance: &Provenance) -> Vec<(String, Array)> {
    let split = |name: &String| {
        let (name, unit) = name.rsplit_once(" [").unwrap_or((name, ""));
        (name.to_owned(), unit.trim_end_matches(']').to_owned())
    };
    let (names, units): (Vec<String>, Vec<String>) = heading.iter().map(split).unzip();
    let column = |place: usize| {
        let value = |(time, row): &(f64, &[f64])| place.checked_sub(1).map_or(Some(*time), |own| row.get(own).copied());
        Array::Numbers(rows.iter().map(|row| value(row).unwrap_or(f64::NAN)).collect())
    };
    let values = names.iter().enumerate().map(|(place, name)| (name.clone(), column(place)));
    let told = [("provenance", provenance.lines().to_vec()), ("columns", names.clone()), ("units", units)];
    let told = told.map(|(name, texts)| (name.to_owned(), Array::Texts(texts)));
    told.into_iter().chain(values).collect()
}

/// The file for a transition matrix, the derivatives of the final state by the initial state, if one is requested.
pub struct Matrix {
    output: Option<Output>,
    columns: Vec<String>,
    provenance: Provenance,
}

impl Matrix {
    /// Checks the destination before the run. `columns` are the names of the states with units.
    ///
    /// # Errors
    /// The destination cannot be written, or contains a file of another origin.
    pub fn at(
        writes: &Writes<'_>,
        path: Option<&Path>,
        columns: &[String],
        provenance: Provenance,
    ) -> Result<Self, Exit> {
        let output = writes.optional(path, &[Form::Table(line(&heading(columns)))])?;
        Ok(Matrix { output, columns: columns.to_vec(), provenance })
    }

    /// The destination.
    pub fn output(&self) -> Option<&Output> {
        self.output.as_ref()
    }

    /// Writes the matrix with one row for each final state. The unit of an entry is the unit of its row divided by that of its column.
    ///
    /// # Errors
    /// The file system fails.
    pub fn write(self, rows: &[Vec<f64>]) -> Result<Option<Written>, Exit> {
        let Matrix { output, columns, provenance } = self;
        let content = |out: &mut dyn Write| {
            out.write_all(provenance.comment("#").as_bytes())?;
            let mut table = table(out);
            table.write_record(heading(&columns)).map_err(of_system)?;
            for (name, row) in columns.iter().zip(rows) {
                let cells = std::iter::once(name.clone()).chain(row.iter().copied().map(cell));
                table.write_record(cells).map_err(of_system)?;
            }
            table.flush()
        };
        output.map(|output| output.write(content)).transpose()
    }
}

fn heading(columns: &[String]) -> Vec<String> {
    std::iter::once("end by start".to_owned()).chain(columns.iter().cloned()).collect()
}

/// A number with all its digits; empty where it is not finite.
fn cell(value: f64) -> String {
    if value.is_finite() { value.to_string() } else { String::new() }
}

/// A column heading, the name with its unit in brackets.
pub fn headed(name: &str, unit: &str) -> String {
    format!("{name} [{unit}]")
}

/// A line of a CSV table without its line end.
pub fn line<C: AsRef<[u8]>>(cells: &[C]) -> String {
    let mut table = builder().buffer_capacity(1 << 9).from_writer(Vec::new());
    // writing to memory cannot fail
    let _ = table.write_record(cells);
    let bytes = table.into_inner().unwrap_or_default();
    String::from_utf8_lossy(&bytes).trim_end_matches('\n').to_owned()
}

/// The error of the file system within a CSV error, with its kind, such as a full disk or a closed pipe.
fn of_system(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        kind => io::Error::other(format!("{kind:?}")),
    }
}

fn table<W: io::Write>(out: W) -> Writer<W> {
    builder().from_writer(out)
}

fn builder() -> WriterBuilder {
    let mut builder = WriterBuilder::new();
    builder.terminator(Terminator::Any(b'\n'));
    builder
}

#[cfg(test)]
mod tests {
    use super::line;

    #[test]
    fn cells_with_commas_quotes_and_line_ends_come_back() {
        let cells = ["plain", "a, b", "he said \"no\"", "two\nlines", ""];
        let text = line(&cells) + "\n";
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
        let record = reader.records().next().expect("a row").expect("it can be read");
        assert_eq!(record.iter().collect::<Vec<_>>(), cells);
    }
}
