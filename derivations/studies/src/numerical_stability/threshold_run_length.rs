//! The length of a run that distinguishes a step size just below a stability threshold from one just above it.
//!
//! At the threshold the multiplier of one mode is on the unit circle. At a relative distance e from the threshold this
//! mode grows or decays by d = e |d ln|R|/d ln h| per step; the slowest other mode decays by b. Runs begin along the
//! mode, where the others are no larger. A run of N steps shows the mode if
//!
//!   d exp(d N) > b exp(-b N) :   N > ln(b/d)/(b + d) ,
//!
//! and two adjacent intervals of N/10 steps differ by more than the error of sampled maxima, a few parts in a thousand,
//! if d N/10 and b N/10 are above a hundredth. If this takes too many steps no run is made.

use super::methods::OneStep;
use mechanics::one_step_stability::Spectrum;

/// The growth and decay of a motion's modes per step at a threshold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The derivative |d ln|R|/d ln h| of the mode that crosses the unit circle.
    pub steepness: f64,
    /// The decrease per step of the logarithm of the slowest other mode.
    pub rest: f64,
}

/// The relative change from one interval of a run to the next that is significant.
pub const SHOWN: f64 = 0.01;
/// The shortest and the longest run, in steps.
const FEWEST: f64 = 400.0;
const MOST: f64 = 40_000.0;

impl Crossing {
    /// The crossing of a Runge-Kutta method at a step that is a threshold for one mode; `None` without a stability function.
    pub fn of(method: OneStep, spectrum: &Spectrum, step: f64) -> Option<Self> {
        let function = method.function()?;
        let mut all: Vec<(f64, f64)> = spectrum
            .modes
            .iter()
            .map(|mode| {
                let [re, im] = mode.place.point();
                function.growth([step * re, step * im])
            })
            .collect();
        all.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        let ((_, slope), others) = all.split_first()?;
        let rest = others.iter().map(|(growth, _)| -growth).fold(f64::INFINITY, f64::min);
        Some(Crossing { steepness: slope.abs(), rest })
    }

    /// The number of steps of a run that resolves a relative distance `apart` from the threshold; `None` where it would
    /// be too long, or another mode does not decay.
    pub fn steps(&self, apart: f64) -> Option<usize> {
        let (growth, rest) = (apart * self.steepness, self.rest);
        if !(growth > 0.0 && rest > 0.0) {
            return None;
        }
        // zero where there is no other mode
        let slower = if rest.is_finite() { (rest / growth).ln() / (rest + growth) } else { 0.0 };
        let steps = slower.max(SHOWN / growth * INTERVALS).max(SHOWN / rest * INTERVALS).max(FEWEST);
        (steps <= MOST).then_some(steps.ceil() as usize)
    }
}

/// The number of intervals into which a run is divided.
pub const INTERVALS: f64 = 10.0;

#[cfg(test)]
mod tests {
    use super::Crossing;

    /// Computed by hand: d = 1e-4; d = 1e-4 and b = e d, with 1/(b + d); the shortest run.
    #[test]
    fn a_run_is_as_long_as_the_slower_of_growth_and_rest_asks() {
        let steps = |steepness, rest| Crossing { steepness, rest }.steps(1e-3);
        assert_eq!(steps(0.1, 0.5), Some(1000));
        assert_eq!(steps(0.1, 1e-4 * std::f64::consts::E), Some(2690));
        assert_eq!(steps(1.0, f64::INFINITY), Some(400));
        assert_eq!((steps(1e-6, 0.5), steps(1.0, 0.0), steps(1.0, 1e-9)), (None, None, None));
    }
}
