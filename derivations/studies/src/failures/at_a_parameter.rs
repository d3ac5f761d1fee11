//! Newton's method for the unknown x of a curve F(x, p) = 0 at a fixed p.
//!
//! At a fold of the curve the divisor F_x of the method vanishes; beyond the fold there is no solution. The
//! continuation [`integrators::continue_branch`] along the curve is regular there.

use integrators::Curve;
use std::fmt;

/// Newton's method did not converge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotConverged {
    pub iterations: u32,
    /// The last x, and F there.
    pub last: f64,
    pub missing: f64,
}

impl fmt::Display for NotConverged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { iterations, last, missing } = self;
        write!(
            f,
            "Newton did not converge in {iterations} iterations: at {last:.3} there is still {missing:.1e} left over"
        )
    }
}

/// The largest number of iterations.
const MOST: u32 = 100;
/// Corrections below this, relative to max(|x|, 1), are rounding.
const SETTLED: f64 = 1e-12;

/// The x of a plane curve at a fixed p, by Newton's method from an initial value.
///
/// # Errors
/// [`NotConverged`] after the largest number of iterations.
pub fn newton(curve: &mut dyn Curve, mut x: f64, p: f64) -> Result<f64, NotConverged> {
    let (mut residual, mut slopes) = ([f64::INFINITY], [0.0; 2]);
    for iterations in 1..=MOST {
        let defined = curve.evaluate(&[x, p], &mut residual, &mut slopes).is_ok();
        let step = residual[0] / slopes[0];
        if !(defined && step.is_finite()) {
            return Err(NotConverged { iterations, last: x, missing: residual[0] });
        }
        x -= step;
        if step.abs() <= SETTLED * x.abs().max(1.0) {
            return Ok(x);
        }
    }
    Err(NotConverged { iterations: MOST, last: x, missing: residual[0] })
}
