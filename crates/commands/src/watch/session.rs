//! A session: it checks the file, starts and stops stages, writes their results to the board, and applies sliders to the text in memory.

use super::board::Board;
use super::followed_file::FollowedFile;
use super::stage::Stage;
use super::staged_board::StagedBoard;
use super::told::Told;
use super::values::{Datum, changed, data};
use super::worker::{Order, Worker, WorkerEvent, WorkerNews};
use integrators::clock::over;
use reader::SceneError;
use serde_json::{Map, Value};
use std::io;
use std::path::PathBuf;
use std::process::ExitStatus;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

/// The interval at which the file is checked.
const LOOK: Duration = Duration::from_millis(40);

/// A message to the session.
pub enum Message {
    Worker(WorkerNews),
    /// New values of sliders, which replace all earlier values.
    Values(Map<String, Value>),
}

impl From<WorkerNews> for Message {
    fn from(news: WorkerNews) -> Self {
        Message::Worker(news)
    }
}

/// The session of a file.
pub struct Session {
    file: FollowedFile,
    board: StagedBoard,
    /// The time limit of each stage, s.
    budget: u32,
    sender: Sender<Message>,
    news: Receiver<Message>,
    workers: Vec<Worker>,
    /// The number of the last worker that was started.
    number: u64,
    text: String,
    data: Vec<Datum>,
    /// The paths of files that the text names.
    beside: Vec<PathBuf>,
    /// The messages of stages that refused the text, with the numbers of their workers.
    refused: Vec<(u64, String)>,
    /// The message that refuses the whole text, if any.
    refusal: Option<String>,
    /// Whether the present text can be read.
    is_read: bool,
}

impl Session {
    pub fn new(file: FollowedFile, board: Arc<Board>, budget: u32) -> Self {
        let (sender, news) = channel();
        Session {
            file,
            board: StagedBoard::new(board),
            budget,
            sender,
            news,
            workers: Vec::new(),
            number: 0,
            text: String::new(),
            data: Vec::new(),
            beside: Vec::new(),
            refused: Vec::new(),
            refusal: None,
            is_read: false,
        }
    }

    /// A sender for new values of sliders.
    pub fn sender(&self) -> Sender<Message> {
        self.sender.clone()
    }

    /// Updates the page until the user stops the program or the time limit is reached.
    pub fn follow(&mut self) {
        let mut looked = None::<Instant>;
        while over().is_none() {
            if looked.is_none_or(|looked| looked.elapsed() >= LOOK) {
                looked = Some(Instant::now());
                if let Some(content) = self.file.change() {
                    self.renew(content);
                }
            }
            self.hear();
        }
        self.workers.clear();
    }

    /// Runs all stages for the present file. Returns whether every part was completed.
    ///
    /// # Errors
    /// The message that refuses the text.
    pub fn finish(&mut self) -> Result<bool, String> {
        if let Some(content) = self.file.change() {
            self.renew(content);
        }
        while over().is_none() && !self.workers.is_empty() {
            self.hear();
        }
        for Worker { stage, .. } in self.workers.drain(..) {
            self.board.fail(stage, "not finished when the page was written; more time is given by --seconds");
        }
        self.refusal.take().map_or_else(|| Ok(self.board.is_whole()), Err)
    }

    /// Handles the next message; waits for it no longer than until the next check of the file.
    fn hear(&mut self) {
        match self.news.recv_timeout(LOOK) {
            Ok(Message::Worker(WorkerNews { number, event })) => {
                // a worker that was stopped may have sent messages before
                let Some(place) = self.workers.iter().position(|worker| worker.number == number) else { return };
                match event {
                    WorkerEvent::Told(told) => self.tell(place, told),
                    WorkerEvent::Silent(beside) => {
                        let worker = self.workers.swap_remove(place);
                        self.end(worker, &beside);
                    }
                }
            }
            Ok(Message::Values(values)) => self.move_sliders(&values),
            // no message arrived; the channel cannot be closed, since the session owns a sender
            Err(_) => {}
        }
    }

    /// Stops the running stages and starts those for a new content of the file.
    fn renew(&mut self, content: Result<String, SceneError>) {
        self.workers.clear();
        self.refused.clear();
        self.beside.clear();
        (self.refusal, self.is_read) = (None, false);
        match content {
            Ok(text) => {
                self.text = text;
                self.start(Stage::System, self.text.clone());
            }
            Err(error) => self.refuse(error.render(false)),
        }
    }

    fn refuse(&mut self, why: String) {
        self.board.refuse(&why);
        self.refusal = Some(why);
    }

    fn start(&mut self, stage: Stage, text: String) {
        self.workers.retain(|worker| worker.stage != stage);
        self.number += 1;
        let order = Order { stage, number: self.number, path: self.file.path(), text, budget: self.budget };
        match Worker::start(order, &self.sender) {
            Ok(worker) => {
                self.board.begin(stage);
                self.workers.push(worker);
            }
            Err(error) => self.board.fail(stage, &format!("this part cannot be started: {error}")),
        }
    }

    fn tell(&mut self, place: usize, told: Told) {
        let Worker { stage, number, .. } = self.workers[place];
        match told {
            Told::Part { id, content } => self.board.tell(stage, &id, content),
            Told::Refused(why) => self.refused.push((number, why)),
            Told::Reads(path) => self.beside.push(path),
            Told::Then(stages) => self.go_on(&stages),
        }
    }

    /// Starts the stages that apply to a text that was read without faults.
    fn go_on(&mut self, stages: &[Stage]) {
        self.is_read = true;
        self.data = if stages.contains(&Stage::Motion) { data(&self.text) } else { Vec::new() };
        self.board.show_sliders(&self.data);
        for stage in [Stage::Motion, Stage::Verdicts, Stage::Claims] {
            match stages.contains(&stage) {
                true => self.start(stage, self.text.clone()),
                false => self.board.leave_out(stage),
            }
        }
    }

    /// Handles the end of a stage.
    fn end(&mut self, worker: Worker, beside: &str) {
        let (stage, number) = (worker.stage, worker.number);
        let status = worker.status();
        let refused = self.refused.iter().find(|(own, _)| *own == number).map(|(_, why)| why.clone());
        let broken = match &status {
            Ok(status) if status.success() => None,
            _ => Some(broken(&status, beside, self.budget)),
        };
        match refused.or(broken) {
            None => self.board.succeed(stage, beside),
            Some(why) if stage == Stage::System && !self.is_read => self.refuse(why),
            Some(why) => self.board.fail(stage, &why),
        }
        if stage == Stage::System {
            self.file.follow(std::mem::take(&mut self.beside));
        }
    }

    /// Runs the text with other numbers, without a change of the file.
    fn move_sliders(&mut self, values: &Map<String, Value>) {
        if !self.is_read {
            return;
        }
        let known = |id: &String| self.data.iter().find(|datum| datum.id == *id);
        let moved: Vec<(&Datum, f64)> = values
            .iter()
            .filter_map(|(id, value)| known(id).zip(value.as_f64().filter(|value| value.is_finite())))
            .collect();
        let written = moved.iter().map(|(datum, value)| (datum.id.clone(), datum.written(*value).into())).collect();
        let changed = changed(&self.text, &moved);
        self.board.show_moved(written, &changed);
        self.start(Stage::Motion, changed.text);
    }
}

/// The reason for which a process ended without a result.
fn broken(status: &io::Result<ExitStatus>, beside: &str, budget: u32) -> String {
    match status {
        Ok(status) if beside.contains("out of time: ") && status.code() == Some(1) => {
            format!("not finished within {budget} s; more time is given by --budget")
        }
        Ok(status) => format!("this part ended without a result, {status}\n{}", beside.trim_end()),
        Err(error) => format!("this part ended without a result: {error}"),
    }
}
