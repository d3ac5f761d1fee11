//! Half-explicit Runge-Kutta methods: the stages are explicit, and equations are solved for the multipliers only.

use super::onto::Onto;
use crate::Real;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Stepper};

/// Coefficients of the stages after the first, then the weights. The node of a stage is the sum of its coefficients.
type Tableau = &'static [&'static [(i64, i64)]];

pub(super) const EULER: Tableau = &[&[(1, 1)]];
pub(super) const RUNGE_KUTTA_4: Tableau =
    &[&[(1, 2)], &[(0, 1), (1, 2)], &[(0, 1), (0, 1), (1, 1)], &[(1, 6), (1, 3), (1, 3), (1, 6)]];

pub(super) struct HalfExplicit<'a, S> {
    /// The coefficients in the scalar type of the run: a node slightly below one would satisfy a moving constraint too
    /// early.
    tableau: Vec<Vec<S>>,
    step: S,
    onto: Onto<'a, S>,
    /// f + B z at the stages.
    slopes: Vec<S>,
    stage: Vec<S>,
}

impl<'a, S: Real> HalfExplicit<'a, S> {
    pub fn new(tableau: Tableau, step: S, onto: Onto<'a, S>) -> Self {
        let n = onto.n;
        let tableau: Vec<Vec<S>> =
            tableau.iter().map(|weights| weights.iter().map(|&(n, d)| S::ratio(n, d)).collect()).collect();
        HalfExplicit { slopes: vec![S::zero(); n * tableau.len()], tableau, step, onto, stage: vec![S::zero(); n] }
    }
}

impl<S: Real> Stepper<S> for HalfExplicit<'_, S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        let (n, mut node) = (self.onto.n, S::zero());
        self.stage.copy_from_slice(before);
        for (last, weights) in self.tableau.iter().enumerate() {
            self.onto.parts(tau + step * node, &self.stage, &mut self.slopes[last * n..][..n], meter);
            node = weights.iter().fold(S::zero(), |sum, weight| sum + *weight);
            for (c, stage) in self.stage.iter_mut().enumerate() {
                let slopes = weights.iter().zip(self.slopes.chunks(n));
                *stage = slopes.fold(before[c], |sum, (weight, slope)| sum + step * *weight * slope[c]);
            }
            if let Err(cause) = self.onto.bring(tau + step * node, &mut self.stage, meter) {
                return Attempt::Rejected { next: 0.0, cause };
            }
            // d = h a z of the last stage: the multipliers follow from the displacement
            let reach = step * weights[last];
            for (c, slope) in self.slopes[last * n..][..n].iter_mut().enumerate() {
                let columns = self.onto.columns.chunks(n).zip(&self.onto.moved);
                *slope += columns.fold(S::zero(), |sum, (column, d)| sum + column[c] * *d) / reach;
            }
        }
        after.copy_from_slice(&self.stage);
        Attempt::Accepted { next: 0.0 }
    }

    fn fixed(&self) -> Option<S> {
        Some(self.step)
    }
}
