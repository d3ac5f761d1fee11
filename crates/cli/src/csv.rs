//! A trajectory as a table: names, then a row for each instant, every number with all its digits.

use crate::ending::Ending;
use crate::whole;
use std::io::{self, Write};
use std::path::Path;

/// Where a table goes, if one is asked for.
pub struct Table<'a>(Option<&'a Path>);

impl<'a> Table<'a> {
    /// Before the work, so that a wrong name does not cost it.
    pub fn at(path: Option<&'a Path>) -> Result<Self, Ending> {
        path.map_or(Ok(()), whole::check)?;
        Ok(Table(path))
    }

    /// Writes it; of a run that stopped, what there is.
    pub fn write(self, names: &[String], times: &[f64], rows: &[Vec<f64>]) -> Result<(), Ending> {
        self.0.map_or(Ok(()), |path| whole::write(path, |out| write(names, times, rows, out)))
    }

    /// Writes how each named quantity at the end depends on each at the start.
    pub fn write_matrix(self, names: &[String], rows: &[Vec<f64>]) -> Result<(), Ending> {
        let Some(path) = self.0 else { return Ok(()) };
        let line = |(name, row): (&String, &Vec<f64>)| {
            let values: Vec<String> = row.iter().map(f64::to_string).collect();
            format!("{name},{}\n", values.join(","))
        };
        let table: String = names.iter().zip(rows).map(line).collect();
        whole::write(path, |out| write!(out, "end by start,{}\n{table}", names.join(",")))
    }
}

fn write(names: &[String], times: &[f64], rows: &[Vec<f64>], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "time,{}", names.join(","))?;
    for (time, row) in times.iter().zip(rows) {
        write!(out, "{time}")?;
        for value in row {
            write!(out, ",{value}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// A cell, in quotation marks where it holds a comma.
pub fn quoted(cell: &str) -> String {
    if cell.contains(',') { format!("\"{cell}\"") } else { cell.to_owned() }
}
