//! The table of an ensemble on the disk: complete rows in the order of the members, so that a run continues after the last one.
//!
//! Each row ends with the fingerprint of all that decides a member's result, and of the program and processor, then with its hash, by which
//! a row that was edited is refused. Columns work with every reader and stay with their rows when tables are joined, unlike a comment or
//! a second file. An incomplete last line is removed, and the last complete row is computed again: it must be reproduced.

use super::fates::Fates;
use super::rows::{Foreign, Makers, Rows, heading};
use crate::atomic_write;
use crate::csv;
use crate::exit::Exit;
use crate::output::{Writes, each_row};
use same_file::Handle;
use simulation::ensemble::{EnsembleScene, Fingerprint, Row};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Write};
use std::ops::{ControlFlow, RangeInclusive};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The number of waiting bytes at which rows are written.
const BLOCK: usize = 1 << 14;

/// The interval at which written rows are synced to the disk.
const CHUNK: Duration = Duration::from_millis(500);

/// The table on the disk.
pub struct Table {
    path: PathBuf,
    file: File,
    fingerprint: String,
    /// The number of columns before the hashes of rows.
    columns: usize,
    /// Rows that are not written yet.
    waiting: String,
    /// The length of the file, in bytes.
    length: u64,
    settled: Instant,
}

impl Table {
    /// Makes the table of some members, or continues an existing one.
    pub fn open(
        writes: &Writes<'_>,
        path: &Path,
        (scene, members): (&EnsembleScene, &RangeInclusive<u64>),
    ) -> Result<(Self, Fates), Exit> {
        let unwritable = |error: io::Error| Exit::unwritable(path, &error);
        let place = writes.continued(path)?;
        std::fs::create_dir_all(atomic_write::folder(&place)).map_err(unwritable)?;
        let file = OpenOptions::new().read(true).append(true).create(true).open(&place).map_err(unwritable)?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => {
                let reason = "another run writes to it; wait for its end, or name another file";
                return Err(Exit::refused(format!("{}: {reason}", path.display())));
            }
            // where files cannot be locked, the user must avoid two runs at once
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let fingerprint = Fingerprint::of(scene);
        let (whole, told) = match read(BufReader::new(&file), scene, &fingerprint, members) {
            Ok(found) => found,
            Err(_) if writes.force => (0, Fates::default()),
            Err((line, why)) => {
                let accepted =
                    "only a table of this ensemble is continued; name another file, or begin anew with --force";
                return Err(Exit::refused(format!("{}, line {line}: {why}; {accepted}", path.display())));
            }
        };
        file.set_len(whole).map_err(unwritable)?;
        let mut table = Table {
            path: path.to_owned(),
            file,
            fingerprint: fingerprint.to_string(),
            columns: scene.headings().len(),
            waiting: String::new(),
            length: whole,
            settled: Instant::now(),
        };
        if whole == 0 {
            table.waiting = heading(scene);
            table.settle()?;
        }
        Ok((table, told))
    }

    /// Adds a row. A kill loses rows that are not written yet, a power failure those that are not synced.
    pub fn push(&mut self, row: &Row) -> Result<(), Exit> {
        self.waiting += &line(row, self.columns, &self.fingerprint);
        if self.settled.elapsed() >= CHUNK {
            return self.settle();
        }
        if self.waiting.len() >= BLOCK { self.write().map_err(|error| self.unwritable(&error)) } else { Ok(()) }
    }

    /// Writes the waiting rows, syncs all to the disk, and checks that the file is still the same.
    pub fn settle(&mut self) -> Result<(), Exit> {
        let settled = self.write().and_then(|()| self.file.sync_data());
        settled.map_err(|error| self.unwritable(&error))?;
        self.settled = Instant::now();
        let same = self.file.try_clone().and_then(Handle::from_file).and_then(|own| {
            // opening a pipe in the place of the file would wait for a reader
            Ok(self.path.is_file()
                && Handle::from_path(&self.path)? == own
                && self.file.metadata()?.len() == self.length)
        });
        match same {
            Ok(true) => Ok(()),
            _ => Err(Exit::refused(format!(
                "{} was deleted, replaced or changed by another program while it was written, and its rows are lost; the same \
                 command begins anew",
                self.path.display()
            ))),
        }
    }

    fn write(&mut self) -> io::Result<()> {
        self.file.write_all(self.waiting.as_bytes())?;
        self.length += self.waiting.len() as u64;
        self.waiting.clear();
        Ok(())
    }

    /// The error of a failed write; complete rows are kept, so that the run can be continued.
    fn unwritable(&self, error: &io::Error) -> Exit {
        Exit::unwritable(&self.path, error)
    }
}

/// The number of bytes of a file's complete rows, which belong to the members from the first one on, and their counts.
fn read(
    table: impl BufRead,
    scene: &EnsembleScene,
    fingerprint: &Fingerprint,
    members: &RangeInclusive<u64>,
) -> Result<(u64, Fates), Foreign> {
    let mut told = Fates::default();
    let Some(mut rows) = Rows::of(table, scene, Makers::This)? else { return Ok((0, told)) };
    let mut whole = rows.heading().len() as u64;
    let (mut last, mut next) = (Vec::new(), *members.start());
    while let Some(row) = rows.next_row()? {
        let foreign = |why: String| Err((rows.line(), why));
        if row.member > *members.end() {
            return foreign(match *members.end() == scene.members {
                true => format!("there are more than the {} members", scene.members),
                false => format!("member {} belongs to another part", row.member),
            });
        }
        if row.member != next {
            return foreign(format!("member {} stands in the place of member {next}", row.member));
        }
        next += 1;
        told.add(row.member, row.stopped.as_deref());
        whole += rows.text().len() as u64;
        last.clear();
        last.extend_from_slice(rows.text());
    }
    // the row of a member; empty where the clock stopped it
    let computed = |member: u64| {
        let mut text = String::new();
        scene.run(member..=member, 1, |row| {
            text = line(&row, rows.columns(), &fingerprint.to_string());
            ControlFlow::Continue(())
        });
        text
    };
    if told.members > 0 {
        let again = computed(next - 1);
        if !again.is_empty() && again.as_bytes() != last {
            return Err((rows.line() - 1, format!("member {} gives another row when it is computed again", next - 1)));
        }
    }
    // an incomplete line is removed only where a killed run left it
    if !rows.text().is_empty() {
        let begun = (next <= *members.end()).then(|| computed(next));
        let why = match begun {
            Some(begun) if begun.is_empty() => {
                Some("there was no time to compute the row that this incomplete line may begin")
            }
            Some(begun) if begun.as_bytes().starts_with(rows.text()) => None,
            _ => Some("this incomplete line is not the beginning of the next row"),
        };
        if let Some(why) = why {
            return Err((rows.line(), why.to_owned()));
        }
    }
    Ok((whole, told))
}

/// The line of a row, with its end of line; cells without a value are empty.
fn line(row: &Row, columns: usize, fingerprint: &str) -> String {
    let number = |x: Option<f64>| x.filter(|x| x.is_finite()).map_or_else(String::new, |x| x.to_string());
    let mut cells = vec![row.number.to_string()];
    cells.extend(row.drawn.iter().map(f64::to_string));
    // a reason must not break the line
    cells.push(row.stopped.as_deref().map_or_else(String::new, |why| why.replace(['\n', '\r'], " ")));
    cells.push(number(row.last.as_ref().map(|last| last.time)));
    cells.push(row.steps.to_string());
    if let Some(last) = &row.last {
        cells.extend(last.state.iter().map(f64::to_string));
        cells.extend(last.derived.iter().copied().map(number));
    }
    cells.resize(columns - 1, String::new());
    cells.push(fingerprint.to_owned());
    each_row::sealed(&csv::line(&cells)) + "\n"
}
