//! The one clock of a command: its deadline, Ctrl-C, and the thread that sees that both are obeyed.
//!
//! A command that can keep partial results stops by itself: its integrations ask [`integrators::clock`]. All other work, such as
//! algebra, need not ask: the thread of the clock ends the program instead, after it has printed the results so far. While
//! something is printed or written the thread waits.

use crate::{atomic_write, progress};
use integrators::clock::{is_asked, request_end, set_deadline, was_obeyed};
use signal_hook::consts::SIGINT;
use signal_hook::flag;
use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Arc, Mutex, OnceLock, PoisonError, RwLock, RwLockReadGuard};
use std::time::{Duration, Instant};

/// The time that a command has to stop by itself after its deadline.
const GRACE: Duration = Duration::from_millis(700);
/// The least time that is reserved for judging and printing the results.
const CLOSING: Duration = Duration::from_millis(400);
/// The reserved part of the time limit: one over this number.
const CLOSING_PART: u32 = 20;
/// The interval at which the thread checks the time: too short for a user to notice.
const TICK: Duration = Duration::from_millis(20);
/// Ticks between two drawings of the progress bar: ten drawings a second.
const TICKS_A_DRAWING: u32 = 5;
/// The time that is left where there is no limit.
const NO_LIMIT: Duration = Duration::from_secs(366 * 86_400);
/// The exit code that shells report for a program ended by SIGINT.
const BY_CTRL_C: u8 = 130;

/// Whether a command can keep partial results when it is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeps {
    /// Partial results are useful and are kept.
    Part,
    /// Results are complete or none.
    Nothing,
}

struct Clock {
    command: &'static str,
    keeps: Keeps,
    seconds: Option<u32>,
    deadline: Option<Instant>,
}

static CLOCK: OnceLock<Clock> = OnceLock::new();
/// Locked for reading by code that prints or writes, for writing by the thread when it ends the program.
static OUTPUT: RwLock<()> = RwLock::new(());
/// Whether the user pressed Ctrl-C.
static PRESSED: AtomicBool = AtomicBool::new(false);
/// Whether a command that stopped by itself has no results to keep.
static NOTHING: AtomicBool = AtomicBool::new(false);
/// The phase of the work in which the end came.
static PHASE: OnceLock<Option<String>> = OnceLock::new();
/// Results that are printed if the program is ended before it prints them.
static FOUND: Mutex<String> = Mutex::new(String::new());

/// The file that a command writes last, until it is written.
static DUE: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Starts the clock of a command; once, before its work.
pub fn start(command: &'static str, keeps: Keeps, seconds: Option<u32>) {
    let deadline = seconds.map(|seconds| Instant::now() + Duration::from_secs(seconds.into()));
    let clock = CLOCK.get_or_init(|| Clock { command, keeps, seconds, deadline });
    if let (Some(deadline), Keeps::Part) = (deadline, keeps) {
        set_deadline(deadline);
    }
    let pressed = Arc::new(AtomicBool::new(false));
    // without signals or threads Ctrl-C ends the program in the system's own way
    let watched = std::thread::Builder::new().name("clock".to_owned());
    let flag = Arc::clone(&pressed);
    if watched.spawn(move || clock.watch(&pressed)).is_ok() {
        let _ = flag::register(SIGINT, flag);
    }
}

/// The time that is left.
pub fn left() -> Duration {
    let deadline = CLOCK.get().and_then(|clock| clock.deadline);
    deadline.map_or(NO_LIMIT, |deadline| deadline.saturating_duration_since(Instant::now()))
}

/// Breaks once the user has pressed Ctrl-C.
pub fn goes_on() -> ControlFlow<()> {
    if is_asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// Whether there is time for more work, besides the time reserved for judging and printing the results.
pub fn has_time() -> bool {
    let given = CLOCK.get().and_then(|clock| clock.seconds).map_or(Duration::ZERO, |s| Duration::from_secs(s.into()));
    goes_on().is_continue() && left() > CLOSING.max(given / CLOSING_PART)
}

/// A guard during which the clock does not end the program, so that no output is cut.
pub fn held() -> RwLockReadGuard<'static, ()> {
    OUTPUT.read().unwrap_or_else(PoisonError::into_inner)
}

/// Results so far: printed if the clock ends the program before more are found.
pub fn publish(found: String) {
    *FOUND.lock().unwrap_or_else(PoisonError::into_inner) = found;
}

/// Names the file that is written last: if the clock ends the program before, it says that the file is missing. None where the file is written.
pub fn due(file: Option<&Path>) {
    *DUE.lock().unwrap_or_else(PoisonError::into_inner) = file.map(Path::to_owned);
}

/// Records the present phase as the one in which the end came; only the first call counts.
pub fn note_phase() {
    PHASE.get_or_init(progress::phase);
}

/// Records that a command that stopped by itself keeps nothing.
pub fn keeps_nothing() {
    NOTHING.store(true, Relaxed);
}

/// Prints the reason for which a command stopped by itself, and returns its exit code; `None` where it was not stopped.
pub fn broke_off() -> Option<u8> {
    let clock = CLOCK.get().filter(|_| PRESSED.load(Relaxed) || was_obeyed())?;
    clock.tell(if NOTHING.load(Relaxed) { "nothing is kept" } else { "the results so far are kept" });
    Some(clock.code())
}

impl Clock {
    /// Watches time and signals until the program ends.
    fn watch(&self, pressed: &AtomicBool) {
        let (mut asked, mut turn): (Option<Instant>, u32) = (None, 0);
        loop {
            std::thread::sleep(TICK);
            if pressed.swap(false, Relaxed) {
                if asked.is_some() {
                    self.end();
                }
                asked = Some(Instant::now());
                PRESSED.store(true, Relaxed);
                // commands that need complete results must not take a stopped run for a result
                if self.keeps == Keeps::Part {
                    request_end();
                }
            }
            turn = (turn + 1) % TICKS_A_DRAWING;
            let over = [asked, self.deadline].into_iter().flatten().min();
            if over.is_some_and(|over| Instant::now() >= over) {
                note_phase();
            }
            let Ok(_held) = OUTPUT.try_write() else { continue };
            let grace = if self.keeps == Keeps::Part { GRACE } else { Duration::ZERO };
            if over.is_some_and(|over| Instant::now() >= over + grace) {
                self.end();
            }
            if turn == 0 {
                progress::draw();
            }
        }
    }

    /// Ends the program, whatever it does.
    fn end(&self) -> ! {
        progress::clear();
        atomic_write::remove_parts();
        let found = FOUND.try_lock().map(|found| found.clone()).unwrap_or_default();
        // a second Ctrl-C may come while a full pipe blocks standard output: all results are printed then
        if !found.is_empty() {
            // where this cannot be written, the exit code must do
            let _ = io::stdout().write_all(charts::visible(&found).as_bytes()).and_then(|()| io::stdout().flush());
        }
        let kept = if found.is_empty() { "nothing is kept" } else { "the results so far are printed" };
        let due = DUE.try_lock().ok().and_then(|due| due.clone());
        let missing = due.map_or_else(String::new, |file| format!(", and {} is not written", file.display()));
        self.tell(&format!("{kept}{missing}"));
        process::exit(self.code().into())
    }

    fn code(&self) -> u8 {
        if PRESSED.load(Relaxed) { BY_CTRL_C } else { 1 }
    }

    fn tell(&self, kept: &str) {
        let command = self.command;
        let phase = PHASE.get().cloned().flatten().filter(|phase| phase != command);
        let phase = phase.map_or_else(String::new, |phase| format!(" ({phase})"));
        let told = match self.seconds {
            Some(seconds) if !PRESSED.load(Relaxed) => format!(
                "out of time: `{command}`{phase} was broken off after {seconds} s; {kept}; more time is given by --seconds"
            ),
            _ => format!("interrupted: `{command}`{phase} was broken off by Ctrl-C; {kept}"),
        };
        // where even this cannot be written, the exit code must do
        let _ = writeln!(io::stderr(), "{}", charts::visible(&told));
    }
}
