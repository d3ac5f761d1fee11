//! The period of a motion: the first time at which the state is that of the start.

use super::MotionWithIntegrals;
use integrators::{Failure, Observer};

/// The distance from the start, each component relative to its size along the motion, within which a state has returned.
const RETURNED: f64 = 1e-7;

/// The most Newton steps to a crossing.
const NEWTON: usize = 12;

/// The difference of a component at the end and at the start, modulo whole turns of an angle.
pub type Gap<'a> = dyn Fn(usize, f64, f64) -> f64 + 'a;

/// Whether a motion returns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Returns {
    /// After this time, s.
    After(f64),
    /// The motion does not return within the span.
    Not,
    /// The motion is a rest.
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

/// The first return of a motion within a span; `gap` compares components.
///
/// Where the motion crosses the plane through the start across its rates there, from behind, the time of the crossing is found by Newton's
/// method, and the state is compared with the start.
///
/// # Errors
/// Why the run ended before.
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
    // rates and gaps in parts of the sizes
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
