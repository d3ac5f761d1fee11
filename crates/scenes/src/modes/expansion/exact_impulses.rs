//! Impulses in double-double arithmetic: impacts, and impulses that bring contacts to rest.

use super::super::contacts::PARTS;
use super::super::mode::{Case, Mode};
use super::Expansions;
use super::letters::Quantity;
use field::DoubleDouble;
use integrators::Real;
use nalgebra::{DMatrix, DVector};
use num_traits::{One, Zero};

/// The number of corrections; each removes the remaining sliding up to the rounding error of an `f64`.
const ROUNDS: usize = 4;

impl Expansions {
    /// The state after an impact of one contact; `None` if the law of impact does not determine it.
    pub fn struck_exactly(
        &self,
        time: DoubleDouble,
        state: &[DoubleDouble],
        (contact, cases): (usize, &[Case]),
    ) -> Option<Vec<DoubleDouble>> {
        let all = self.letters_in::<DoubleDouble>(cases);
        let values = self.exact_values(time, state, &all);
        let impulses = self.impulses(&values, contact).ok()?;
        let mut after = state.to_vec();
        for (component, impulse) in impulses.into_iter().enumerate() {
            let mut one = all.clone();
            one[self.reaction([contact, component])] = DoubleDouble::one();
            let moved = self.exact_values(time, state, &one);
            for (place, part) in after.iter_mut().enumerate() {
                *part += impulse * (moved[place] - values[place]);
            }
        }
        Some(after)
    }

    /// All outputs of the compiled function in double-double arithmetic.
    pub(super) fn exact_values(
        &self,
        time: DoubleDouble,
        state: &[DoubleDouble],
        letters: &[DoubleDouble],
    ) -> Vec<DoubleDouble> {
        let mut found = vec![DoubleDouble::zero(); self.tape.outputs()];
        let inputs = state.iter().chain([&time]).chain(letters).copied();
        self.tape.evaluate_long(&self.tape.constants::<DoubleDouble>(), inputs, &mut found);
        found
    }

    /// The state after impulses of the unknown reactions of a mode that bring sliding and closing velocities of its contacts to zero;
    /// `None` if they are not determined.
    pub fn rested_exactly(&self, time: DoubleDouble, state: &[DoubleDouble], mode: &Mode) -> Option<Vec<DoubleDouble>> {
        let all = self.letters_in::<DoubleDouble>(&mode.cases);
        let unknown = self.unknown_reactions(mode);
        let first = mode.cases.len();
        let mut after = state.to_vec();
        for _ in 0..ROUNDS {
            let values = self.exact_values(time, &after, &all);
            let slopes = self.slopes_by(&values, &vec![None; self.kinds.len()], &unknown, &unknown);
            let matrix = DMatrix::from_fn(unknown.len(), unknown.len(), |row, column| slopes[row][column].approx());
            let left = unknown.iter().map(|letter| {
                let (contact, part) = ((letter - first) / PARTS, (letter - first) % PARTS);
                let quantity = [Quantity::GapRate, Quantity::Slide, Quantity::Aside][part];
                -self.of_contact(&values, quantity, contact).approx()
            });
            let impulses = matrix.lu().solve(&DVector::from_iterator(unknown.len(), left))?;
            for (&letter, &impulse) in unknown.iter().zip(impulses.iter()) {
                let mut one = all.clone();
                one[letter] = DoubleDouble::one();
                let moved = self.exact_values(time, state, &one);
                let still = self.exact_values(time, state, &all);
                for (place, part) in after.iter_mut().enumerate() {
                    *part += DoubleDouble::from(impulse) * (moved[place] - still[place]);
                }
            }
        }
        after.iter().all(|part| part.finite()).then_some(after)
    }
}
