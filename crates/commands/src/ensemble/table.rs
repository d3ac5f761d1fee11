//! The table of an ensemble on the disk: complete rows in the order of the members, so that a later run continues after the last row.
//!
//! Each row ends with a fingerprint and a hash. The fingerprint depends on everything that determines a member's result, including program and
//! processor; the hash reveals an edited row. Both are columns, since every reader accepts columns, and since columns remain with their rows
//! when tables are joined. When a table is continued, an incomplete last line is removed, and the last complete row is computed again and compared.

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

/// The number of buffered bytes at which rows are written.
const BLOCK: usize = 1 << 14;

/// The interval at which written rows are synced to the disk.
const CHUNK: Duration = Duration::from_millis(500);

/// The table of an ensemble on the disk, open for appending.
pub struct Table {
    path: PathBuf,
    file: File,
    fingerprint: String,
    /// The number of columns before the hashes of rows.
    columns: usize,
    /// Rows that are buffered and not written yet.
    waiting: String,
    /// The length of the file in bytes.
    length: u64,
    settled: Instant,
}

impl Table {
    /// Creates the table for a range of members, or opens an existing one to continue it. Returns the counts of the members in it.
    ///
    /// # Errors
    /// Another run writes to the table, it belongs to another ensemble (accepted with `force`), or the file system fails.
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
            // on systems without locks for files, the user must not start two runs at once
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

    /// Adds a row. A kill loses buffered rows; a power failure loses rows that are not synced.
    ///
    /// # Errors
    /// Those of [`Table::settle`].
    pub fn push(&mut self, row: &Row) -> Result<(), Exit> {
        self.waiting += &line(row, self.columns, &self.fingerprint);
        if self.settled.elapsed() >= CHUNK {
            return self.settle();
        }
        if self.waiting.len() >= BLOCK { self.write().map_err(|error| self.unwritable(&error)) } else { Ok(()) }
    }

    /// Writes buffered rows, syncs the file to the disk, and checks that the path still leads to this file.
    ///
    /// # Errors
    /// Another program has deleted, replaced or changed the file, or the file system fails.
    pub fn settle(&mut self) -> Result<(), Exit> {
        let settled = self.write().and_then(|()| self.file.sync_data());
        settled.map_err(|error| self.unwritable(&error))?;
        self.settled = Instant::now();
        let same = self.file.try_clone().and_then(Handle::from_file).and_then(|own| {
            // the path may meanwhile be a pipe, and opening a pipe would wait for a reader
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

    /// The error of a failed write. The complete rows remain in the file, so that the run can be continued.
    fn unwritable(&self, error: &io::Error) -> Exit {
        Exit::unwritable(&self.path, error)
    }
}

/// The number of bytes of the heading and of the complete rows, and the counts of the members in these rows. The rows must be those of the first members.
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
    // the row of a member as it is computed now; empty where the clock stopped the computation
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
    // an incomplete line is removed only if it is the beginning of the next row, as a killed run leaves it
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

/// The line of a row with its line end; cells without a value are empty.
fn line(row: &Row, columns: usize, fingerprint: &str) -> String {
    let number = |x: Option<f64>| x.filter(|x| x.is_finite()).map_or_else(String::new, |x| x.to_string());
    let mut cells = vec![row.number.to_string()];
    cells.extend(row.drawn.iter().map(f64::to_string));
    // a reason must not contain a line end
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
