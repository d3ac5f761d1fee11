//! Check that a law is periodic: its change over one period is compared with its changes within the period.

use super::{Linearisation, VariedEquations};
use nalgebra::DMatrix;

/// Phases of the period, and parts of the run, at which a law is compared.
const PHASES: [f64; 5] = [0.0, 0.21, 0.43, 0.68, 0.9];

/// Parts of the period after a phase at which a law that changes with time has changed.
const WITHIN: [f64; 3] = [0.29, 0.5, 0.71];

/// Parts of the size of a law that are rounding.
const ROUNDING: f64 = 1e-11;

/// The part of its changes within a period by which a law may be another one a period later: periods are given to seven digits.
const DIGITS: f64 = 1e-4;

/// Changes within a period are this many times rounding, at least.
const TOLD: f64 = 100.0;

/// The law of a state a period later.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Recurrence {
    /// It is the same at each phase.
    Returns,
    Differs,
    /// It changes with time, but hardly within the period.
    Hidden,
}

impl Recurrence {
    /// The return of the linear equations and the accelerations of a state over a period, in a run of some length.
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
