//! The limit of time of a computation in a process of its own.

use pyo3::prelude::*;
use std::time::{Duration, Instant};

/// A computation ends so long before its time is over, so that its results can be handed on.
const KEPT: Duration = Duration::from_millis(400);

/// The moment at which a computation that has so many seconds must end, in a year at the latest.
pub fn end_after(seconds: f64) -> Instant {
    let given = Duration::try_from_secs_f64(seconds).unwrap_or_default().min(Duration::from_secs(366 * 86_400));
    Instant::now() + given.saturating_sub(KEPT)
}

/// The time up to a moment.
pub fn left(end: Instant) -> Duration {
    end.saturating_duration_since(Instant::now())
}

/// Ends every run of this process after so many seconds: for processes that do one thing.
#[pyfunction]
pub fn end_process_after(seconds: f64) {
    dalembert::integrators::clock::set_deadline(end_after(seconds));
}
