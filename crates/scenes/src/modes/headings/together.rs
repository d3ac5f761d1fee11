//! Directions of several contacts that begin to slide at one instant, by Newton's method from a few starting values.
//!
//! The starting values are translations of the body, and the directions opposite to the friction that would hold the body. Further solutions
//! are not excluded.

use super::super::mode::Heading;
use super::{Slip, exact};
use field::Elementary;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The number of translations as starting values.
const TRIED: usize = 8;

/// Steps of Newton's method, and halvings of one.
const STEPS: usize = 30;
const HALVINGS: usize = 6;

/// The difference of angles for a numerical derivative.
const DIFFERENCE: f64 = 1e-6;

/// The largest step.
const FURTHEST: f64 = 1.0;

/// An angle between direction and acceleration that is rounding, and one that counts as a solution when steps no longer improve it.
const NONE: f64 = 1e-15;
const SMALL: f64 = 1e-9;

/// Two solutions closer than this are one.
const SAME: f64 = 1e-6;

impl Slip<'_> {
    /// Directions that agree with the accelerations of their own slips; those opposite to friction are starting values too, if it can hold the body.
    pub(super) fn of_several(&self, against_friction: Option<Vec<Heading>>) -> Vec<Vec<Heading>> {
        // not at multiples of a right angle, along which a slip often begins
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

    /// The angles from directions to the accelerations that they cause.
    fn off(&self, angles: &[f64]) -> Option<DVector<f64>> {
        let headings: Vec<Heading> = angles.iter().copied().map(exact).collect();
        let parts = self.accelerations(&headings)?;
        Some(DVector::from_iterator(
            parts.len(),
            parts.iter().map(|[across, along]| Elementary::Atan2.of(*across, *along)),
        ))
    }

    /// Directions that agree with their own accelerations, from starting values.
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

/// An angle reduced to the range from minus half a turn to half a turn.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
