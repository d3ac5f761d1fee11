//! Points at which the coordinates are singular, as the pole of spherical angles: the mass matrix is singular there, and no equation of motion
//! in these coordinates describes the system nearby.

use super::equations::{At, Point, VariedEquations};
use crate::steady_motions::without_inertia;
use nalgebra::{DMatrix, DVector};

/// A mass matrix whose scaled eigenvalues, or whose inertias relative to each other, are above this is far from singular.
const SUSPICIOUS: f64 = 1e-6;

/// By so much the coordinates differ from the point where inertias are compared: no part of a turn.
const ASIDE: [f64; 3] = [0.37, -0.61, 1.93];

/// Components of a direction without inertia below this part of the largest one are rounding.
const MOVED: f64 = 1e-3;

impl VariedEquations {
    /// The places of the speeds that have no inertia at a point, compared with that at other positions; empty where there are none.
    pub(super) fn singular_speeds(&self, point: &Point, at: &At) -> Vec<usize> {
        let masses = &at.motion.by_accelerations;
        let own = diagonal(masses);
        if !masses.iter().all(|entry| entry.is_finite()) || !is_suspicious(masses, &own) {
            return Vec::new();
        }
        let mut sizes = own;
        for by in ASIDE {
            let mut moved = point.clone();
            moved
                .coordinates
                .iter_mut()
                .enumerate()
                .for_each(|(place, value)| *value += by * (1.0 + place as f64).sqrt());
            let there = diagonal(&self.at(&moved).motion.by_accelerations);
            sizes.iter_mut().zip(there.iter()).filter(|(_, there)| there.is_finite()).for_each(|(size, there)| {
                *size = size.max(*there);
            });
        }
        let size = |place: usize| if sizes[place] > 0.0 { sizes[place].sqrt() } else { 1.0 };
        let n = masses.nrows();
        let scaled = DMatrix::from_fn(n, n, |i, j| masses[(i, j)] / (size(i) * size(j)));
        let kept = self.kept();
        let rows = at.acceleration.by_accelerations.rows(0, kept);
        let pushes = DMatrix::from_fn(n, kept, |i, k| rows[(k, i)] / size(i));
        let Some(direction) = without_inertia(scaled, pushes) else { return Vec::new() };
        let most = direction.amax();
        let places: Vec<usize> = (0..n).filter(|&place| direction[place].abs() > MOVED * most).collect();
        // a coordinate that has no inertia anywhere lacks a mass, not a place
        if places.iter().any(|&place| sizes[place] == 0.0) { Vec::new() } else { places }
    }
}

fn diagonal(masses: &DMatrix<f64>) -> DVector<f64> {
    masses.diagonal().map(f64::abs)
}

/// Whether a mass matrix is nearly singular by itself, or an inertia is small beside the largest one.
fn is_suspicious(masses: &DMatrix<f64>, own: &DVector<f64>) -> bool {
    if own.is_empty() || own.amin() <= SUSPICIOUS * own.amax() {
        return !own.is_empty();
    }
    let n = masses.nrows();
    let scaled = DMatrix::from_fn(n, n, |i, j| masses[(i, j)] / (own[i] * own[j]).sqrt());
    scaled.symmetric_eigenvalues().min() < SUSPICIOUS
}
