//! Joins the tables of the parts of an ensemble: lists missing members, and writes one table, byte for byte as a single run would write it.

use super::fates::Fates;
use super::rows::{Makers, RowOfMember, Rows, heading};
use crate::clock;
use crate::exit::{Exit, print};
use crate::output::{Form, Writes};
use simulation::ensemble::EnsembleScene;
use std::fs::File;
use std::io::{self, BufReader};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

/// The number of members between two checks of the clock.
const BETWEEN: u64 = 1 << 12;

/// The table of a part, with its current row.
struct Part<'a> {
    path: &'a Path,
    rows: Rows<'a, BufReader<File>>,
    row: Option<RowOfMember>,
}

impl Part<'_> {
    fn step(&mut self) -> Result<(), Exit> {
        self.row = self.rows.next_row().map_err(|(line, why)| foreign(self.path, line, &why))?;
        Ok(())
    }
}

fn foreign(path: &Path, line: usize, why: &str) -> Exit {
    Exit::refused(format!("{}, line {line}: {why}; tables of the parts of this ensemble are accepted", path.display()))
}

/// Visits all members once. `take` receives the row of a member, or a range of members that occur in no part.
fn joined(
    scene: &EnsembleScene,
    paths: &[PathBuf],
    makers: Makers,
    mut take: impl FnMut(Joined<'_>) -> Result<(), Exit>,
) -> Result<(), Exit> {
    let mut parts = Vec::new();
    for path in paths {
        let file = File::open(path).map_err(|error| Exit::refused(format!("{}: {error}", path.display())))?;
        let rows = Rows::of(BufReader::new(file), scene, makers).map_err(|(line, why)| foreign(path, line, &why))?;
        let Some(rows) = rows else { continue };
        let mut part = Part { path, rows, row: None };
        part.step()?;
        parts.push(part);
    }
    let mut next = 1;
    while next <= scene.members {
        if next % BETWEEN == 0 && clock::goes_on().is_break() {
            return Err(Exit::Stopped);
        }
        let first = parts.iter().filter_map(|part| part.row.as_ref()).map(|row| row.member).min();
        let until = first.unwrap_or(scene.members + 1);
        if until > next {
            take(Joined::Missing(next..=until - 1))?;
            next = until;
            continue;
        }
        let here = |part: &Part<'_>| part.row.as_ref().is_some_and(|row| row.member == next);
        let own: Vec<usize> = (0..parts.len()).filter(|&k| here(&parts[k])).collect();
        if let Some(&other) = own.iter().skip(1).find(|&&k| parts[k].rows.text() != parts[own[0]].rows.text()) {
            let (line, first) = (parts[other].rows.line(), parts[own[0]].path.display());
            return Err(foreign(parts[other].path, line, &format!("the row of member {next} is not that of {first}")));
        }
        let (part, row) = (&parts[own[0]], parts[own[0]].row.as_ref());
        take(Joined::Row(part.rows.text(), next, row.and_then(|row| row.stopped.as_deref())))?;
        own.into_iter().try_for_each(|k| parts[k].step())?;
        next += 1;
    }
    Ok(())
}

enum Joined<'a> {
    Row(&'a [u8], u64, Option<&'a str>),
    Missing(RangeInclusive<u64>),
}

/// Prints the members that occur in no part, one range per line.
pub fn missing(scene: &EnsembleScene, paths: &[PathBuf], makers: Makers) -> Result<Exit, Exit> {
    let mut any = false;
    joined(scene, paths, makers, |joined| match joined {
        Joined::Row(..) => Ok(()),
        Joined::Missing(members) => {
            any = true;
            print(&format!("{}\n", told(&members)))
        }
    })?;
    Ok(if any { Exit::Stopped } else { Exit::Done })
}

/// Writes one table with all members, and prints the counts of their outcomes.
///
/// # Errors
/// A member is in no table, two tables disagree on a member, a table belongs to another ensemble, or the destination cannot be written.
pub fn merge(
    scene: &EnsembleScene,
    paths: &[PathBuf],
    makers: Makers,
    (writes, out): (&Writes<'_>, &Path),
) -> Result<Exit, Exit> {
    let heading = heading(scene);
    let output = writes.output(out, &[Form::Rows(heading.trim_end().to_owned())])?;
    // all tables are checked before anything is written
    let (mut absent, mut fates) = (Vec::new(), Fates::default());
    let mut standing = Standing { rows: if writes.force { None } else { of_this(scene, out) }, path: out };
    joined(scene, paths, makers, |joined| {
        match joined {
            Joined::Row(text, member, stopped) => {
                standing.meets(Some(text))?;
                fates.add(member, stopped);
            }
            Joined::Missing(members) => absent.push(told(&members)),
        }
        Ok(())
    })?;
    if absent.is_empty() {
        standing.meets(None)?;
    }
    if !absent.is_empty() {
        let which = absent.join(", ");
        return Err(Exit::refused(format!(
            "{} cannot be written: no table has member {which}; --part runs what its table lacks, and all tables together are accepted",
            out.display()
        )));
    }
    let mut wrong = None;
    let written = output.write(|file| {
        file.write_all(heading.as_bytes())?;
        let mut failed = None;
        let all = joined(scene, paths, makers, |joined| match joined {
            Joined::Row(text, ..) => file.write_all(text).map_err(|error| {
                failed = Some(error);
                Exit::Stopped
            }),
            Joined::Missing(_) => {
                Err(Exit::refused("a table was changed while it was read; the same command tries again"))
            }
        });
        match (failed, all) {
            (Some(error), _) => Err(error),
            (None, Ok(())) => Ok(()),
            (None, Err(exit)) => {
                wrong = Some(exit);
                Err(io::ErrorKind::Interrupted.into())
            }
        }
    });
    if let Some(wrong) = wrong {
        return Err(wrong);
    }
    let _ = written?;
    print(&fates.text(out, 0, |member| scene.failures(member, &|| clock::goes_on().is_continue())))?;
    Ok(if fates.reached() > 0 { Exit::Done } else { Exit::Stopped })
}

/// An existing table of this ensemble at the destination. Its rows must agree with those of the parts, otherwise it is not replaced.
struct Standing<'a> {
    path: &'a Path,
    rows: Option<Rows<'a, BufReader<File>>>,
}

/// The table at a path; `None` unless its first row belongs to this ensemble.
fn of_this<'a>(scene: &'a EnsembleScene, path: &Path) -> Option<Rows<'a, BufReader<File>>> {
    // opening a pipe would wait for a writer
    let open =
        || Rows::of(BufReader::new(File::open(path).ok().filter(|_| path.is_file())?), scene, Makers::This).ok()?;
    open()?.next_row().ok()??;
    open()
}

impl Standing<'_> {
    /// Refuses a row that differs from the joined one. A table that ends early is accepted, since nothing is lost.
    fn meets(&mut self, wanted: Option<&[u8]>) -> Result<(), Exit> {
        let Some(rows) = &mut self.rows else { return Ok(()) };
        match rows.next_row() {
            Ok(Some(_)) if wanted == Some(rows.text()) => Ok(()),
            Ok(None) => {
                self.rows = None;
                Ok(())
            }
            _ => Err(Exit::refused(format!(
                "{}, line {}: this row is none of the tables that are joined, and would be lost; a name that is free is accepted, and \
                 --force, which replaces the file",
                self.path.display(),
                rows.line()
            ))),
        }
    }
}

fn told(members: &RangeInclusive<u64>) -> String {
    match members.start() == members.end() {
        true => members.start().to_string(),
        false => format!("{}-{}", members.start(), members.end()),
    }
}
