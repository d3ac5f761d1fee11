//! Reads the table of an ensemble row by row. A file with a row of another ensemble is refused.

use crate::csv;
use crate::output::each_row;
use ::csv::{ReaderBuilder, StringRecord};
use simulation::ensemble::{EnsembleScene, Fingerprint};
use std::io::{self, BufRead, Read};

/// The largest accepted length of a row in bytes.
const LONGEST: u64 = 1 << 24;

/// The number of the line at which a file turns out not to be a table of the ensemble, and the reason.
pub type Foreign = (usize, String);

/// The programs and processors whose rows are accepted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Makers {
    /// This version of the program, on a processor that rounds like this one.
    This,
    Any,
}

/// A row: the number of its member, and whether the member reached the end of its run.
pub struct RowOfMember {
    /// The number of the member, from 1.
    pub member: u64,
    /// The reason for which the member stopped; `None` if it reached the end.
    pub stopped: Option<String>,
}

/// The first line of the table, with its line end.
pub fn heading(scene: &EnsembleScene) -> String {
    format!("{},{}\n", csv::line(&scene.headings()), each_row::COLUMN)
}

/// A reader of a table; it stores one line at a time.
pub struct Rows<'a, R> {
    table: R,
    scene: &'a EnsembleScene,
    fingerprint: Fingerprint,
    makers: Makers,
    heading: String,
    /// The number of columns before the hashes of rows.
    columns: usize,
    /// The last row with its line end.
    text: Vec<u8>,
    /// The number of the line of the last row, from 1.
    line: usize,
    /// The number of the member of the last row; 0 before the first row.
    before: u64,
}

impl<'a, R: BufRead> Rows<'a, R> {
    /// Opens a table. `None` where its first line is incomplete, because a run was killed before its first row.
    ///
    /// # Errors
    /// The table cannot be read, or its first line does not contain the columns of this ensemble.
    pub fn of(mut table: R, scene: &'a EnsembleScene, makers: Makers) -> Result<Option<Self>, Foreign> {
        let heading = heading(scene);
        let unreadable = |error: io::Error| (1, error.to_string());
        let mut head = Vec::new();
        table.by_ref().take(heading.len() as u64).read_to_end(&mut head).map_err(unreadable)?;
        if head.len() < heading.len() && heading.as_bytes().starts_with(&head) {
            return Ok(None);
        }
        if head != heading.as_bytes() {
            return Err((1, "these are not the columns of this ensemble's table".to_owned()));
        }
        let (fingerprint, columns) = (Fingerprint::of(scene), scene.headings().len());
        Ok(Some(Rows { table, scene, fingerprint, makers, heading, columns, text: Vec::new(), line: 1, before: 0 }))
    }

    pub fn heading(&self) -> &str {
        &self.heading
    }

    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The bytes of the last row, as in the file.
    pub fn text(&self) -> &[u8] {
        &self.text
    }

    /// The line number of the last row.
    pub fn line(&self) -> usize {
        self.line
    }

    /// The next complete row; `None` at the end of the file or at an incomplete last line.
    ///
    /// # Errors
    /// The line and the reason, where the row does not belong to this ensemble.
    pub fn next_row(&mut self) -> Result<Option<RowOfMember>, Foreign> {
        self.line += 1;
        let line = self.line;
        let foreign = |why: String| (line, why);
        self.text.clear();
        let length = self.table.by_ref().take(LONGEST).read_until(b'\n', &mut self.text);
        let length = length.map_err(|error| foreign(error.to_string()))?;
        if !self.text.ends_with(b"\n") && (length as u64) < LONGEST {
            return Ok(None);
        }
        let cells = cells(&self.text).filter(|cells| cells.len() == self.columns + 1);
        let no_row = || foreign("this is no row of the table".to_owned());
        let cells = cells.ok_or_else(no_row)?;
        let fingerprint = &cells[self.columns - 1];
        let is_accepted = self.makers == Makers::Any && self.fingerprint.is_of_same_members(fingerprint);
        if let Some(why) = self.fingerprint.differs_from(fingerprint).filter(|_| !is_accepted) {
            return Err(foreign(why));
        }
        if !self.text.strip_suffix(b"\n").is_some_and(each_row::is_whole) {
            return Err(foreign(
                "this row was edited since it was written: its hash is not that of its cells".to_owned(),
            ));
        }
        let member: u64 = cells[0].parse().map_err(|_| no_row())?;
        if member <= self.before {
            return Err(foreign(format!("member {member} follows member {}", self.before)));
        }
        if member > self.scene.members {
            return Err(foreign(format!("there are more than the {} members", self.scene.members)));
        }
        let drawn = self.scene.drawn(member);
        if !drawn.iter().map(f64::to_string).zip(cells.iter().skip(1)).all(|(own, found)| own == found) {
            return Err(foreign(format!("member {member} has other data here")));
        }
        self.before = member;
        let stopped = Some(&cells[1 + drawn.len()]).filter(|why| !why.is_empty()).map(str::to_owned);
        Ok(Some(RowOfMember { member, stopped }))
    }
}

/// The cells of a line; `None` where the line is not exactly one row.
fn cells(line: &[u8]) -> Option<StringRecord> {
    let mut reader = ReaderBuilder::new().has_headers(false).buffer_capacity(1 << 10).from_reader(line);
    let mut records = reader.records();
    let record = records.next()?.ok()?;
    records.next().is_none().then_some(record)
}
