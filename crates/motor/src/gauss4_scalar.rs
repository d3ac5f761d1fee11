//! Gauss collocation of order 8 for one scalar equation, by Newton's iteration over any scalar type.

use field::{Scalar, Tangent};
use integrators::{Collocation, Family, Real};

/// The number of stages. The order 8 is not below that of any composition.
pub const STAGES: usize = 4;
/// The number of Newton iterations.
const ITERATIONS: usize = 4;

/// The nodes, weights and matrix of the collocation.
#[derive(Clone, Copy, Debug)]
pub struct Rule<S> {
    pub nodes: [S; STAGES],
    pub weights: [S; STAGES],
    pub matrix: [[S; STAGES]; STAGES],
}

impl<S: Real> Rule<S> {
    /// The coefficients of Gauss collocation.
    pub fn gauss() -> Self {
        let table = Collocation::<S>::new(Family::Gauss, STAGES);
        Rule {
            nodes: std::array::from_fn(|i| table.nodes[i]),
            weights: std::array::from_fn(|i| table.weights[i]),
            matrix: std::array::from_fn(|i| std::array::from_fn(|j| table.matrix[i][j])),
        }
    }
}

impl<S: Scalar> Rule<S> {
    /// The increment of s by s' = f_i(s) over a time `length` (s), where `rates` gives f_i with its derivative at the
    /// slips of all nodes; and the square of the last correction of Newton's iteration.
    pub fn solve(&self, length: S, start: S, rates: impl Fn(&[S; STAGES]) -> [Tangent<S>; STAGES]) -> (S, S) {
        let mut stages = [start; STAGES];
        let mut left = S::zero();
        for _ in 0..ITERATIONS {
            let rates = rates(&stages);
            let mut rows: [[S; STAGES]; STAGES] = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    let unit = if i == j { S::one() } else { S::zero() };
                    unit - length * self.matrix[i][j] * rates[j].slope
                })
            });
            let mut residuals: [S; STAGES] = std::array::from_fn(|i| {
                let slopes = self.matrix[i].iter().zip(&rates);
                slopes.fold(start - stages[i], |sum, (a, rate)| sum + length * *a * rate.value)
            });
            eliminate(&mut rows, &mut residuals);
            stages.iter_mut().zip(residuals).for_each(|(stage, correction)| *stage += correction);
            left = residuals.iter().fold(S::zero(), |sum, correction| sum + *correction * *correction);
        }
        let ends = self.weights.iter().zip(rates(&stages));
        let gain = ends.fold(S::zero(), |sum, (weight, rate)| sum + length * *weight * rate.value);
        (gain, left)
    }
}

/// Solves linear equations in place, without pivoting, which is impossible over symbolic scalars: the matrix is close
/// to the identity.
fn eliminate<S: Scalar>(rows: &mut [[S; STAGES]; STAGES], right: &mut [S; STAGES]) {
    for k in 0..STAGES {
        for i in (0..STAGES).filter(|i| *i != k) {
            let factor = rows[i][k] / rows[k][k];
            let above = rows[k];
            rows[i].iter_mut().zip(above).for_each(|(entry, above)| *entry -= factor * above);
            let above = right[k];
            right[i] -= factor * above;
        }
    }
    (0..STAGES).for_each(|k| right[k] /= rows[k][k]);
}
