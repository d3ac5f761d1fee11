//! Directions of several contacts that begin to slide at one instant, by Newton's method from several starting values.
//!
//! The starting values are translations of the body, and the directions opposite to the friction that would hold the body. Further
//! solutions are not excluded.

use super::super::mode::Heading;
use super::{Slip, exact};
use field::Elementary;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The number of translations used as starting values.
const TRIED: usize = 8;

/// The largest number of Newton steps, and of halvings of one step.
const STEPS: usize = 30;
const HALVINGS: usize = 6;

/// The difference of angles, rad, for a numerical derivative.
const DIFFERENCE: f64 = 1e-6;

/// The largest step, rad.
const FURTHEST: f64 = 1.0;

/// Angles between direction and acceleration, rad: below the first the iteration ends; below the second the result counts as a solution.
const NONE: f64 = 1e-15;
const SMALL: f64 = 1e-9;

/// Solutions whose angles differ by less, rad, are equal.
const SAME: f64 = 1e-6;

impl Slip<'_> {
    /// Directions in which the acceleration of each slip is parallel to its direction. The directions opposite to friction are starting
    /// values too, if friction can hold the body.
    pub(super) fn of_several(&self, against_friction: Option<Vec<Heading>>) -> Vec<Vec<Heading>> {
        // avoids multiples of a right angle, which are often exact directions of slip
        let translations =
            (0..TRIED).map(|place| vec![(place as f64 - 0.382) * TAU / TRIED as f64; self.beginning.len()]);
        let against = against_friction.map(|headings| headings.into_iter().map(Heading::angle).collect());
        let mut found: Vec<Vec<f64>> = Vec::new();
        for start in against.into_iter().chain(translations) {
            let Some(angles) = self.own(start) else { continue };
            if found.iter().all(|known| known.iter().zip(&angles).any(|(a, b)| wrapped(a - b).abs() > SAME)) {
                found.push(angles);
            }
        }
        found.into_iter().map(|angles| angles.into_iter().map(exact).collect()).collect()
    }

    /// The angles from the directions to the accelerations that they cause, rad.
    fn off(&self, angles: &[f64]) -> Option<DVector<f64>> {
        let headings: Vec<Heading> = angles.iter().copied().map(exact).collect();
        let parts = self.accelerations(&headings)?;
        Some(DVector::from_iterator(
            parts.len(),
            parts.iter().map(|[across, along]| Elementary::Atan2.of(*across, *along)),
        ))
    }

    /// The angles of directions parallel to their accelerations, from a starting value; `None` if the iteration does not converge.
    fn own(&self, mut angles: Vec<f64>) -> Option<Vec<f64>> {
        let moved = |angles: &[f64], by: &DVector<f64>| -> Vec<f64> {
            angles.iter().zip(by.iter()).map(|(angle, by)| wrapped(angle + by)).collect()
        };
        let mut off = self.off(&angles)?;
        for _ in 0..STEPS {
            if off.amax() <= NONE {
                break;
            }
            let mut slopes = DMatrix::zeros(angles.len(), angles.len());
            for own in 0..angles.len() {
                let mut beside = angles.clone();
                beside[own] += DIFFERENCE;
                let changed = self.off(&beside)? - &off;
                slopes.set_column(own, &changed.map(|part| wrapped(part) / DIFFERENCE));
            }
            let mut step = slopes.lu().solve(&-&off)?;
            step *= (FURTHEST / step.amax()).min(1.0);
            let shorter = (0..HALVINGS).find_map(|halvings| {
                let trial = moved(&angles, &(&step * 0.5_f64.powi(halvings as i32)));
                let trial_off = self.off(&trial)?;
                (trial_off.norm() < off.norm()).then_some((trial, trial_off))
            });
            let Some(better) = shorter else { break };
            (angles, off) = better;
        }
        (off.amax() <= SMALL).then_some(angles)
    }
}

/// An angle reduced to the range from -pi to pi.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
