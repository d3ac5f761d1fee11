//! A stage that runs in a separate process, which is killed when its handle is dropped.

use super::stage::Stage;
use super::told::{Given, Told};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::Sender;
use std::thread;

/// An event of a worker, with the number of the worker.
pub struct WorkerNews {
    /// The number of the worker, by which events of a stopped worker are ignored.
    pub number: u64,
    pub event: WorkerEvent,
}

/// An event of a worker.
pub enum WorkerEvent {
    Told(Told),
    /// The worker has closed its output; the text is that of its standard error.
    Silent(String),
}

/// The process of a stage; dropping the value kills the process.
pub struct Worker {
    pub stage: Stage,
    pub number: u64,
    child: Child,
    /// The standard input of the process, which ends itself when the input is closed.
    input: Option<ChildStdin>,
}

/// The task of a worker.
pub struct Order<'a> {
    pub stage: Stage,
    pub number: u64,
    pub path: &'a Path,
    pub text: String,
    /// The time limit in seconds.
    pub budget: u32,
}

impl Worker {
    /// Starts the process. Its reports are sent through `sender`.
    ///
    /// # Errors
    /// No process or no thread can be created.
    pub fn start<M: From<WorkerNews> + Send + 'static>(order: Order<'_>, sender: &Sender<M>) -> io::Result<Self> {
        let Order { stage, number, path, text, budget } = order;
        let given = serde_json::to_string(&Given { text })? + "\n";
        let mut child = Command::new(std::env::current_exe()?)
            .args(["watch", "--stage", stage.name(), "--seconds", &budget.to_string(), "--"])
            .arg(path)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()?;
        let (out, error) = (child.stdout.take(), child.stderr.take());
        let mut worker = Worker { stage, number, input: child.stdin.take(), child };
        let (Some(out), Some(mut error)) = (out, error) else { return Err(io::ErrorKind::BrokenPipe.into()) };
        let told_beside = thread::Builder::new().spawn(move || {
            let mut bytes = Vec::new();
            // if reading fails, the bytes read so far are kept
            let _ = error.read_to_end(&mut bytes);
            String::from_utf8_lossy(&bytes).into_owned()
        })?;
        let sender = sender.clone();
        thread::Builder::new().spawn(move || {
            let lines = BufReader::new(out).lines().map_while(Result::ok);
            for told in lines.filter_map(|line| serde_json::from_str(&line).ok()) {
                if sender.send(WorkerNews { number, event: WorkerEvent::Told(told) }.into()).is_err() {
                    return;
                }
            }
            let beside = told_beside.join().unwrap_or_default();
            // an error means that the session has ended
            let _ = sender.send(WorkerNews { number, event: WorkerEvent::Silent(beside) }.into());
        })?;
        // an error is ignored, since the exit status of the process shows the reason
        let _ = worker.input.as_mut().map(|input| input.write_all(given.as_bytes()).and_then(|()| input.flush()));
        Ok(worker)
    }

    /// The exit status of a process that has closed its output.
    ///
    /// # Errors
    /// The system does not return the status.
    pub fn status(mut self) -> io::Result<ExitStatus> {
        self.child.wait()
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // killing a process that has ended fails, which is ignored
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
