//! Convergence of Newton's iteration with a constant step: its end at rounding, and the renewal of its matrix.
//!
//! A constant step has no tolerance to hide an unfinished iteration in: it goes on until rounding stops it. The matrix is
//! kept while every correction is a hundredth of the last or less: each then costs an evaluation and gains two digits.

use crate::Real;
use crate::run::stepping::Cause;

/// Iterations after which the iteration has failed.
const MOST_ITERATIONS: u32 = 50;
/// The last correction, relative to the state, beyond which the iteration has not converged.
const CONVERGED: f64 = 1e-9;
/// A matrix is kept while each correction is at most this share of the one before it.
const PAYS: f64 = 0.01;

/// The corrections so far.
pub(crate) struct Newton {
    iterations: u32,
    last: f64,
    stale: bool,
}

impl Newton {
    pub fn new() -> Self {
        Newton { iterations: 0, last: f64::INFINITY, stale: true }
    }

    /// Whether the matrix should be that of the present iterate.
    pub fn wants_matrix(&self) -> bool {
        self.stale
    }

    /// Takes the size of a correction and that of the state; returns whether the iteration is at its end.
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
