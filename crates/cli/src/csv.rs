//! A trajectory as a table: names, then a row for each instant, every number with all its digits.

use crate::ending::Ending;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Where a table goes, if one is asked for.
pub struct Table<'a>(Option<(&'a Path, File)>);

impl<'a> Table<'a> {
    /// Before the work, so that a wrong name does not cost it.
    pub fn open(path: Option<&'a Path>) -> Result<Self, Ending> {
        let open = |path| Ok((path, File::create(path).map_err(|error| Ending::unwritable(path, &error))?));
        path.map(open).transpose().map(Table)
    }

    /// Writes it; of a run that stopped, what there is.
    pub fn write(self, names: &[String], times: &[f64], rows: &[Vec<f64>]) -> Result<(), Ending> {
        let Some((path, file)) = self.0 else { return Ok(()) };
        write(names, times, rows, &mut BufWriter::new(file)).map_err(|error| Ending::unwritable(path, &error))
    }

    /// Writes how each named quantity at the end depends on each at the start.
    pub fn write_matrix(self, names: &[String], rows: &[Vec<f64>]) -> Result<(), Ending> {
        let Some((path, file)) = self.0 else { return Ok(()) };
        let line = |(name, row): (&String, &Vec<f64>)| {
            let values: Vec<String> = row.iter().map(f64::to_string).collect();
            format!("{name},{}\n", values.join(","))
        };
        let table: String = names.iter().zip(rows).map(line).collect();
        write!(&file, "end by start,{}\n{table}", names.join(",")).map_err(|error| Ending::unwritable(path, &error))
    }
}

fn write(names: &[String], times: &[f64], rows: &[Vec<f64>], out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "time,{}", names.join(","))?;
    for (time, row) in times.iter().zip(rows) {
        write!(out, "{time}")?;
        for value in row {
            write!(out, ",{value}")?;
        }
        writeln!(out)?;
    }
    out.flush()
}

/// A cell, in quotation marks where it holds a comma.
pub fn quoted(cell: &str) -> String {
    if cell.contains(',') { format!("\"{cell}\"") } else { cell.to_owned() }
}
