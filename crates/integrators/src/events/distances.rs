//! Signals that are the square of a distance, which may come down to zero and rise again in less than a step.
//!
//! Values and rates at the ends of the step do not show it. With |d'| <= c the distance d is not zero over an interval of the length
//! h at whose ends d1 + d2 > c h.

use super::Instant;

/// The change of a distance over an interval below which its ends decide.
const LITTLE: f64 = 0.1;

/// Whether a signal is such a distance, and not zero between two instants.
pub(super) fn stays_off([before, after]: [&Instant; 2], signal: usize) -> bool {
    let most = most_change([before, after], signal);
    let distance = |at: &Instant| at.signals[signal].value.max(0.0).sqrt();
    most > 0.0 && most < distance(before) + distance(after)
}

/// Whether some distance may come to zero between two instants without a sign of it at the ends.
pub(super) fn are_open(before: &Instant, after: &Instant) -> bool {
    let ends = [before, after];
    (0..before.signals.len()).any(|signal| most_change(ends, signal) > LITTLE && !stays_off(ends, signal))
}

/// The bound of the change of a distance between two instants.
fn most_change([before, after]: [&Instant; 2], signal: usize) -> f64 {
    let fastest = |at: &Instant| at.signals[signal].fastest;
    (after.time - before.time).abs() * fastest(before).max(fastest(after))
}
