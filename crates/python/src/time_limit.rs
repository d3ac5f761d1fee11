//! The time limit of a computation in a separate process.

use pyo3::prelude::*;
use std::time::{Duration, Instant};

/// The time before the limit at which a computation ends, so that its results can be sent.
const KEPT: Duration = Duration::from_millis(400);

/// The instant at which a computation with a time limit in seconds must end; in a year at the latest.
pub fn end_after(seconds: f64) -> Instant {
    let given = Duration::try_from_secs_f64(seconds).unwrap_or_default().min(Duration::from_secs(366 * 86_400));
    Instant::now() + given.saturating_sub(KEPT)
}

/// The time until an instant; zero after it.
pub fn left(end: Instant) -> Duration {
    end.saturating_duration_since(Instant::now())
}

/// Ends all runs of this process after a time in seconds; for processes with a single task.
#[pyfunction]
pub fn end_process_after(seconds: f64) {
    dalembert::integrators::clock::set_deadline(end_after(seconds));
}
