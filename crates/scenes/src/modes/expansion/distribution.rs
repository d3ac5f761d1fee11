//! The distribution of friction among leaning contacts, over Taylor series.

use super::super::contacts::{PARTS, leant};
use super::super::distribution::{ROUNDS, balancing};
use super::super::jet::Jet;
use super::super::mode::Mode;
use super::letters::Quantity;
use super::{Expansions, solved};

impl Expansions {
    /// Replaces the reactions by the distribution of least weighted squares; unchanged if this distribution is not determined.
    pub(super) fn distribute<const N: usize>(
        &self,
        mode: &Mode,
        (values, tied): (&[Jet<N>], &[Option<[Jet<N>; 2]>]),
        unknown: &[usize],
        letters: &mut [Jet<N>],
    ) {
        let leant: Vec<usize> = leant(mode).into_iter().map(|of| self.reaction(of)).collect();
        if leant.is_empty() || unknown.is_empty() {
            return;
        }
        let rows = self.slopes_by(values, tied, unknown, unknown);
        let moved = self.slopes_by(values, tied, unknown, &leant);
        let column = |place: usize| solved(rows.clone(), moved.iter().map(|row| -row[place]).collect());
        let Some(mut columns) = (0..leant.len()).map(column).collect::<Option<Vec<Vec<Jet<N>>>>>() else { return };
        // every distribution is valid, so that errors of the choice do not count
        columns.iter_mut().flatten().for_each(|part| part.doubts = [0.0; N]);
        let first = self.mirrored.len();
        let contact_of = |letter: usize| letter.checked_sub(first).map(|place| [place / PARTS, place % PARTS]);
        let friction = |&place: &usize| {
            let Some([contact, part]) = contact_of(unknown[place]) else { return false };
            part > 0 && mode.phases.get(contact).is_some_and(|phase| phase.sticking().is_some())
        };
        let following: Vec<usize> = (0..unknown.len()).filter(friction).collect();
        let alone: Vec<Jet<N>> = following.iter().map(|&place| letters[unknown[place]]).collect();
        let of_friction: Vec<Vec<Jet<N>>> =
            columns.iter().map(|column| following.iter().map(|&place| column[place]).collect()).collect();
        let without: Vec<Jet<N>> = unknown.iter().map(|&letter| letters[letter]).collect();
        for _ in 0..ROUNDS {
            let bound = |letter: usize| {
                let [contact, _] = contact_of(letter).unwrap_or_default();
                self.of_contact(values, Quantity::Friction, contact) * letters[self.reaction([contact, 0])]
            };
            let bounds: Vec<Jet<N>> = following.iter().map(|&place| bound(unknown[place])).collect();
            let bounds_leaning: Vec<Jet<N>> = leant.iter().map(|&letter| bound(letter)).collect();
            let Some(mut found) = balancing(&alone, &of_friction, [&bounds, &bounds_leaning], solved) else { return };
            found.iter_mut().for_each(|friction| friction.doubts = [0.0; N]);
            for (place, &letter) in unknown.iter().enumerate() {
                let parts = columns.iter().zip(&found).map(|(column, friction)| column[place] * *friction);
                letters[letter] = parts.fold(without[place], |sum, part| sum + part);
            }
            leant.iter().zip(found).for_each(|(&letter, friction)| letters[letter] = friction);
        }
    }
}
