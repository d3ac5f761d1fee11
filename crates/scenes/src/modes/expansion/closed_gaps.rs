//! Displacements that close the gaps of contacts in touch.

use super::super::jet::Jet;
use super::Expansions;
use super::impulses::{IMPULSES, rounded};
use super::letters::Quantity;
use nalgebra::{DMatrix, DVector};

/// Displacements along contacts whose normal forces move the bodies alike are equal: singular values below this part of the largest one are zero.
const RANK: f64 = 1e-10;

impl Expansions {
    /// Moves a state so that the gaps of some contacts are zero, by the displacements that forces along their normals would cause, which preserve
    /// constraints. Of contacts whose gaps depend on each other the sum of squares of the gaps becomes least.
    pub fn close_gaps(&self, time: f64, state: &mut [f64], contacts: &[usize]) {
        let clock = Jet::<1>::constant(time, 0.0);
        let letters: Vec<usize> = contacts.iter().map(|contact| self.reaction([*contact, 0])).collect();
        let all = vec![Jet::<1>::constant(0.0, 0.0); self.letters()];
        for _ in 0..IMPULSES {
            let parts = rounded(state);
            let values = self.values(clock, &parts, &all, &[]);
            let gap = |contact: &usize| self.of_contact(&values, Quantity::Gap, *contact).terms[0];
            let gaps = DVector::from_iterator(contacts.len(), contacts.iter().map(gap));
            let slopes = self.slopes_by(&values, &vec![None; self.kinds.len()], &letters, &letters);
            let slopes = DMatrix::from_fn(letters.len(), letters.len(), |row, column| slopes[row][column].terms[0]);
            let numbers = gaps.iter().chain(slopes.iter());
            if gaps.amax() == 0.0 || slopes.amax() == 0.0 || !numbers.into_iter().all(|number| number.is_finite()) {
                return;
            }
            let decomposed = slopes.svd(true, true);
            let least = RANK * decomposed.singular_values.amax();
            let Ok(forces) = decomposed.solve(&gaps, least) else { return };
            let mut moved = parts;
            for (force, added) in forces.iter().zip(self.responses(clock, &moved.clone(), &all, &letters)) {
                for (part, rate) in moved.iter_mut().zip(added) {
                    *part -= Jet::constant(force * rate, 0.0);
                }
            }
            let displaced = self.values(clock, &moved, &all, &[]);
            for place in 0..self.positions {
                state[place] += displaced[place].terms[0] - values[place].terms[0];
            }
        }
    }
}
