//! The clock of a command: its deadline, Ctrl-C, and the thread that enforces both.
//!
//! A command that can keep partial results stops by itself, since its integrations check [`integrators::clock`]. Other work, such as
//! algebra, does not; for such work the thread of the clock ends the program after it has printed the results so far. The thread
//! waits while something is printed or written.

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

/// The time after its deadline in which a command can stop by itself.
const GRACE: Duration = Duration::from_millis(700);
/// The least time that is reserved for judging and printing results.
const CLOSING: Duration = Duration::from_millis(400);
/// The reserved fraction of the time limit is one over this number.
const CLOSING_PART: u32 = 20;
/// The interval at which the thread checks time and signals.
const TICK: Duration = Duration::from_millis(20);
/// The number of checks between two drawings of the progress bar.
const TICKS_A_DRAWING: u32 = 5;
/// The remaining time of a command without a limit.
const NO_LIMIT: Duration = Duration::from_secs(366 * 86_400);
/// The exit code of shells for a program ended by SIGINT.
const BY_CTRL_C: u8 = 130;

/// Whether a command can keep partial results when it is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeps {
    /// Partial results are useful and are kept.
    Part,
    /// Only complete results are useful.
    Nothing,
}

struct Clock {
    command: &'static str,
    keeps: Keeps,
    /// The time limit in seconds; `None` without a limit.
    seconds: Option<u32>,
    deadline: Option<Instant>,
}

static CLOCK: OnceLock<Clock> = OnceLock::new();
/// A lock that code takes for reading while it prints or writes, and the thread for writing before it ends the program.
static OUTPUT: RwLock<()> = RwLock::new(());
/// Whether the user pressed Ctrl-C.
static PRESSED: AtomicBool = AtomicBool::new(false);
/// Whether a command that stopped by itself has no results to keep.
static NOTHING: AtomicBool = AtomicBool::new(false);
/// The phase of the work in which the command was stopped.
static PHASE: OnceLock<Option<String>> = OnceLock::new();
/// The results so far, which are printed if the program is ended early.
static FOUND: Mutex<String> = Mutex::new(String::new());

/// The file that the command will write last; `None` once it is written.
static DUE: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Starts the clock of a command; called once, before its work.
pub fn start(command: &'static str, keeps: Keeps, seconds: Option<u32>) {
    let deadline = seconds.map(|seconds| Instant::now() + Duration::from_secs(seconds.into()));
    let clock = CLOCK.get_or_init(|| Clock { command, keeps, seconds, deadline });
    if let (Some(deadline), Keeps::Part) = (deadline, keeps) {
        set_deadline(deadline);
    }
    let pressed = Arc::new(AtomicBool::new(false));
    // where signals or threads are unavailable, Ctrl-C has its usual effect
    let watched = std::thread::Builder::new().name("clock".to_owned());
    let flag = Arc::clone(&pressed);
    if watched.spawn(move || clock.watch(&pressed)).is_ok() {
        let _ = flag::register(SIGINT, flag);
    }
}

/// The remaining time; a year where there is no limit.
pub fn left() -> Duration {
    let deadline = CLOCK.get().and_then(|clock| clock.deadline);
    deadline.map_or(NO_LIMIT, |deadline| deadline.saturating_duration_since(Instant::now()))
}

/// `Break` after the user has pressed Ctrl-C, else `Continue`.
pub fn goes_on() -> ControlFlow<()> {
    if is_asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// Whether there is time for more work, in addition to the time reserved for judging and printing the results.
pub fn has_time() -> bool {
    let given = CLOCK.get().and_then(|clock| clock.seconds).map_or(Duration::ZERO, |s| Duration::from_secs(s.into()));
    goes_on().is_continue() && left() > CLOSING.max(given / CLOSING_PART)
}

/// A guard that keeps the clock from ending the program, so that no output is incomplete.
pub fn held() -> RwLockReadGuard<'static, ()> {
    OUTPUT.read().unwrap_or_else(PoisonError::into_inner)
}

/// Stores the results so far; the clock prints them if it ends the program early.
pub fn publish(found: String) {
    *FOUND.lock().unwrap_or_else(PoisonError::into_inner) = found;
}

/// Stores the name of the file that is written last, which the clock reports as missing if it ends the program early; `None` once it is written.
pub fn due(file: Option<&Path>) {
    *DUE.lock().unwrap_or_else(PoisonError::into_inner) = file.map(Path::to_owned);
}

/// Stores the present phase as the one in which the command was stopped; only the first call has an effect.
pub fn note_phase() {
    PHASE.get_or_init(progress::phase);
}

/// Records that a stopped command keeps no results.
pub fn keeps_nothing() {
    NOTHING.store(true, Relaxed);
}

/// Prints the reason for which a command was stopped, and returns its exit code; `None` if it was not stopped.
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
                // commands that need complete results must not mistake a stopped run for one
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

    /// Ends the program at once.
    fn end(&self) -> ! {
        progress::clear();
        atomic_write::remove_parts();
        let found = FOUND.try_lock().map(|found| found.clone()).unwrap_or_default();
        // a second Ctrl-C may come while a full pipe blocks standard output; all results have been printed then
        if !found.is_empty() {
            // if writing fails, the exit code alone reports the end
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
        // if writing fails, the exit code alone reports the end
        let _ = writeln!(io::stderr(), "{}", charts::visible(&told));
    }
}
