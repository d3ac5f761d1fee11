//! Proved signs of the eigenvalues of a symmetric interval matrix.

use field::Interval;
use nalgebra::DMatrix;

/// The numbers of negative and of positive eigenvalues of every symmetric matrix in an n by n interval matrix (row by row); `None` if not proved.
///
/// With approximate eigenvectors as columns of Q, the matrix Q^T K Q is nearly diagonal. If none of its Gershgorin discs contains zero and Q is
/// regular, the signs are those of K (Sylvester's law of inertia).
pub(super) fn signs(matrix: &[Interval], n: usize) -> Option<[usize; 2]> {
    if matrix.iter().any(|entry| !entry.size().is_finite()) {
        return None;
    }
    let middle = DMatrix::from_fn(n, n, |i, j| 0.5 * (matrix[i * n + j].middle() + matrix[j * n + i].middle()));
    let vectors = middle.symmetric_eigen().eigenvectors;
    let point = |i: usize, j: usize| Interval::point(vectors[(i, j)]);
    let product = |of: &dyn Fn(usize, usize) -> Interval, i: usize, j: usize| {
        (0..n).fold(Interval::point(0.0), |sum, k| sum + of(i, k) * point(k, j))
    };
    let right: Vec<Interval> = (0..n * n).map(|at| product(&|i, k| matrix[i * n + k], at / n, at % n)).collect();
    let from_left = |of: &dyn Fn(usize, usize) -> Interval, i: usize, j: usize| {
        (0..n).fold(Interval::point(0.0), |sum, k| sum + point(k, i) * of(k, j))
    };
    let others = |entry: &dyn Fn(usize) -> Interval, i: usize| {
        (0..n).filter(|&j| j != i).fold(Interval::point(0.0), |sum, j| sum + Interval::point(entry(j).size())).high()
    };
    let mut counts = [0; 2];
    for i in 0..n {
        let unit = |j: usize| from_left(&|k, j| point(k, j), i, j);
        if unit(i).low() <= others(&unit, i) {
            return None;
        }
        let entry = |j: usize| from_left(&|k, j| right[k * n + j], i, j);
        let (own, radius) = (entry(i), others(&entry, i));
        match () {
            () if own.low() > radius => counts[1] += 1,
            () if own.high() < -radius => counts[0] += 1,
            () => return None,
        }
    }
    Some(counts)
}

#[cfg(test)]
mod tests {
    use super::signs;
    use field::Interval;

    fn about(entries: &[f64], radius: f64) -> Vec<Interval> {
        entries.iter().map(|entry| Interval::new(entry - radius, entry + radius)).collect()
    }

    #[test]
    fn signs_of_eigenvalues_are_told_where_they_are_certain() {
        let matrix = [2.0, 1.0, 0.0, 1.0, -3.0, 0.5, 0.0, 0.5, 1.0];
        assert_eq!(signs(&about(&matrix, 1e-9), 3), Some([1, 2]));
        assert_eq!(signs(&about(&matrix, 1.0), 3), None);
        assert_eq!(signs(&about(&[1.0, 1.0, 1.0, 1.0], 0.0), 2), None);
    }
}
