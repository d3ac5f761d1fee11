//! The drift of an integral by backward error analysis: from single steps that begin at points of the exact motion.

use super::{MotionWithIntegrals, Window};
use integrators::{Failure, Method, Span, Tolerance, integrate};
use std::ops::ControlFlow;

/// The predicted drift over a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drift {
    /// The change over a window, in the unit of the integral.
    Of(f64),
    /// No drift in the terms of order h^p and h^(p+1): the integral oscillates.
    None,
    /// The drift is smaller than this rounding error.
    Rounding(f64),
}

/// The predicted drift and swing of an integral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expected {
    pub drift: Drift,
    /// The largest minus the smallest value along the window, including the drift.
    pub swing: f64,
}

/// Numbers of points on the motion, in turn, until two results agree.
const POINTS: [usize; 4] = [128, 256, 512, 1024];

/// The relative difference of drifts or swings up to which two results agree.
const AGREE: f64 = 2e-3;

/// The error of the change of an integral over one step, in units in the last place.
const ULPS: f64 = 4.0;

/// Exponents of h above 2p less this margin count as 2p.
const BETWEEN: f64 = 0.5;

/// The drift of every integral for a method with equal steps, whose number per window is an integer. Rounding is
/// relative to `sizes`, one for each integral. `None` where `goes_on` ended the computation.
///
/// # Errors
/// [`Failure`] where the exact motion, or a step, fails.
pub fn expected(
    motion: &MotionWithIntegrals<'_>,
    method: Method,
    window: Window,
    sizes: &[f64],
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Option<Vec<Expected>>, Failure> {
    let (steps, order) = (f64::from(method.steps().unwrap_or(1)), method.traits().order.unwrap_or(1));
    let h = window.length() / steps;
    let mut last: Option<Vec<[f64; 2]>> = None;
    for points in POINTS {
        let Some(coarse) = defects(motion, method, (window, points, h), goes_on)? else { return Ok(None) };
        let agrees = last.as_ref().is_some_and(|last| {
            last.iter().zip(&coarse).all(|(a, b)| (a[0] - b[0]).abs() <= AGREE * b[0].abs().max(1e-3 * b[1]))
        });
        if !agrees && points < POINTS[POINTS.len() - 1] {
            last = Some(coarse);
            continue;
        }
        let Some(fine) = defects(motion, method, (window, points, 0.5 * h), goes_on)? else { return Ok(None) };
        let of = |((size, coarse), fine): ((&f64, &[f64; 2]), &[f64; 2])| {
            let noise = |steps: f64| ULPS * f64::EPSILON * size * steps / (points as f64).sqrt();
            let [drift, swing] = *coarse;
            let power = (drift.abs() / fine[0].abs().max(noise(2.0 * steps))).log2();
            let drift = match window {
                _ if drift.abs() <= 4.0 * noise(steps) => Drift::Rounding(4.0 * noise(steps)),
                Window::Period(_) if power >= f64::from(2 * order) - BETWEEN => Drift::None,
                _ => Drift::Of(drift),
            };
            Expected { drift, swing }
        };
        return Ok(Some(sizes.iter().zip(&coarse).zip(&fine).map(of).collect()));
    }
    Ok(None)
}

/// The drift of each integral over a window, and the difference between the largest and the smallest partial sum.
fn defects(
    motion: &MotionWithIntegrals<'_>,
    method: Method,
    (window, points, h): (Window, usize, f64),
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Option<Vec<[f64; 2]>>, Failure> {
    let length = window.length();
    let times: Vec<f64> = (1..=points).map(|k| length * (k as f64 / points as f64)).collect();
    let states = motion.states(&times)?;
    let share = length / points as f64 / h;
    let mut sums = vec![[0.0_f64; 3]; motion.integrals.len()];
    let begin = (0.0, motion.start.to_vec());
    // over a period the rectangle rule converges exponentially
    for (time, state) in std::iter::once(begin).chain(times.into_iter().zip(states)).take(points) {
        if goes_on().is_break() {
            return Ok(None);
        }
        let span = Span::new(time, time + h, &state);
        let outcome = integrate(motion.law, method.once(), &Tolerance::both(1e-10), &span, &mut ());
        if let Some(failure) = outcome.failure() {
            return Err(failure);
        }
        for (integral, [sum, least, most]) in motion.integrals.iter().zip(&mut sums) {
            let change = (integral.value)(time + h, &outcome.state) - (integral.value)(time, &state);
            *sum += share * change;
            *least = least.min(*sum);
            *most = most.max(*sum);
        }
    }
    Ok(Some(sums.into_iter().map(|[sum, least, most]| [sum, most - least]).collect()))
}
