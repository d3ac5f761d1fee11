//! Check that a law is periodic in time: its change over a period is compared with its changes within the period.

use super::{Linearisation, VariedEquations};
use nalgebra::DMatrix;

/// Fractions of the period, and of the run, at which the law is evaluated.
const PHASES: [f64; 5] = [0.0, 0.21, 0.43, 0.68, 0.9];

/// Fractions of the period after each such time at which the change of the law is measured.
const WITHIN: [f64; 3] = [0.29, 0.5, 0.71];

/// Changes below this part of the size of a law are rounding errors.
const ROUNDING: f64 = 1e-11;

/// The largest change over a period, relative to the changes within it, of a periodic law: periods may be given with seven digits.
const DIGITS: f64 = 1e-4;

/// Changes within a period must exceed this multiple of the rounding error.
const TOLD: f64 = 100.0;

/// The comparison of the law with the law a period later.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Recurrence {
    /// The laws are equal.
    Returns,
    /// The laws differ.
    Differs,
    /// The law changes with time, but too little within the period for a comparison.
    Hidden,
}

impl Recurrence {
    /// Compares linear equations and accelerations at a fixed state over a period (s), in a run of length `span` (s).
    pub fn of(equations: &VariedEquations, about: &Linearisation, state: &[f64], (period, span): (f64, f64)) -> Self {
        let law = |time: f64| -> Option<(DMatrix<f64>, DMatrix<f64>)> {
            let found = equations.linearised(equations.point(time, state)).ok()?;
            let is_alike = found.coordinates == about.coordinates && found.speeds == about.speeds;
            let accelerations =
                DMatrix::from_column_slice(found.point.accelerations.len(), 1, found.point.accelerations.as_slice());
            is_alike.then_some((found.a, accelerations))
        };
        let size = 1.0 + about.a.amax().max(about.point.accelerations.amax());
        let gap = |one: f64, other: f64| match (law(one), law(other)) {
            (Some(one), Some(other)) => (one.0 - other.0).amax().max((one.1 - other.1).amax()),
            _ => 0.0,
        };
        let (mut missed, mut within, mut across) = (0.0_f64, 0.0_f64, 0.0_f64);
        for time in PHASES.iter().flat_map(|phase| [phase * period, phase * span]) {
            missed = missed.max(gap(time, time + period));
            across = across.max(gap(0.0, time));
            within = WITHIN.iter().fold(within, |most, part| most.max(gap(time, time + part * period)));
        }
        let rounding = ROUNDING * size;
        match () {
            () if across.max(within) > TOLD * rounding && within <= TOLD * rounding => Recurrence::Hidden,
            () if missed > rounding + DIGITS * within => Recurrence::Differs,
            () => Recurrence::Returns,
        }
    }
}
