//! `dalembert ensemble`: many members of one scene, their results in a table that survives a kill.
//!
//! The table holds whole rows in the order of the members, so what there is says where to go on. A line that was cut is
//! taken away, and the last whole row is computed again: it must come out the same.

use crate::arguments::whole;
use crate::ending::{Ending, print};
use crate::interrupt::Interrupt;
use crate::progress::Progress;
use clap::Args;
use derivations::ensemble::{EnsembleScene, Row};
use derivations::scene::Family;
use std::collections::BTreeMap;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Read, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Which members are to be run, and where the results go.
#[derive(Args, Debug)]
pub struct Asked {
    /// The scene with a table `ensemble`; the folder `scenes/ensembles` holds an example
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The table of results, a row for each member; one that is there is continued. Without it: the scene's name, here
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Threads; without it as many as there are processors. The results do not depend on it
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1..=1024))]
    pub threads: Option<u16>,
}

/// Rows are written when there are so many bytes of them.
const BLOCK: usize = 1 << 14;

/// What is written is brought to the disk so often.
const CHUNK: Duration = Duration::from_millis(500);

/// Runs what is not done yet, and says what became of all.
pub fn run(asked: &Asked) -> Result<Ending, Ending> {
    let scene = EnsembleScene::open(&asked.scene)?;
    let usual = asked.scene.with_extension("csv");
    let path = asked.out.as_deref().unwrap_or_else(|| Path::new(usual.file_name().unwrap_or(usual.as_os_str())));
    let (mut table, mut told) = Table::open(path, &scene)?;
    let (done, all) = (told.members, scene.members);
    let threads =
        asked.threads.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), usize::from);

    let mut progress = Progress::new(&scene.scene.title);
    let mut wrong = Ok(());
    let interrupt = Interrupt::watched();
    scene.run(done + 1..=all, threads, |row| {
        told.add(row.stopped.as_deref());
        wrong = table.push(&line(&row));
        progress.set(told.members as f64 / all as f64);
        if wrong.is_ok() { interrupt.goes_on() } else { ControlFlow::Break(()) }
    });
    wrong.and_then(|()| table.settle()).map_err(|error| Ending::unwritable(path, &error))?;
    drop(progress);
    print(&told.text(path, done))?;
    if told.members == all {
        return Ok(Ending::Done);
    }
    print(&format!("interrupted: the same command goes on with member {}\n", told.members + 1))?;
    Ok(Ending::Interrupted)
}

/// A row of the table, with its end.
fn line(row: &Row) -> String {
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| x.to_string());
    let mut cells = vec![row.number.to_string()];
    cells.extend(row.drawn.iter().map(f64::to_string));
    cells.push(row.stopped.as_deref().map_or_else(String::new, |why| format!("\"{}\"", why.replace('"', "\"\""))));
    cells.push(number(row.last.as_ref().map(|last| last.time)));
    cells.push(row.steps.to_string());
    if let Some(last) = &row.last {
        cells.extend(last.state.iter().map(f64::to_string));
        cells.extend(last.changes.map(number));
    }
    cells.join(",") + "\n"
}

/// How a row begins, whatever came of the member.
fn beginning(scene: &EnsembleScene, number: u64) -> String {
    let drawn = scene.drawn(number);
    std::iter::once(number.to_string()).chain(drawn.iter().map(f64::to_string)).collect::<Vec<_>>().join(",") + ","
}

/// The table on the disk.
struct Table {
    file: File,
    /// Rows that are not written yet.
    waiting: String,
    settled: Instant,
}

impl Table {
    /// Makes it, or goes on with the one that is there.
    fn open(path: &Path, scene: &EnsembleScene) -> Result<(Self, Told), Ending> {
        let unwritable = |error: io::Error| Ending::unwritable(path, &error);
        let columns = scene.columns();
        let heading = columns.join(",") + "\n";
        let mut file = OpenOptions::new().read(true).append(true).create(true).open(path).map_err(unwritable)?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => {
                let reason = "another run writes to it; wait for its end, or name another file";
                return Err(Ending::refused(format!("{}: {reason}", path.display())));
            }
            // where files cannot be locked, two runs at once are the user's care
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(unwritable)?;
        let whole = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1);
        let foreign = |number: usize, why: String| {
            let accepted = "a table of this very ensemble is continued; name another file, or remove this one";
            Ending::refused(format!("{}, line {number}: {why}; {accepted}", path.display()))
        };
        let text = std::str::from_utf8(&bytes[..whole]).map_err(|_| foreign(1, "this is no text".to_owned()))?;
        if whole == 0 && !heading.as_bytes().starts_with(&bytes) {
            return Err(foreign(1, "this is no table of results".to_owned()));
        }
        let mut told = Told::default();
        let mut last = "";
        for (number, found) in text.split_inclusive('\n').enumerate() {
            if number == 0 {
                if found != heading {
                    return Err(foreign(1, "these are the columns of something else".to_owned()));
                }
                continue;
            }
            let begins = beginning(scene, number as u64);
            let Some(rest) = found.strip_prefix(&begins) else {
                return Err(foreign(number + 1, format!("member {number} has other data here")));
            };
            if told.members == scene.members {
                return Err(foreign(
                    number + 1,
                    format!("there are more than the {number} members", number = scene.members),
                ));
            }
            told.add(rest.strip_prefix('"').and_then(|rest| rest.split("\",").next()));
            last = found;
        }
        if told.members > 0 {
            let mut again = String::new();
            scene.run(told.members..=told.members, 1, |row| {
                again = line(&row);
                ControlFlow::Continue(())
            });
            if again != last {
                let why = format!("member {} comes out otherwise today", told.members);
                return Err(foreign(told.members as usize + 1, why));
            }
        }
        file.set_len(whole as u64).map_err(unwritable)?;
        let mut table = Table { file, waiting: String::new(), settled: Instant::now() };
        if whole == 0 {
            table.waiting = heading;
            table.settle().map_err(unwritable)?;
        }
        Ok((table, told))
    }

    /// A kill takes what is not written, a failure of the power what is not brought to the disk.
    fn push(&mut self, row: &str) -> io::Result<()> {
        self.waiting += row;
        if self.settled.elapsed() >= CHUNK {
            return self.settle();
        }
        if self.waiting.len() >= BLOCK { self.write() } else { Ok(()) }
    }

    fn write(&mut self) -> io::Result<()> {
        self.file.write_all(self.waiting.as_bytes())?;
        self.waiting.clear();
        Ok(())
    }

    /// Writes what waits, and brings all to the disk.
    fn settle(&mut self) -> io::Result<()> {
        self.write()?;
        self.file.sync_data()?;
        self.settled = Instant::now();
        Ok(())
    }
}

/// What became of the members.
#[derive(Default)]
struct Told {
    members: u64,
    /// By the first words of the reason.
    stopped: BTreeMap<String, u64>,
}

impl Told {
    fn add(&mut self, stopped: Option<&str>) {
        self.members += 1;
        if let Some(why) = stopped {
            let kind = why.split([':', '=']).next().unwrap_or(why).trim_end_matches(" at t ").to_owned();
            *self.stopped.entry(kind).or_default() += 1;
        }
    }

    fn text(&self, path: &Path, before: u64) -> String {
        let stopped: u64 = self.stopped.values().sum();
        let reached = self.members - stopped;
        let mut text = format!("{} members: {reached} reached the end, {stopped} did not\n", self.members);
        for (why, count) in &self.stopped {
            text += &format!("  {count:>8}  {why}\n");
        }
        if before > 0 {
            text += &format!("the first {before} were there already\n");
        }
        text + &format!("{}\n", path.display())
    }
}
