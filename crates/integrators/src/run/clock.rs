//! The clock of the process: the time at which every integration ends, and the user's request to end earlier.
//!
//! A command is made of phases: a run, a second one with half the step, a transition matrix, a theory. A deadline handed to
//! each phase would be counted anew by one of them, or forgotten. This one is set once, by the program, and every law that
//! is evaluated through a budget reads it. A library that never sets it is not affected.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::time::Instant;

use crate::Failure;

static DEADLINE: OnceLock<Instant> = OnceLock::new();
static ASKED: AtomicBool = AtomicBool::new(false);
static OBEYED: AtomicBool = AtomicBool::new(false);

/// Why integrations end now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// The deadline of the process has passed.
    Time,
    /// The user asked for the end.
    Interrupted,
}

impl Over {
    /// The failure of a run whose last good state is at this time.
    pub fn failure(self, at: f64) -> Failure {
        match self {
            Over::Time => Failure::OutOfTime { at },
            Over::Interrupted => Failure::Interrupted { at },
        }
    }
}

/// Sets the time at which every integration of the process ends. Only the first call has an effect.
pub fn set_deadline(deadline: Instant) {
    DEADLINE.get_or_init(|| deadline);
}

/// Every integration of the process ends now.
pub fn request_end() {
    ASKED.store(true, Relaxed);
}

/// Whether the user asked for the end: one load.
#[inline]
pub fn is_asked() -> bool {
    ASKED.load(Relaxed)
}

/// Whether integrations are to end, and why. A caller that gets a reason stops its work.
pub fn over() -> Option<Over> {
    let over = match DEADLINE.get() {
        _ if is_asked() => Over::Interrupted,
        Some(end) if Instant::now() >= *end => Over::Time,
        _ => return None,
    };
    OBEYED.store(true, Relaxed);
    Some(over)
}

/// Whether anything was broken off by [`over`].
pub fn was_obeyed() -> bool {
    OBEYED.load(Relaxed)
}
