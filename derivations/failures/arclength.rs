//! A curve F(x, p) = 0 in the plane, followed along its own length; and Newton's method at a fixed p.
//!
//! Where x turns back in p (a fold) F_x vanishes: Newton's method at a fixed p divides by it, and beyond the fold there is no x
//! to be found. Along the curve nothing is singular there: the tangent (-F_p, F_x) is defined wherever the gradient is.

use field::Tangent;
use std::fmt;

/// F over numbers that carry a slope.
pub trait Curve {
    fn value(&self, x: Tangent<f64>, p: Tangent<f64>) -> Tangent<f64>;

    /// F, F_x, F_p.
    fn parts(&self, [x, p]: [f64; 2]) -> [f64; 3] {
        let by_x = self.value(Tangent::variable(x), Tangent::fixed(p));
        [by_x.value, by_x.slope, self.value(Tangent::fixed(x), Tangent::variable(p)).slope]
    }
}

/// Newton's method came to no end.
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

/// Iterations after which Newton's method counts as lost.
const MOST: u32 = 100;
/// A correction that is rounding.
const SETTLED: f64 = 1e-12;

/// x at a fixed p, with the number of iterations.
///
/// # Errors
/// [`NotConverged`].
pub fn newton(curve: &impl Curve, mut x: f64, p: f64) -> Result<(f64, u32), NotConverged> {
    let mut missing = f64::INFINITY;
    for iterations in 1..=MOST {
        let [value, slope, _] = curve.parts([x, p]);
        let step = value / slope;
        missing = value;
        if !step.is_finite() {
            return Err(NotConverged { iterations, last: x, missing });
        }
        x -= step;
        if step.abs() <= SETTLED * x.abs().max(1.0) {
            return Ok((x, iterations));
        }
    }
    Err(NotConverged { iterations: MOST, last: x, missing })
}

/// The first fold in p from a point of the curve on, where p grows at first; and a point of the other branch behind it.
pub fn round_the_fold(curve: &impl Curve, start: [f64; 2], length: f64, most: u32) -> Option<([f64; 2], [f64; 2])> {
    let mut at = start;
    let mut way = tangent(curve, at, [0.0, 1.0])?;
    for _ in 0..most {
        let next = step(curve, at, way, length)?;
        let turned = tangent(curve, next, way)?;
        if way[1] > 0.0 && turned[1] <= 0.0 {
            return Some((fold(curve, at, way, length)?, next));
        }
        (at, way) = (next, turned);
    }
    None
}

/// The unit tangent on the side of another.
fn tangent(curve: &impl Curve, at: [f64; 2], like: [f64; 2]) -> Option<[f64; 2]> {
    let [_, by_x, by_p] = curve.parts(at);
    let size = by_x.hypot(by_p);
    let side = if by_x * like[1] - by_p * like[0] < 0.0 { -size } else { size };
    (size.is_finite() && size > 0.0).then(|| [-by_p / side, by_x / side])
}

/// The point of the curve across from at + length way: Newton's method on F = 0 and (z - at).way = length.
fn step(curve: &impl Curve, at: [f64; 2], way: [f64; 2], length: f64) -> Option<[f64; 2]> {
    let mut z = [at[0] + length * way[0], at[1] + length * way[1]];
    for _ in 0..MOST {
        let [value, by_x, by_p] = curve.parts(z);
        let ahead = (z[0] - at[0]) * way[0] + (z[1] - at[1]) * way[1] - length;
        let determinant = by_x * way[1] - by_p * way[0];
        let correction = [(value * way[1] - by_p * ahead) / determinant, (by_x * ahead - value * way[0]) / determinant];
        if !correction.iter().all(|c| c.is_finite()) {
            return None;
        }
        z = [z[0] - correction[0], z[1] - correction[1]];
        if correction[0].hypot(correction[1]) <= SETTLED {
            return Some(z);
        }
    }
    None
}

/// Between a point and the next one, where the tangent has no part along p.
fn fold(curve: &impl Curve, at: [f64; 2], way: [f64; 2], length: f64) -> Option<[f64; 2]> {
    let (mut before, mut behind) = (0.0, length);
    for _ in 0..60 {
        let middle = 0.5 * (before + behind);
        let there = step(curve, at, way, middle)?;
        if tangent(curve, there, way)?[1] > 0.0 { before = middle } else { behind = middle }
    }
    step(curve, at, way, before)
}
