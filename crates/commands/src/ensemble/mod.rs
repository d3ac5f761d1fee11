//! `dalembert ensemble`: runs the members of an ensemble. Its table of results survives a kill, and parts may run on several computers.

mod fates;
mod merge;
mod part;
mod rows;
mod table;

use crate::arguments::whole;
use crate::clock;
use crate::exit::{Exit, print};
use crate::output::Writes;
use crate::progress::Progress;
use part::Part;
use rows::Makers;
use std::ops::ControlFlow;
use std::path::PathBuf;
use table::Table;

/// Arguments of `ensemble`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene with a table `ensemble`, such as `scenes/ensembles/spread.toml` or `scenes/models/double_pendulum.toml`
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The table of results, a row for each member; a table of this ensemble is continued. The default is a file in the current folder
    /// with the name of the scene
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Replaces another file, or a table of another ensemble
    #[arg(long)]
    pub force: bool,
    /// The number of threads; the default is the number of processors. The results do not depend on it
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1..=1024))]
    pub threads: Option<u16>,
    /// Part I of N: a contiguous range of members, whose rows are identical to those of a complete run. Without --out its table is NAME.I-of-N.csv
    #[arg(long, value_name = "I/N", conflicts_with_all = ["merge", "missing"])]
    pub part: Option<Part>,
    /// Joins these tables into one table of all members, as a run of all members would have written it
    #[arg(long, value_name = "FILE.csv", num_args = 1.., conflicts_with = "missing")]
    pub merge: Vec<PathBuf>,
    /// Prints the members that none of these tables has, a range in each line; the exit code is 0 if none is missing, else 1
    #[arg(long, value_name = "FILE.csv", num_args = 1.., conflicts_with_all = ["out", "force", "threads"])]
    pub missing: Vec<PathBuf>,
    /// With --merge and --missing: accepts rows of other versions of the program, and of processors that round differently
    #[arg(long)]
    pub any_processor: bool,
}

impl Args {
    /// The default name of the table.
    fn usual(&self) -> PathBuf {
        let end = self.part.map_or_else(|| "csv".to_owned(), |part| format!("{part}.csv"));
        let path = self.scene.with_extension(end);
        path.file_name().map_or_else(|| path.clone(), PathBuf::from)
    }
}

/// Runs the members that are not in the table yet, and prints the counts of all members.
pub fn run(asked: &Args) -> Result<Exit, Exit> {
    if asked.any_processor && asked.merge.is_empty() && asked.missing.is_empty() {
        return Err(Exit::refused(
            "--any-processor is for --merge and --missing: rows that are computed now are of this processor",
        ));
    }
    let scene = studies::ensemble::open(&asked.scene)?;
    let usual = asked.usual();
    let path = asked.out.as_deref().unwrap_or(&usual);
    let reads = std::iter::once(&asked.scene).chain(&asked.merge).map(PathBuf::as_path).collect();
    let writes = Writes { command: "ensemble", force: asked.force, reads };
    let makers = if asked.any_processor { Makers::Any } else { Makers::This };
    if !asked.missing.is_empty() {
        return merge::missing(&scene, &asked.missing, makers);
    }
    if !asked.merge.is_empty() {
        return merge::merge(&scene, &asked.merge, makers, (&writes, path));
    }
    let members = match asked.part {
        Some(part) => part.of(scene.members).ok_or_else(|| {
            Exit::refused(format!(
                "--part {part:#}: the ensemble has {} members, and each part needs at least one",
                scene.members
            ))
        })?,
        None => 1..=scene.members,
    };
    let (mut table, mut told) = Table::open(&writes, path, (&scene, &members))?;
    let (before, all) = (told.members, members.end() + 1 - members.start());
    let next = |done: u64| members.start() + done;
    let threads =
        asked.threads.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), usize::from);

    let mut progress = Progress::new(scene.system.title());
    let mut wrong = Ok(());
    scene.run(next(before)..=*members.end(), threads, |row| {
        told.add(row.number, row.stopped.as_deref());
        wrong = table.push(&row);
        progress.set(told.members as f64 / all as f64);
        if wrong.is_ok() { clock::goes_on() } else { ControlFlow::Break(()) }
    });
    wrong?;
    table.settle()?;
    drop(progress);
    print(&told.text(path, before, |member| scene.failures(member, &|| clock::goes_on().is_continue())))?;
    if told.members == all {
        // a single run that stops has this exit code too
        return Ok(if told.reached() > 0 { Exit::Done } else { Exit::Stopped });
    }
    print(&format!("interrupted: the same command continues with member {}\n", next(told.members)))?;
    Ok(Exit::Stopped)
}
