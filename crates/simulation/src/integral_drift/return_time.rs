//! The period of a motion: the first time at which it returns to its initial state.

use super::MotionWithIntegrals;
use integrators::{Failure, Observer};

/// The motion has returned if each component differs from the start by at most this fraction of its size.
const RETURNED: f64 = 1e-7;

/// The largest number of Newton steps for a crossing.
const NEWTON: usize = 12;

/// The difference of a component (by index) at the end and at the start; for an angle, modulo whole turns.
pub type Gap<'a> = dyn Fn(usize, f64, f64) -> f64 + 'a;

/// The result of the search for a period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Returns {
    /// The motion has this period, s.
    After(f64),
    /// The motion does not return within the span.
    Not,
    /// The motion is an equilibrium.
    Rests,
}

/// The states at the ends of the steps of a run.
#[derive(Default)]
struct Steps(Vec<(f64, Vec<f64>)>);

impl Observer<f64> for Steps {
    fn step(&mut self, time: f64, state: &[f64]) {
        self.0.push((time, state.to_vec()));
    }
}

/// The first return of a motion within a span (s); `gap` compares components.
///
/// Where the motion crosses the plane through the start, normal to the rates there, in the direction of these rates,
/// the time of the crossing is located by Newton's method, and the state is compared with the start.
///
/// # Errors
/// [`Failure`] where the run ends before.
pub fn return_time(motion: &MotionWithIntegrals<'_>, span: f64, gap: &Gap<'_>) -> Result<Returns, Failure> {
    let (n, start) = (motion.start.len(), motion.start);
    let mut rates = vec![0.0; n];
    motion.law.rates(0.0, start, &mut rates);
    let mut steps = Steps::default();
    motion.exactly((0.0, span), start, &[span], &mut steps)?;
    let mut sizes = vec![0.0_f64; n];
    for (_, state) in &steps.0 {
        for k in 0..n {
            sizes[k] = sizes[k].max(gap(k, state[k], start[k]).abs());
        }
    }
    let moves = |k: &usize| sizes[*k] > 0.0 && sizes[*k] > 1e-12 * (1.0 + start[*k].abs());
    let moving: Vec<usize> = (0..n).filter(moves).collect();
    if moving.is_empty() {
        return Ok(Returns::Rests);
    }
    // rates and differences relative to the sizes
    let ahead = |state: &[f64]| -> f64 {
        moving.iter().map(|&k| gap(k, state[k], start[k]) * rates[k] / (sizes[k] * sizes[k])).sum()
    };
    let apart = |state: &[f64]| moving.iter().map(|&k| gap(k, state[k], start[k]).abs() / sizes[k]).fold(0.0, f64::max);
    for pair in steps.0.windows(2) {
        let [(from, before), (to, after)] = pair else { continue };
        if !(ahead(before) < 0.0 && ahead(after) >= 0.0) {
            continue;
        }
        let (mut at, mut state) = (*from, before.clone());
        let mut slopes = vec![0.0; n];
        for _ in 0..NEWTON {
            motion.law.rates(at, &state, &mut slopes);
            let slope: f64 = moving.iter().map(|&k| slopes[k] * rates[k] / (sizes[k] * sizes[k])).sum();
            let next = at - ahead(&state) / slope;
            if !(*from..=*to).contains(&next) || next == at {
                break;
            }
            state = motion.exactly((at, next), &state, &[next], &mut ())?;
            at = next;
        }
        if apart(&state) < RETURNED {
            return Ok(Returns::After(at));
        }
    }
    Ok(Returns::Not)
}
