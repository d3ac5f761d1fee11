//! Singularities of coordinates, such as the pole of spherical angles: the mass matrix is singular there, and no equation in these
//! coordinates describes the motion nearby.

use super::equations::{At, Point, VariedEquations};
use nalgebra::{DMatrix, DVector};

/// The test continues only if the smallest eigenvalue of the mass matrix scaled to a unit diagonal, or the ratio of two inertias, is
/// below this value.
const SUSPICIOUS: f64 = 1e-6;

/// Eigenvalues of the scaled mass matrix below this value count as zero; the square of the rounding error of an angle is far below it.
const SINGULAR: f64 = 1e-12;

/// Displacements of the coordinates at which inertias are compared; no fraction of a turn.
const ASIDE: [f64; 3] = [0.37, -0.61, 1.93];

/// Components of a direction without inertia below this part of the largest are rounding errors.
const MOVED: f64 = 1e-3;

impl VariedEquations {
    /// The indices of the speeds that have no inertia at this point but have one at other positions; empty if there are none.
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
        // a coordinate without inertia anywhere is a missing mass, not a singularity
        if places.iter().any(|&place| sizes[place] == 0.0) { Vec::new() } else { places }
    }
}

fn diagonal(masses: &DMatrix<f64>) -> DVector<f64> {
    masses.diagonal().map(f64::abs)
}

/// True if the scaled mass matrix is nearly singular, or an inertia is small relative to the largest.
fn is_suspicious(masses: &DMatrix<f64>, own: &DVector<f64>) -> bool {
    if own.is_empty() || own.amin() <= SUSPICIOUS * own.amax() {
        return !own.is_empty();
    }
    let n = masses.nrows();
    let scaled = DMatrix::from_fn(n, n, |i, j| masses[(i, j)] / (own[i] * own[j]).sqrt());
    scaled.symmetric_eigenvalues().min() < SUSPICIOUS
}

/// A unit vector of speeds that satisfies the constraints and has no kinetic energy, if there is one. It is an eigenvector with
/// eigenvalue zero of the sum of `masses` and `pushes` times its transpose, with columns of unit length: both terms are positive
/// semidefinite. Columns of `pushes` are gradients of constraints.
pub(crate) fn without_inertia(masses: DMatrix<f64>, mut pushes: DMatrix<f64>) -> Option<DVector<f64>> {
    for mut column in pushes.column_iter_mut() {
        let length = column.norm();
        if length > 0.0 {
            column.unscale_mut(length);
        }
    }
    let all = masses + &pushes * pushes.transpose();
    if !all.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let eigen = all.symmetric_eigen();
    // a given kinetic energy may be negative
    let (place, least) = eigen.eigenvalues.map(f64::abs).argmin();
    (least < SINGULAR).then(|| eigen.eigenvectors.column(place).into_owned())
}

#[cfg(test)]
mod tests {
    use super::without_inertia;
    use nalgebra::DMatrix;

    #[test]
    fn a_massless_coordinate_that_a_constraint_holds_needs_no_inertia() {
        let masses = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 0.0]);
        let held = DMatrix::from_row_slice(2, 1, &[0.0, 3.0]);
        assert_eq!(without_inertia(masses.clone(), held), None);
        let beside = DMatrix::from_row_slice(2, 1, &[5.0, 0.0]);
        let direction = without_inertia(masses, beside).expect("nothing holds the second coordinate");
        assert!((direction[1].abs() - 1.0).abs() < 1e-12, "{direction}");
    }
}
