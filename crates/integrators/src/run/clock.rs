//! The clock of the process: a deadline for all integrations, and the user's request to stop earlier.
//!
//! A command has several phases: a run, another with half the step, a transition matrix, a theory. The deadline holds
//! for all of them. The program sets it once, and every law that is evaluated through a budget checks it. It has no
//! effect in a library that never sets it.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::time::Instant;

use crate::Failure;

static DEADLINE: OnceLock<Instant> = OnceLock::new();
static ASKED: AtomicBool = AtomicBool::new(false);
static OBEYED: AtomicBool = AtomicBool::new(false);

/// The reason why all integrations must end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// The deadline of the process has passed.
    Time,
    /// The user requested the end.
    Interrupted,
}

impl Over {
    /// The failure of a run whose last valid state is at the time `at`.
    pub fn failure(self, at: f64) -> Failure {
        match self {
            Over::Time => Failure::OutOfTime { at },
            Over::Interrupted => Failure::Interrupted { at },
        }
    }
}

/// Sets the deadline of all integrations of the process. Only the first call has an effect.
pub fn set_deadline(deadline: Instant) {
    DEADLINE.get_or_init(|| deadline);
}

/// Requests the end of all integrations of the process.
pub fn request_end() {
    ASKED.store(true, Relaxed);
}

/// Whether the user requested the end. Costs one atomic load.
#[inline]
pub fn is_asked() -> bool {
    ASKED.load(Relaxed)
}

/// The reason why integrations must end; `None` if they may continue. A caller that gets a reason must stop its work.
pub fn over() -> Option<Over> {
    let over = match DEADLINE.get() {
        _ if is_asked() => Over::Interrupted,
        Some(end) if Instant::now() >= *end => Over::Time,
        _ => return None,
    };
    OBEYED.store(true, Relaxed);
    Some(over)
}

/// Whether [`over`] has returned a reason to any caller.
pub fn was_obeyed() -> bool {
    OBEYED.load(Relaxed)
}
