//! The states of a regulator: variations on which the linear equations or the cost depend.
//!
//! A displacement along a direction v with A v = 0, Q v = 0 and N^T v = 0 changes neither the linear equations nor the cost, such as the charge of
//! a motor, or the position of a cart that does not occur in the cost. The regulator uses states z = T x without such directions, for which
//! x' = A x + B u becomes a closed equation.

use super::riccati::Stage;
use crate::kernel::Rows;
use crate::linearisation::dependent;
use nalgebra::DMatrix;

/// Factors in z = T x below this are rounding: those of kept variations are one.
const ROUNDING: f64 = 1e-10;

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
    /// The states for linear equations at instants and the cost at the end; the first `displacements` variations are displacements.
    pub fn of(stages: &[Stage], last: Option<&DMatrix<f64>>, displacements: usize) -> Self {
        let all = stages.first().map_or(0, |stage| stage.a.ncols());
        let parts = stages.iter().flat_map(|stage| [&stage.a, &stage.state]).chain(last);
        let mut rows = Rows::none(displacements);
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
                    by_variations[(row, pivot)] = if factor.abs() > ROUNDING { -factor } else { 0.0 };
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
