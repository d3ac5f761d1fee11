//! `dalembert ensemble`: many members of one scene, their results in a table that survives a kill.

mod fates;
mod table;

use crate::arguments::whole;
use crate::clock;
use crate::exit::{Exit, print};
use crate::output::Writes;
use crate::progress::Progress;
use clap::Args;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use table::Table;

/// Which members are to be run, and where the results go.
#[derive(Args, Debug)]
pub struct Asked {
    /// The scene with a table `ensemble`, such as `scenes/ensembles/spread.toml` or `scenes/models/double_pendulum.toml`
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The table of results, a row for each member; one of this very ensemble is continued. Without it: the scene's name, here
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Begins anew where another file stands, or a table of another ensemble
    #[arg(long)]
    pub force: bool,
    /// Threads; without it as many as there are processors. The results do not depend on it
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1..=1024))]
    pub threads: Option<u16>,
}

/// Runs what is not done yet, and says what became of all.
pub fn run(asked: &Asked) -> Result<Exit, Exit> {
    let scene = studies::ensemble::open(&asked.scene)?;
    let usual = asked.scene.with_extension("csv");
    let path = asked.out.as_deref().unwrap_or_else(|| Path::new(usual.file_name().unwrap_or(usual.as_os_str())));
    let writes = Writes { command: "ensemble", force: asked.force, reads: vec![&asked.scene] };
    let (mut table, mut told) = Table::open(&writes, path, &scene)?;
    let (done, all) = (told.members, scene.members);
    let threads =
        asked.threads.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), usize::from);

    let mut progress = Progress::new(scene.system.title());
    let mut wrong = Ok(());
    scene.run(done + 1..=all, threads, |row| {
        told.add(row.stopped.as_deref());
        wrong = table.push(&row);
        progress.set(told.members as f64 / all as f64);
        if wrong.is_ok() { clock::goes_on() } else { ControlFlow::Break(()) }
    });
    wrong?;
    table.settle()?;
    drop(progress);
    print(&told.text(path, done, |member| scene.failures(member, &|| clock::goes_on().is_continue())))?;
    if told.members == all {
        // as of a run that stops, where none came to its end
        return Ok(if told.reached() > 0 { Exit::Done } else { Exit::Stopped });
    }
    print(&format!("broken off: the same command goes on with member {}\n", told.members + 1))?;
    Ok(Exit::Stopped)
}
