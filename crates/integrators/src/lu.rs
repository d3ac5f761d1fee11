//! Gaussian elimination with partial pivoting in a buffer that is made once (nalgebra's takes a new matrix each time).

/// A square matrix and its factors, row after row.
pub(crate) struct Lu {
    size: usize,
    entries: Vec<f64>,
    pivots: Vec<usize>,
}

impl Lu {
    pub fn new(size: usize) -> Self {
        Lu { size, entries: vec![0.0; size * size], pivots: vec![0; size] }
    }

    /// The rows of the matrix that will be factorised.
    pub fn rows(&mut self) -> std::slice::ChunksMut<'_, f64> {
        self.entries.chunks_mut(self.size)
    }

    /// Replaces the matrix by its factors; false if it is singular or not finite.
    pub fn factorise(&mut self) -> bool {
        let n = self.size;
        for k in 0..n {
            let size = |row: usize| self.entries[row * n + k].abs();
            let pivot = (k + 1..n).fold(k, |best, row| if size(row) > size(best) { row } else { best });
            self.pivots[k] = pivot;
            let (upper, lower) = self.entries.split_at_mut((k + 1) * n);
            if pivot != k {
                upper[k * n..].swap_with_slice(&mut lower[(pivot - k - 1) * n..][..n]);
            }
            let pivot_row = &upper[k * n..];
            let inverse = 1.0 / pivot_row[k];
            if !inverse.is_finite() {
                return false;
            }
            for row in lower.chunks_exact_mut(n) {
                let factor = row[k] * inverse;
                row[k] = factor;
                if factor != 0.0 {
                    for (entry, above) in row[k + 1..].iter_mut().zip(&pivot_row[k + 1..]) {
                        *entry -= factor * above;
                    }
                }
            }
        }
        true
    }

    /// Replaces the right-hand side by the solution.
    pub fn solve(&self, b: &mut [f64]) {
        let n = self.size;
        for k in 0..n {
            b.swap(k, self.pivots[k]);
        }
        for i in 1..n {
            let row = &self.entries[i * n..][..i];
            b[i] -= row.iter().zip(&b[..i]).map(|(l, b)| l * b).sum::<f64>();
        }
        for i in (0..n).rev() {
            let row = &self.entries[i * n..][..n];
            let known: f64 = row[i + 1..].iter().zip(&b[i + 1..]).map(|(u, b)| u * b).sum();
            b[i] = (b[i] - known) / row[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Lu;

    #[test]
    fn the_solution_of_a_system_that_needs_pivots_solves_it() {
        let (rows, right) = ([[0.0, 2.0, 1.0], [4.0, -1.0, 3.0], [1.0, 1.0, 1.0]], [7.0, 11.0, 6.0]);
        let mut lu = Lu::new(3);
        lu.rows().zip(&rows).for_each(|(to, from)| to.copy_from_slice(from));
        assert!(lu.factorise());
        let mut x = right;
        lu.solve(&mut x);
        for (row, b) in rows.iter().zip(right) {
            let product: f64 = row.iter().zip(x).map(|(a, x)| a * x).sum();
            assert!((product - b).abs() < 1e-14);
        }
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        let mut lu = Lu::new(2);
        lu.rows().for_each(|row| row.copy_from_slice(&[1.0, 2.0]));
        assert!(!lu.factorise());
    }
}
