//! `dalembert watch`: a page on the loopback address that is updated whenever a file is saved.

mod board;
mod followed_file;
mod page;
mod server;
mod session;
mod stage;
mod staged_board;
mod told;
mod values;
mod worker;

use crate::clock::{self, Keeps};
use crate::exit::{Exit, print, warn};
use crate::output::{Form, Format, Writes};
use board::Board;
use followed_file::FollowedFile;
use page::PageTitle;
use reader::read_text;
use server::Server;
use session::Session;
use stage::Stage;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Arguments of `watch`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// A scene, or a paper with [[claim]]. The page is updated each time the file is saved: equations, verdicts, the run, and errors of
    /// the text
    #[arg(value_name = "SCENE.toml|PAPER.toml")]
    pub file: PathBuf,
    /// The port of the page on 127.0.0.1; the default is a free port
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..), conflicts_with = "save")]
    pub port: Option<u16>,
    /// Time limit in seconds for each part of the page: equations, verdicts, the run, claims
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    pub budget: u32,
    /// Writes the page of the present file to this file, readable without the program, and ends
    #[arg(long, value_name = "FILE.html")]
    pub save: Option<PathBuf>,
    /// Replaces the file of --save even if `watch` did not write it
    #[arg(long, requires = "save")]
    pub force: bool,
    /// The part of the page that this process computes; used by the program itself
    #[arg(long, hide = true, value_enum)]
    stage: Option<Stage>,
}

impl Args {
    /// Whether the command keeps partial results at its time limit.
    pub fn keeps(&self) -> Keeps {
        match self.stage {
            None | Some(Stage::Motion) => Keeps::Part,
            Some(_) => Keeps::Nothing,
        }
    }
}

/// The time for open pages to receive the end of the session.
const FAREWELL: Duration = Duration::from_millis(60);

/// Serves the page until Ctrl-C, or saves it.
pub fn watch(asked: &Args) -> Result<Exit, Exit> {
    if let Some(stage) = asked.stage {
        return stage::work(stage, &asked.file);
    }
    if std::fs::metadata(&asked.file).is_ok_and(|data| !data.is_file() && !data.is_dir()) {
        let why = "a pipe or a device can be read only once; a file is accepted";
        return Err(Exit::refused(format!("{}: {why}", asked.file.display())));
    }
    // a file that cannot be read is refused; a text with faults is shown
    read_text(&asked.file)?;
    let board = Arc::new(Board::default());
    let session = Session::new(FollowedFile::new(&asked.file), Arc::clone(&board), asked.budget);
    let title: PageTitle = name(&asked.file).into();
    match &asked.save {
        Some(save) => write(asked, save, session, &board, &title),
        None => serve(asked, session, board, title),
    }
}

fn serve(asked: &Args, mut session: Session, board: Arc<Board>, title: PageTitle) -> Result<Exit, Exit> {
    let port = asked.port.unwrap_or(0);
    let refused = |error: std::io::Error| {
        Exit::refused(format!(
            "--port {port}: {error}; another port is accepted, and without --port a free one is taken"
        ))
    };
    let server = Server::listen(port, Arc::clone(&board), title, session.sender()).map_err(refused)?;
    let address = server.address();
    server.start().map_err(refused)?;
    print(&format!("{address}\n"))?;
    session.follow();
    board.end();
    std::thread::sleep(FAREWELL);
    clock::keeps_nothing();
    Ok(Exit::Done)
}

fn write(asked: &Args, save: &Path, mut session: Session, board: &Board, title: &str) -> Result<Exit, Exit> {
    let writes = Writes { command: "watch", force: asked.force, reads: vec![&asked.file] };
    let output = writes.output(save, &[Form::Page])?;
    let is_whole = session.finish().map_err(Exit::Refused)?;
    output.write_text(&page::saved(board, title))?.tell(Format::Text)?;
    if !is_whole {
        warn("a part of the page was not finished; the page says why");
        return Ok(Exit::Stopped);
    }
    Ok(Exit::Done)
}

/// The name of a file without its folder.
fn name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}
