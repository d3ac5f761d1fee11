//! Gaussian elimination for complex matrices, with real and imaginary parts in separate columns.
//!
//! The complex eigenvalues of a collocation method lead to matrices (lambda / h) I - J with the real Jacobian J.

use super::condensation::Condensation;
use super::lu::by_couplings;
use nalgebra::Complex;
use pulp::{Arch, Simd, WithSimd};

/// The factorisation of the condensed equations of mu I - J.
pub(crate) struct ComplexLu {
    size: usize,
    /// The matrix, row by row.
    rows: Vec<(f64, f64)>,
    /// The factors, column by column: real parts, then imaginary parts.
    columns: Vec<f64>,
    order: Option<Vec<usize>>,
    pivots: Vec<usize>,
    scales: Vec<f64>,
    right: Vec<f64>,
    arch: Arch,
}

impl ComplexLu {
    pub fn new(size: usize) -> Self {
        ComplexLu {
            size,
            rows: vec![(0.0, 0.0); size * size],
            columns: vec![0.0; 2 * size * size],
            order: None,
            pivots: vec![0; size],
            scales: vec![0.0; size],
            right: vec![0.0; 2 * size],
            arch: Arch::new(),
        }
    }

    /// Factorises the condensed equations of mu I - J. Returns false if the matrix is singular or not finite.
    pub fn factorise(&mut self, mu: Complex<f64>, jacobian: &Condensation) -> bool {
        if self.size != jacobian.size() {
            *self = ComplexLu::new(jacobian.size());
        }
        let (n, inverse) = (self.size, mu.inv());
        for (to, (own, through)) in self.rows.iter_mut().zip(jacobian.entries()) {
            *to = (-own - inverse.re * through, -inverse.im * through);
        }
        self.rows.iter_mut().step_by(n + 1).for_each(|(re, im)| (*re, *im) = (*re + mu.re, *im + mu.im));
        let rows = &self.rows;
        let order = self.order.get_or_insert_with(|| {
            let sizes: Vec<f64> = rows.iter().map(|(re, im)| re.abs() + im.abs()).collect();
            by_couplings(&sizes, n)
        });
        for (place, &row) in order.iter().enumerate() {
            let entries = &self.rows[row * n..][..n];
            let mut largest = 0.0_f64;
            for (column, &from) in self.columns.chunks_exact_mut(2 * n).zip(order.iter()) {
                let entry = entries[from];
                (column[place], column[n + place]) = entry;
                largest = largest.max(entry.0.abs() + entry.1.abs());
            }
            self.scales[place] = 1.0 / largest;
        }
        self.arch.dispatch(Eliminate(self))
    }

    /// Replaces the right-hand side (real and imaginary part) by the solution.
    pub fn solve(&mut self, real: &mut [f64], imaginary: &mut [f64]) {
        self.arch.dispatch(Substitute(self, real, imaginary));
    }

    #[inline(always)]
    fn eliminate(&mut self) -> bool {
        let n = self.size;
        for k in 0..n {
            let (done, later) = self.columns.split_at_mut((k + 1) * 2 * n);
            let (re, im) = done[k * 2 * n..].split_at_mut(n);
            let size = |row: usize| (re[row].abs() + im[row].abs()) * self.scales[row];
            let pivot = (k + 1..n).fold(k, |best, row| if size(row) > size(best) { row } else { best });
            self.pivots[k] = pivot;
            let inverse = reciprocal(re[pivot], im[pivot]);
            if !(inverse.0.is_finite() && inverse.1.is_finite()) {
                return false;
            }
            re.swap(k, pivot);
            im.swap(k, pivot);
            self.scales.swap(k, pivot);
            for (re, im) in re[k + 1..].iter_mut().zip(&mut im[k + 1..]) {
                (*re, *im) = product((*re, *im), inverse);
            }
            // the substitution needs the divided column again: the reciprocal of the pivot is stored in its place
            (re[k], im[k]) = inverse;
            let (re, im) = (&re[k + 1..], &im[k + 1..]);
            for other in later.chunks_exact_mut(2 * n) {
                let (other_re, other_im) = other.split_at_mut(n);
                other_re.swap(k, pivot);
                other_im.swap(k, pivot);
                subtract((&mut other_re[k..], &mut other_im[k..]), (re, im));
            }
        }
        for k in 1..n {
            let pivot = self.pivots[k];
            if pivot != k {
                self.columns[..k * 2 * n].chunks_exact_mut(n).for_each(|part| part.swap(k, pivot));
            }
        }
        true
    }

    #[inline(always)]
    fn substitute(&mut self, real: &mut [f64], imaginary: &mut [f64]) {
        let n = self.size;
        let Some(order) = &self.order else { return };
        let (re, im) = self.right.split_at_mut(n);
        for ((re, im), &from) in re.iter_mut().zip(im.iter_mut()).zip(order) {
            (*re, *im) = (real[from], imaginary[from]);
        }
        for k in 0..n {
            re.swap(k, self.pivots[k]);
            im.swap(k, self.pivots[k]);
        }
        for (k, column) in self.columns.chunks_exact(2 * n).enumerate() {
            subtract((&mut re[k..], &mut im[k..]), (&column[k + 1..n], &column[n + k + 1..]));
        }
        for (k, column) in self.columns.chunks_exact(2 * n).enumerate().rev() {
            let (column_re, column_im) = column.split_at(n);
            let known = product((re[k], im[k]), (column_re[k], column_im[k]));
            (re[k], im[k]) = known;
            let parts = re[..k].iter_mut().zip(&mut im[..k]).zip(column_re.iter().zip(column_im));
            for ((re, im), (factor_re, factor_im)) in parts {
                *re -= factor_re * known.0 - factor_im * known.1;
                *im -= factor_re * known.1 + factor_im * known.0;
            }
        }
        for ((re, im), &to) in re.iter().zip(im.iter()).zip(order) {
            (real[to], imaginary[to]) = (*re, *im);
        }
    }
}

/// Subtracts multiples of a column from the entries below the diagonal.
#[inline(always)]
fn subtract((re, im): (&mut [f64], &mut [f64]), factors: (&[f64], &[f64])) {
    let ((top_re, re), (top_im, im)) = match (re.split_first_mut(), im.split_first_mut()) {
        (Some(re), Some(im)) => (re, im),
        _ => return,
    };
    let (above_re, above_im) = (*top_re, *top_im);
    if above_re == 0.0 && above_im == 0.0 {
        return;
    }
    for ((re, im), (factor_re, factor_im)) in re.iter_mut().zip(im).zip(factors.0.iter().zip(factors.1)) {
        *re -= factor_re * above_re - factor_im * above_im;
        *im -= factor_re * above_im + factor_im * above_re;
    }
}

#[inline(always)]
fn product(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

/// 1 / (re + i im), scaled against overflow.
fn reciprocal(re: f64, im: f64) -> (f64, f64) {
    let scale = re.abs().max(im.abs());
    let (a, b) = (re / scale, im / scale);
    let size = (a * a + b * b) * scale;
    (a / size, -b / size)
}

struct Eliminate<'a>(&'a mut ComplexLu);

impl WithSimd for Eliminate<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        self.0.eliminate()
    }
}

struct Substitute<'a>(&'a mut ComplexLu, &'a mut [f64], &'a mut [f64]);

impl WithSimd for Substitute<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.0.substitute(self.1, self.2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every size up to three registers, with a matrix that needs pivoting, badly scaled rows, and many zeros.
    #[test]
    fn shifted_systems_of_any_size_are_solved() {
        for n in 1..25_usize {
            let entry = |i: usize, j: usize| {
                let unit = if i.is_multiple_of(3) { 1e6 } else { 1.0 };
                let coupled = !(i * j + n).is_multiple_of(3) || j == (i + 1) % n;
                if coupled { unit * ((3 * i + 7 * j + n) as f64).sin() } else { 0.0 }
            };
            let jacobian: Vec<f64> = (0..n * n).map(|place| entry(place / n, place % n)).collect();
            let shift = Complex::new(2.0, 3.0);
            let solution: Vec<(f64, f64)> = (0..n).map(|j| (1.0 + j as f64, 0.5 - j as f64)).collect();
            let side = |part: &dyn Fn((f64, f64), f64, f64) -> f64| -> Vec<f64> {
                let row = |i: usize| {
                    (0..n).map(|j| part(solution[j], if i == j { 1.0 } else { 0.0 }, jacobian[i * n + j])).sum::<f64>()
                };
                (0..n).map(row).collect()
            };
            let mut real = side(&|x, unit, slope| (unit * shift.re - slope) * x.0 - unit * shift.im * x.1);
            let mut imaginary = side(&|x, unit, slope| (unit * shift.re - slope) * x.1 + unit * shift.im * x.0);
            let mut lu = ComplexLu::new(n);
            let mut condensation = Condensation::new(n);
            condensation.take(&jacobian);
            let inverse = shift.inv();
            let (mut left_real, mut left_imaginary) = (vec![0.0; condensation.size()], vec![0.0; condensation.size()]);
            assert!(lu.factorise(shift, &condensation), "{n}");
            condensation.condense_complex([&real, &imaginary], inverse, [&mut left_real, &mut left_imaginary]);
            lu.solve(&mut left_real, &mut left_imaginary);
            condensation.expand_complex([&left_real, &left_imaginary], inverse, [&mut real, &mut imaginary]);
            for (j, exact) in solution.iter().enumerate() {
                let error = (real[j] - exact.0).abs() + (imaginary[j] - exact.1).abs();
                assert!(error < 1e-9 * n as f64, "{n}: {error}");
            }
        }
    }

    #[test]
    fn a_shift_onto_an_eigenvalue_is_refused() {
        let mut rotation = Condensation::new(2);
        rotation.take(&[0.0, -1.0, 1.0, 0.0]);
        assert!(!ComplexLu::new(2).factorise(Complex::new(0.0, 1.0), &rotation));
    }
}
