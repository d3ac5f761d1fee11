//! The distribution of friction among contacts that lean on each other, over series.

use super::super::contacts::{PARTS, leant};
use super::super::distribution::{ROUNDS, balancing};
use super::super::jet::Jet;
use super::super::mode::Mode;
use super::letters::Quantity;
use super::{Expansions, solved};
use num_traits::{One, Zero};

impl Expansions {
    /// Changes the reactions of contacts that lean to those that are shown; they stay one choice where these are not determined.
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
        // any choice is one: its own errors do not count
        columns.iter_mut().flatten().for_each(|part| part.doubts = [0.0; N]);
        let places: Vec<usize> = unknown.iter().chain(&leant).copied().collect();
        let own = |column: usize, place: usize| match place.checked_sub(unknown.len()) {
            None => columns[column][place],
            Some(other) if other == column => Jet::one(),
            Some(_) => Jet::zero(),
        };
        let first = self.mirrored.len();
        let contact_of = |letter: usize| letter.checked_sub(first).map(|place| (place / PARTS, place % PARTS));
        let tangential = |&place: &usize| {
            let Some((contact, part)) = contact_of(places[place]) else { return false };
            part > 0 && mode.phases.get(contact).is_some_and(|phase| phase.sticking().is_some())
        };
        let tangential: Vec<usize> = (0..places.len()).filter(tangential).collect();
        let of_friction: Vec<Vec<Jet<N>>> =
            (0..leant.len()).map(|column| tangential.iter().map(|&place| own(column, place)).collect()).collect();
        for _ in 0..ROUNDS {
            let friction: Vec<Jet<N>> = tangential.iter().map(|&place| letters[places[place]]).collect();
            let per_bound = tangential.iter().map(|&place| {
                let (contact, _) = contact_of(places[place]).unwrap_or_default();
                let most = self.of_contact(values, Quantity::Friction, contact) * letters[self.reaction([contact, 0])];
                Jet::one() / most
            });
            let per_bound: Vec<Jet<N>> = per_bound.collect();
            let Some(mut factors) = balancing(&friction, &of_friction, &per_bound, solved) else { return };
            factors.iter_mut().for_each(|factor| factor.doubts = [0.0; N]);
            for (place, &letter) in places.iter().enumerate() {
                for (column, factor) in factors.iter().enumerate() {
                    letters[letter] += own(column, place) * *factor;
                }
            }
        }
    }
}
