//! Gaussian elimination with scaled partial pivoting in reused buffers (nalgebra needs a new matrix each time).
//!
//! The matrix is stored by columns: elimination and substitution then add multiples of columns, with the widest SIMD
//! registers. Equations and unknowns are ordered by their number of couplings, fewest first, and zeros are skipped:
//! circuits that are coupled only through the rotor are cheap.

use super::condensation::Condensation;
use pulp::{Arch, Simd, WithSimd};

/// A square matrix and its LU factorisation.
pub(crate) struct Lu {
    size: usize,
    /// The matrix, row by row.
    rows: Vec<f64>,
    /// The factors, column by column, each padded to whole registers.
    columns: Vec<f64>,
    height: usize,
    /// The order of equations and unknowns, from the first matrix.
    order: Option<Vec<usize>>,
    pivots: Vec<usize>,
    /// The reciprocal of the largest entry of each row: pivots of rows in different units become comparable.
    scales: Vec<f64>,
    right: Vec<f64>,
    arch: Arch,
}

/// Columns begin at multiples of this number.
const WIDTH: usize = 8;

impl Lu {
    pub fn new(size: usize) -> Self {
        let height = size.next_multiple_of(WIDTH);
        Lu {
            size,
            rows: vec![0.0; size * size],
            columns: vec![0.0; size * height],
            height,
            order: None,
            pivots: vec![0; size],
            scales: vec![0.0; size],
            right: vec![0.0; height],
            arch: Arch::new(),
        }
    }

    /// The rows of the matrix, to be filled before [`Self::factorise`].
    pub fn rows(&mut self) -> std::slice::ChunksMut<'_, f64> {
        self.rows.chunks_mut(self.size)
    }

    /// Factorises the matrix. Returns false if it is singular or not finite.
    pub fn factorise(&mut self) -> bool {
        let n = self.size;
        let order = self.order.get_or_insert_with(|| by_couplings(&self.rows, n));
        for (place, &row) in order.iter().enumerate() {
            let entries = &self.rows[row * n..][..n];
            let mut largest = 0.0_f64;
            for (column, &from) in self.columns.chunks_exact_mut(self.height).zip(order.iter()) {
                column[place] = entries[from];
                largest = largest.max(entries[from].abs());
            }
            self.scales[place] = 1.0 / largest;
        }
        self.arch.dispatch(Eliminate(self))
    }

    /// Factorises the condensed equations of mu I - J. Returns false if the matrix is singular or not finite.
    pub fn factorise_shifted(&mut self, mu: f64, jacobian: &Condensation) -> bool {
        if self.size != jacobian.size() {
            *self = Lu::new(jacobian.size());
        }
        let inverse = mu.recip();
        for (to, (own, through)) in self.rows.iter_mut().zip(jacobian.entries()) {
            *to = -own - inverse * through;
        }
        self.rows.iter_mut().step_by(self.size + 1).for_each(|diagonal| *diagonal += mu);
        self.factorise()
    }

    /// Replaces the right-hand side by the solution.
    pub fn solve(&mut self, b: &mut [f64]) {
        self.arch.dispatch(Substitute(self, b));
    }

    /// Replaces b by the solution x of (mu I - J) x = b; `room` is a buffer for the condensed equations.
    pub fn solve_shifted(&mut self, mu: f64, jacobian: &Condensation, room: &mut [f64], b: &mut [f64]) {
        let (left, inverse) = (&mut room[..jacobian.size()], mu.recip());
        jacobian.condense(b, inverse, left);
        self.solve(left);
        jacobian.expand(left, inverse, b);
    }

    #[inline(always)]
    fn eliminate(&mut self) -> bool {
        let (n, height) = (self.size, self.height);
        for k in 0..n {
            let (done, later) = self.columns.split_at_mut((k + 1) * height);
            let column = &mut done[k * height..];
            let size = |row: usize| column[row].abs() * self.scales[row];
            let pivot = (k + 1..n).fold(k, |best, row| if size(row) > size(best) { row } else { best });
            self.pivots[k] = pivot;
            let inverse = 1.0 / column[pivot];
            if !inverse.is_finite() {
                return false;
            }
            column.swap(k, pivot);
            self.scales.swap(k, pivot);
            // the first register also contains entries above the diagonal, which must not change
            column[k + 1..n].iter_mut().for_each(|entry| *entry *= inverse);
            let factors = &column[k + 1..n];
            for other in later.chunks_exact_mut(height) {
                other.swap(k, pivot);
                let above = other[k];
                if above != 0.0 {
                    other[k + 1..n].iter_mut().zip(factors).for_each(|(entry, factor)| *entry -= factor * above);
                }
            }
        }
        // rows are swapped in the remaining columns only; the finished columns follow here
        for k in 1..n {
            let pivot = self.pivots[k];
            if pivot != k {
                self.columns[..k * height].chunks_exact_mut(height).for_each(|column| column.swap(k, pivot));
            }
        }
        true
    }

    #[inline(always)]
    fn substitute(&mut self, b: &mut [f64]) {
        let (n, height) = (self.size, self.height);
        let Some(order) = &self.order else { return };
        let right = &mut self.right[..n];
        right.iter_mut().zip(order).for_each(|(right, &from)| *right = b[from]);
        for k in 0..n {
            right.swap(k, self.pivots[k]);
        }
        for k in 0..n {
            let known = right[k];
            if known != 0.0 {
                let column = &self.columns[k * height..][k + 1..n];
                right[k + 1..].iter_mut().zip(column).for_each(|(right, factor)| *right -= factor * known);
            }
        }
        for k in (0..n).rev() {
            let column = &self.columns[k * height..][..=k];
            let known = right[k] / column[k];
            right[k] = known;
            right[..k].iter_mut().zip(column).for_each(|(right, factor)| *right -= factor * known);
        }
        right.iter().zip(order).for_each(|(right, &to)| b[to] = *right);
    }
}

struct Eliminate<'a>(&'a mut Lu);

impl WithSimd for Eliminate<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        self.0.eliminate()
    }
}

struct Substitute<'a>(&'a mut Lu, &'a mut [f64]);

impl WithSimd for Substitute<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.0.substitute(self.1);
    }
}

/// The order of elimination after Markowitz: unknowns with the fewest couplings first.
pub(super) fn by_couplings(rows: &[f64], n: usize) -> Vec<usize> {
    let couplings = |i: usize| {
        let row = rows[i * n..][..n].iter().filter(|entry| **entry != 0.0).count();
        let column = rows.iter().skip(i).step_by(n).filter(|entry| **entry != 0.0).count();
        row * column
    };
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by_key(|i| couplings(*i));
    order
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

    /// Every size up to three registers, with various patterns of zeros and badly scaled rows.
    #[test]
    fn systems_of_any_size_and_pattern_are_solved() {
        for n in 1..25_usize {
            let entry = |i: usize, j: usize| {
                let wave = ((3 * i + 7 * j + n) as f64).sin();
                let unit = if i.is_multiple_of(3) { 1e9 } else { 1.0 };
                // the large entries are next to the diagonal
                let large = if j == (i + 1) % n { 2.0 * n as f64 } else { 0.0 };
                if large == 0.0 && (i * j + n).is_multiple_of(3) { 0.0 } else { unit * (wave + large) }
            };
            let solution: Vec<f64> = (0..n).map(|j| 1.0 + j as f64).collect();
            let mut lu = Lu::new(n);
            // the order of elimination is fixed by another, diagonal matrix
            lu.rows().enumerate().for_each(|(i, row)| row[i] = 1.0);
            assert!(lu.factorise());
            lu.rows().enumerate().for_each(|(i, row)| row.iter_mut().enumerate().for_each(|(j, to)| *to = entry(i, j)));
            let mut x: Vec<f64> = (0..n).map(|i| (0..n).map(|j| entry(i, j) * solution[j]).sum()).collect();
            assert!(lu.factorise(), "{n}");
            lu.solve(&mut x);
            for (x, exact) in x.iter().zip(&solution) {
                assert!((x - exact).abs() < 1e-9 * n as f64, "{n}: {x} for {exact}");
            }
        }
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        let mut lu = Lu::new(2);
        lu.rows().for_each(|row| row.copy_from_slice(&[1.0, 2.0]));
        assert!(!lu.factorise());
    }
}
