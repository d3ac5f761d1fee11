//! Rounding errors measured by trials, used if running error bounds are too wide.
//!
//! A running error bound grows with every operation and ignores cancellation of errors. For example, the bound for the accelerations of
//! an arm of five links by symbolic elimination is larger than the accelerations, although these are accurate. In such cases the state is
//! perturbed several times by its rounding error, and the results are compared with those in double-double arithmetic.

use super::super::jet::{Jet, ROUNDING};
use super::{Expansions, ROUNDINGS};
use field::DoubleDouble;
use num_traits::Zero;

/// Error bounds above this part of the largest number, thousands of roundings, are tested by trials.
const FAR: f64 = 1e-12;

/// The number of perturbed states.
const TRIALS: usize = 3;

/// The accepted bound is this multiple of the largest error of the trials.
const MORE: f64 = 16.0;

impl Expansions {
    /// For each output of the compiled function, the fraction of its error bound that trials confirm; empty if all bounds are narrow.
    pub(super) fn confirmed(&self, time: f64, state: &[f64], letters: &[f64]) -> Vec<f64> {
        let uncertain = |value: f64| Jet::<1>::constant(value, ROUNDINGS * ROUNDING * value.abs());
        let moved: Vec<Jet<1>> = state.iter().map(|value| uncertain(*value)).collect();
        let fixed: Vec<Jet<1>> = letters.iter().map(|value| Jet::constant(*value, 0.0)).collect();
        let bounded = self.values(uncertain(time), &moved, &fixed, &[]);
        let largest = bounded.iter().map(|value| value.terms[0].abs()).fold(0.0, f64::max);
        if bounded.iter().all(|value| value.doubts[0] <= FAR * largest) {
            return Vec::new();
        }
        let constants = self.tape.constants::<DoubleDouble>();
        let computed = |trial: usize| {
            let mut found = vec![DoubleDouble::zero(); self.tape.outputs()];
            let place =
                |input: usize| ((input + 1) as f64 * 0.754_877_666 + trial as f64 * 0.569_840_291).fract() - 0.5;
            let by = |input: usize| if trial == 0 { 0.0 } else { (2.0 * ROUNDINGS * ROUNDING) * place(input) };
            let near =
                |(input, value): (usize, &f64)| DoubleDouble::from(*value) + DoubleDouble::from(value * by(input));
            let inputs = state.iter().chain([&time]).enumerate().map(near);
            let letters = letters.iter().map(|value| DoubleDouble::from(*value));
            self.tape.evaluate_long(&constants, inputs.chain(letters), &mut found);
            found
        };
        let exact = computed(0);
        let mut errors: Vec<f64> =
            bounded.iter().zip(&exact).map(|(value, exact)| (value.terms[0] - exact.hi()).abs()).collect();
        for trial in 1..=TRIALS {
            for ((error, near), exact) in errors.iter_mut().zip(computed(trial)).zip(&exact) {
                *error = error.max((near - *exact).hi().abs());
            }
        }
        let part = |(error, value): (f64, &Jet<1>)| {
            let part = MORE * error.max(ROUNDING * value.terms[0].abs()) / value.doubts[0];
            // NaN leaves the bound unchanged
            if part < 1.0 { part } else { 1.0 }
        };
        errors.into_iter().zip(&bounded).map(part).collect()
    }
}
