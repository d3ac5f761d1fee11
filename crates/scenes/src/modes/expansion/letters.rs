//! The letters of a model's expressions, switches and reactions: which of them a mode leaves unknown, and the slopes of rows by them.

use super::super::contacts::unknown;
use super::super::jet::Jet;
use super::super::mode::{Case, Mode, Phase};
use super::{Expansions, ROUNDS, Slope};
use field::Scalar;

/// Quantities of a contact, in the order of the tape.
#[derive(Clone, Copy)]
pub(super) enum Quantity {
    Gap,
    GapRate,
    Slide,
    Friction,
    Restitution,
}

impl Expansions {
    /// The number of switches and reactions.
    pub(super) fn letters(&self) -> usize {
        self.mirrored.len() + 2 * self.kinds.len()
    }

    /// Steps of Newton's method for unknown letters: one where the rows are linear in them. A law of g that has |g| in it is linear
    /// where g is zero; rounding leaves powers of g.
    pub(super) fn rounds(&self, unknown: &[usize]) -> usize {
        let changes = |slope: &Slope| {
            unknown.contains(&slope.row) && slope.changed_by.iter().any(|letter| unknown.contains(letter))
        };
        if self.slopes.iter().any(changes) { ROUNDS } else { 1 }
    }

    /// Conditions of their own that a mode holds.
    pub fn held(&self, mode: &Mode) -> Vec<usize> {
        let is_held = |place: &usize| mode.cases[*place] == Case::Held && self.mirrored[*place].is_none();
        (0..mode.cases.len()).filter(is_held).collect()
    }

    /// The letter of a reaction.
    pub(super) fn reaction(&self, [contact, component]: [usize; 2]) -> usize {
        self.mirrored.len() + 2 * contact + component
    }

    /// Letters of reactions that a mode leaves to be found.
    pub(super) fn unknown_reactions(&self, mode: &Mode) -> Vec<usize> {
        unknown(mode).into_iter().map(|of| self.reaction(of)).collect()
    }

    /// For each normal reaction of a contact that slides, T = factor N.
    pub(super) fn tied<const N: usize>(&self, mode: &Mode, values: &[Jet<N>]) -> Vec<Option<Jet<N>>> {
        let of = |(contact, phase): (usize, &Phase)| {
            let (face, way) = (phase.face()?, phase.way()?);
            let sign = Jet::constant(-way * face.sign(), 0.0);
            Some(sign * self.of_contact(values, Quantity::Friction, contact))
        };
        mode.phases.iter().enumerate().map(of).collect()
    }

    /// A quantity of a contact.
    pub(super) fn of_contact<S: Scalar>(&self, values: &[S], quantity: Quantity, contact: usize) -> S {
        let first = self.states + self.mirrored.len() + self.letters() + self.slopes.len();
        values[first + quantity as usize * self.kinds.len() + contact]
    }

    /// Slopes of some rows by some letters, the tangential reactions of contacts that slide with their normal ones.
    pub(super) fn slopes_by<S: Scalar>(
        &self,
        values: &[S],
        tied: &[Option<S>],
        rows: &[usize],
        letters: &[usize],
    ) -> Vec<Vec<S>> {
        let mut all = vec![vec![S::zero(); letters.len()]; rows.len()];
        let first = self.states + self.mirrored.len() + self.letters();
        for (slope, value) in self.slopes.iter().zip(&values[first..]) {
            let Some(row) = rows.iter().position(|row| *row == slope.row) else { continue };
            if let Some(column) = letters.iter().position(|letter| *letter == slope.by) {
                all[row][column] += *value;
            }
            // T moves with N
            let reaction = slope.by.checked_sub(self.mirrored.len()).filter(|place| place % 2 == 1);
            let Some((place, factor)) = reaction.and_then(|place| Some((place, tied[place / 2]?))) else { continue };
            let normal = self.mirrored.len() + place - 1;
            if let Some(column) = letters.iter().position(|letter| *letter == normal) {
                all[row][column] += *value * factor;
            }
        }
        all
    }
}
