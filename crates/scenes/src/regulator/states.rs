//! The states of a regulator: variations on which the linear equations or the cost depend.
//!
//! Along a direction v of displacements with A v = 0, Q v = 0 and N^T v = 0 nothing changes but the place itself: the charge of a motor, a
//! cart without a place in the cost. The regulator knows z = T x, from which such directions have gone, and x' = A x + B u becomes an
//! equation of z alone.

use super::riccati::Stage;
use crate::linearisation::dependent;
use nalgebra::DMatrix;

/// Singular values below this part of the largest one are taken for zero; so are factors in z = T x, of which the largest are one.
const RANK: f64 = 1e-10;

/// The states z = T x that a regulator knows.
#[derive(Clone, Debug, PartialEq)]
pub struct States {
    /// T: rows are states, columns all variations; a column of its own for each state is one of the identity.
    pub by_variations: DMatrix<f64>,
    /// The variation of which each state has the whole.
    pub kept: Vec<usize>,
    /// Variations that are left out.
    pub left_out: Vec<usize>,
}

impl States {
    /// Of equations at instants and the cost of the end, whose first variations are `displacements`.
    pub fn of(stages: &[Stage], last: Option<&DMatrix<f64>>, displacements: usize) -> Self {
        let all = stages.first().map_or(0, |stage| stage.a.ncols());
        let parts = stages.iter().flat_map(|stage| [&stage.a, &stage.state]).chain(last);
        let mut rows = Rows(DMatrix::zeros(0, displacements));
        parts.for_each(|part| rows.add(&part.columns(0, displacements).into_owned()));
        stages.iter().for_each(|stage| rows.add(&stage.mixed.rows(0, displacements).transpose()));
        let idle = rows.kernel();
        // directions are independent: each has a pivot
        let left_out = dependent(&idle.transpose()).unwrap_or_default();
        let kept: Vec<usize> = (0..all).filter(|place| !left_out.contains(place)).collect();
        let mut by_variations = DMatrix::zeros(kept.len(), all);
        for (row, &place) in kept.iter().enumerate() {
            by_variations[(row, place)] = 1.0;
        }
        let pivots = DMatrix::from_fn(left_out.len(), idle.ncols(), |row, column| idle[(left_out[row], column)]);
        if let (false, Some(inverse)) = (left_out.is_empty(), pivots.try_inverse()) {
            for (row, &place) in kept.iter().enumerate().filter(|(_, place)| **place < displacements) {
                let factors = idle.row(place) * &inverse;
                for (&pivot, &factor) in left_out.iter().zip(factors.iter()) {
                    by_variations[(row, pivot)] = if factor.abs() > RANK { -factor } else { 0.0 };
                }
            }
        }
        States { by_variations, kept, left_out }
    }

    /// The equations and the cost by the states.
    pub fn stage(&self, stage: &Stage) -> Stage {
        Stage {
            a: &self.by_variations * stage.a.select_columns(&self.kept),
            b: &self.by_variations * &stage.b,
            state: self.form(&stage.state),
            mixed: stage.mixed.select_rows(&self.kept),
            input: stage.input.clone(),
        }
    }

    /// A quadratic form of variations by the states.
    pub fn form(&self, form: &DMatrix<f64>) -> DMatrix<f64> {
        form.select_rows(&self.kept).select_columns(&self.kept)
    }
}

/// Rows, of which as many are kept as there are columns: what they take to zero stays.
struct Rows(DMatrix<f64>);

impl Rows {
    /// Each row by its largest entry: units of equations do not count.
    fn add(&mut self, rows: &DMatrix<f64>) {
        let Rows(known) = self;
        let more: Vec<usize> = (0..rows.nrows()).filter(|&row| rows.row(row).amax() > 0.0).collect();
        let scaled = DMatrix::from_fn(more.len(), rows.ncols(), |row, column| {
            rows[(more[row], column)] / rows.row(more[row]).amax()
        });
        let mut both = DMatrix::zeros(known.nrows() + scaled.nrows(), rows.ncols());
        both.rows_mut(0, known.nrows()).copy_from(known);
        both.rows_mut(known.nrows(), scaled.nrows()).copy_from(&scaled);
        *known = if both.nrows() > both.ncols() { both.qr().r() } else { both };
    }

    /// Directions that every row takes to zero, columns.
    fn kernel(&self) -> DMatrix<f64> {
        let Rows(rows) = self;
        let n = rows.ncols();
        if n == 0 || rows.amax() == 0.0 {
            return DMatrix::identity(n, n);
        }
        let mut square = DMatrix::zeros(n, n);
        square.rows_mut(0, rows.nrows()).copy_from(rows);
        let decomposed = square.svd(false, true);
        let largest = decomposed.singular_values.amax();
        let zero: Vec<usize> = (0..n).filter(|&k| decomposed.singular_values[k] <= RANK * largest).collect();
        decomposed.v_t.map_or_else(|| DMatrix::zeros(n, 0), |along| along.select_rows(&zero).transpose())
    }
}
