//! A trajectory as a table: names, then a row for each instant, every number with all its digits.

use derivations::scene::Trajectory;
use std::io::{self, Write};

/// Writes it; of a run that stopped, what there is.
pub fn write(trajectory: &Trajectory, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "time,{}", trajectory.names.join(","))?;
    for (time, row) in trajectory.times.iter().zip(&trajectory.rows) {
        write!(out, "{time}")?;
        for value in row {
            write!(out, ",{value}")?;
        }
        writeln!(out)?;
    }
    out.flush()
}
