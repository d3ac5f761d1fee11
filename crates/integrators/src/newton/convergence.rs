//! Convergence of Newton's iteration for methods with a constant step.
//!
//! A constant step has no tolerance: the iteration continues until rounding stops its progress. The matrix is reused
//! while every correction is at most a hundredth of the last one, so that each evaluation gains two digits.

use crate::Real;
use crate::run::stepping::Cause;

/// The iteration fails after this many corrections.
const MOST_ITERATIONS: u32 = 50;
/// The iteration has not converged if its last correction, relative to the state, is larger than this.
const CONVERGED: f64 = 1e-9;
/// The matrix is reused while each correction is at most this fraction of the one before.
const PAYS: f64 = 0.01;

/// The state of an iteration.
pub(crate) struct Newton {
    iterations: u32,
    last: f64,
    stale: bool,
}

impl Newton {
    pub fn new() -> Self {
        Newton { iterations: 0, last: f64::INFINITY, stale: true }
    }

    /// Whether the matrix should be computed at the present iterate.
    pub fn wants_matrix(&self) -> bool {
        self.stale
    }

    /// Records the size of a correction and that of the state. Returns whether the iteration has converged.
    pub fn corrected<S: Real>(&mut self, size: f64, scale: f64) -> Result<bool, Cause> {
        let scale = scale.max(f64::MIN_POSITIVE);
        if !(size / scale).is_finite() {
            return Err(Cause::Undefined);
        }
        self.iterations += 1;
        if size <= S::EPSILON * scale || (size >= 0.5 * self.last && self.last <= CONVERGED * scale) {
            return Ok(true);
        }
        if self.iterations == MOST_ITERATIONS {
            return Err(Cause::Newton);
        }
        self.stale = size > PAYS * self.last || self.iterations == 1 && size > PAYS * scale;
        self.last = size;
        Ok(false)
    }
}
