//! The states of a regulator: combinations of variations that influence the linear equations or the cost.
//!
//! A displacement in a direction v with A v = 0, Q v = 0 and N^T v = 0 influences neither of them. Examples are the charge of a motor, or the
//! position of a cart if the cost does not contain it. The regulator uses states z = T x without such directions; z' = A z + B u is then a
//! closed system of equations.

use super::riccati::Stage;
use crate::kernel::Rows;
use crate::linearisation::dependent;
use nalgebra::DMatrix;

/// Entries of T below this size are rounding errors: each row of T has an entry 1.
const ROUNDING: f64 = 1e-10;

/// The states z = T x of a regulator.
#[derive(Clone, Debug, PartialEq)]
pub struct States {
    /// T: rows are states, columns are all variations. The columns in `kept` form an identity matrix.
    pub by_variations: DMatrix<f64>,
    /// For each state, the variation that has the factor 1 in it.
    pub kept: Vec<usize>,
    /// Variations that are no states.
    pub left_out: Vec<usize>,
}

impl States {
    /// The states for the linear equations at some instants and the terminal cost; the first `displacements` variations are displacements.
    pub fn of(stages: &[Stage], last: Option<&DMatrix<f64>>, displacements: usize) -> Self {
        let all = stages.first().map_or(0, |stage| stage.a.ncols());
        let parts = stages.iter().flat_map(|stage| [&stage.a, &stage.state]).chain(last);
        let mut rows = Rows::none(displacements);
        parts.for_each(|part| rows.add(&part.columns(0, displacements).into_owned()));
        stages.iter().for_each(|stage| rows.add(&stage.mixed.rows(0, displacements).transpose()));
        let idle = rows.kernel();
        // the idle directions are linearly independent, so that each has a pivot
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

    /// The linear equations and the cost in terms of the states.
    pub fn stage(&self, stage: &Stage) -> Stage {
        Stage {
            a: &self.by_variations * stage.a.select_columns(&self.kept),
            b: &self.by_variations * &stage.b,
            state: self.form(&stage.state),
            mixed: stage.mixed.select_rows(&self.kept),
            input: stage.input.clone(),
        }
    }

    /// A quadratic form of the variations in terms of the states.
    pub fn form(&self, form: &DMatrix<f64>) -> DMatrix<f64> {
        form.select_rows(&self.kept).select_columns(&self.kept)
    }
}
