//! The progress of long work, shown on terminals only: a bar where the completed fraction is known, otherwise the elapsed time.

use crate::clock;
use crate::exit::is_quiet;
use charts::visible;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use integrators::clock::was_obeyed;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The duration of the work from which on progress is shown.
const PATIENCE: Duration = Duration::from_millis(700);
const MARKS: u64 = 1000;
const WITH_BAR: &str = "{msg} {wide_bar} {percent} % {eta}";
const WITH_SECONDS: &str = "{spinner} {msg}, {elapsed}";

/// The present phase of the work. The thread of the clock draws it, so that progress is shown during long steps too.
static WORK: Mutex<Option<Work>> = Mutex::new(None);

struct Work {
    label: String,
    begun: Instant,
    /// The completed fraction in units of 1 / [`MARKS`]; zero where the work does not report it.
    done: u64,
    bar: Option<ProgressBar>,
}

/// A phase of the work. Dropping the value removes the progress bar and restores the phase before.
pub struct Progress {
    before: Option<Work>,
    /// The number of marks of the bar that have been reported.
    shown: u64,
}

impl Progress {
    /// Starts a phase of the work with this label.
    pub fn new(label: &str) -> Self {
        clear();
        // a title of a scene may contain control sequences of terminals
        let label = visible(label).into_owned();
        let work = Work { label, begun: Instant::now(), done: 0, bar: None };
        Progress { before: at_work().replace(work), shown: 0 }
    }

    /// Reports the completed fraction, from 0 to 1. Frequent calls are cheap, since only whole marks of the bar are stored.
    pub fn set(&mut self, fraction: f64) {
        let mark = (fraction * MARKS as f64) as u64;
        if mark > self.shown {
            self.shown = mark;
            at_work().as_mut().into_iter().for_each(|work| work.done = mark);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if was_obeyed() {
            clock::note_phase();
        }
        clear();
        *at_work() = self.before.take();
    }
}

fn at_work() -> MutexGuard<'static, Option<Work>> {
    WORK.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The label of the present phase.
pub fn phase() -> Option<String> {
    at_work().as_ref().map(|work| work.label.clone())
}

/// Draws the progress of the present phase, once it has lasted longer than `PATIENCE`.
pub fn draw() {
    let mut now = at_work();
    let Some(work) = now.as_mut().filter(|work| work.begun.elapsed() > PATIENCE && !is_quiet()) else { return };
    let (label, begun) = (&work.label, work.begun);
    let bar = work.bar.get_or_insert_with(|| {
        // indicatif draws on terminals only
        let bar = ProgressBar::with_draw_target(Some(MARKS), ProgressDrawTarget::stderr());
        bar.with_message(label.clone()).with_elapsed(begun.elapsed())
    });
    if let Ok(style) = ProgressStyle::with_template(if work.done > 0 { WITH_BAR } else { WITH_SECONDS }) {
        bar.set_style(style);
    }
    bar.set_position(work.done);
    bar.tick();
}

/// Removes the progress bar from the terminal until it is drawn again.
pub fn clear() {
    if let Some(bar) = at_work().as_mut().and_then(|work| work.bar.take()) {
        bar.finish_and_clear();
    }
}
