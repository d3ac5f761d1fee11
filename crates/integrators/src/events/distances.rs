//! Signals that are squares of distances, which may touch zero and rise again within one step.
//!
//! Values and rates at the ends of the step do not show such a zero. If |d'| <= c, the distance d has no zero in an
//! interval of the length h with d1 + d2 > c h at its ends.

use super::Instant;

/// If the change of a distance over an interval is bounded by this value, the signal at the ends is sufficient.
const LITTLE: f64 = 0.1;

/// If the bound `near` allows at most this change, the direction of motion hardly varies over the interval; then the
/// bounds `own` at both ends, times [`BETWEEN`], hold throughout.
const EVEN: f64 = 3.0;

/// The factor by which the rate may exceed the bounds `own` at the ends within such an interval.
const BETWEEN: f64 = 1.5;

/// Bounds of the rate of a distance, 1/s, in units in which the distance is of order one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pace {
    /// The bound near a state, for any direction of motion. Zero for a signal that is not the square of a distance.
    pub near: f64,
    /// The bound at the state, for its actual motion; at most `near`.
    pub own: f64,
}

impl Pace {
    /// A bound of the change of the distance over an interval of the length `length` (s), from the bounds of the rate
    /// at its ends.
    pub fn change([before, after]: [Pace; 2], length: f64) -> f64 {
        let near = length.abs() * before.near.max(after.near);
        let own = BETWEEN * length.abs() * before.own.max(after.own);
        if near <= EVEN { near.min(own) } else { near }
    }
}

/// Whether a signal is the square of a distance that is certainly nonzero between two instants.
pub(super) fn stays_off(ends: [&Instant; 2], signal: usize) -> bool {
    let most = most_change(ends, signal);
    let distance = |at: &Instant| at.signals[signal].value.max(0.0).sqrt();
    let [before, after] = ends;
    most > 0.0 && most < distance(before) + distance(after)
}

/// Whether any distance may touch zero between two instants undetected by the signals at the ends.
pub(super) fn are_open(before: &Instant, after: &Instant) -> bool {
    let ends = [before, after];
    (0..before.signals.len()).any(|signal| most_change(ends, signal) > LITTLE && !stays_off(ends, signal))
}

/// A bound of the change of a distance between two instants.
fn most_change(ends: [&Instant; 2], signal: usize) -> f64 {
    let [before, after] = ends;
    Pace::change(ends.map(|at| at.signals[signal].pace), after.time - before.time)
}
