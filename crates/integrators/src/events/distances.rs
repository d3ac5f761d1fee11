//! Signals that are the square of a distance, which may come down to zero and rise again in less than a step.
//!
//! Values and rates at the ends of the step do not show it. With |d'| <= c the distance d is not zero over an interval of the length
//! h at whose ends d1 + d2 > c h.

use super::Instant;

/// The change of a distance over an interval below which its ends decide.
const LITTLE: f64 = 0.1;

/// The change by the bound near the states, up to which the motion hardly turns over an interval: then its own bounds at both ends hold
/// between them, but for a factor.
const EVEN: f64 = 3.0;

/// The factor by which the own bounds at the ends of such an interval may be exceeded within.
const BETWEEN: f64 = 1.5;

/// Bounds of the rate of a distance of the order of one, 1/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pace {
    /// Near a state, in any direction of the motion. Zero for a signal that is no such distance.
    pub near: f64,
    /// At the state itself, along its motion; at most `near`.
    pub own: f64,
}

impl Pace {
    /// A bound of the change of the distance over an interval of this length, at whose ends these are the bounds of its rate.
    pub fn change([before, after]: [Pace; 2], length: f64) -> f64 {
        let near = length.abs() * before.near.max(after.near);
        let own = BETWEEN * length.abs() * before.own.max(after.own);
        if near <= EVEN { near.min(own) } else { near }
    }
}

/// Whether a signal is such a distance, and not zero between two instants.
pub(super) fn stays_off(ends: [&Instant; 2], signal: usize) -> bool {
    let most = most_change(ends, signal);
    let distance = |at: &Instant| at.signals[signal].value.max(0.0).sqrt();
    let [before, after] = ends;
    most > 0.0 && most < distance(before) + distance(after)
}

/// Whether some distance may come to zero between two instants without a sign of it at the ends.
pub(super) fn are_open(before: &Instant, after: &Instant) -> bool {
    let ends = [before, after];
    (0..before.signals.len()).any(|signal| most_change(ends, signal) > LITTLE && !stays_off(ends, signal))
}

/// The bound of the change of a distance between two instants.
fn most_change(ends: [&Instant; 2], signal: usize) -> f64 {
    let [before, after] = ends;
    Pace::change(ends.map(|at| at.signals[signal].pace), after.time - before.time)
}
