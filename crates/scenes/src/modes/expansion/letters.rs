//! The letters of a model's expressions, switches and reactions: which of them a mode leaves unknown, and the slopes of rows by them.

use super::super::contacts::{PARTS, unknown};
use super::super::jet::Jet;
use super::super::mode::{Case, Heading, Mode, Phase};
use super::{Expansions, MOST_ROUNDS, ROUNDS, Slope};
use field::{Analytic, Scalar};
use num_traits::Zero;
use std::ops::Range;

/// Quantities of a contact, in the order of the tape.
#[derive(Clone, Copy)]
pub(super) enum Quantity {
    Gap,
    GapRate,
    Slide,
    Aside,
    Friction,
    Restitution,
}

impl Expansions {
    /// The number of switches, reactions, and algebraic speeds with their multipliers.
    pub(super) fn letters(&self) -> usize {
        self.mirrored.len() + PARTS * self.kinds.len() + self.algebraic
    }

    /// Whether speeds are algebraic.
    pub fn has_algebraic(&self) -> bool {
        self.algebraic > 0
    }

    /// The letters of algebraic speeds and of their multipliers.
    pub(super) fn algebraic(&self) -> Range<usize> {
        self.letters() - self.algebraic..self.letters()
    }

    /// The number of rows: one for each letter, and with algebraic speeds also one for the rate of each.
    pub(super) fn rows(&self) -> usize {
        if self.has_algebraic() { 2 * self.letters() } else { self.letters() }
    }

    /// Whether the row of a letter is a value, which the mode determines, instead of a rate.
    pub(super) fn is_value(&self, letter: usize) -> bool {
        let cases = self.mirrored.len();
        match letter.checked_sub(cases) {
            None => self.direct_conditions[letter],
            Some(place) => self.kinds.get(place / PARTS).is_none_or(|kind| kind.is_direct && place % PARTS == 0),
        }
    }

    /// Steps of Newton's method for unknown letters: one if the rows are linear in them. A law of g that contains |g| is linear
    /// at g = 0 up to rounding.
    pub(super) fn rounds(&self, unknown: &[usize]) -> usize {
        let changes = |slope: &Slope| {
            unknown.contains(&slope.row) && slope.changed_by.iter().any(|letter| unknown.contains(letter))
        };
        match self.slopes.iter().any(changes) {
            true if self.has_algebraic() => MOST_ROUNDS,
            true => ROUNDS,
            false => 1,
        }
    }

    /// Conditions of their own that a mode holds.
    pub fn held(&self, mode: &Mode) -> Vec<usize> {
        let is_held = |place: &usize| mode.cases[*place] == Case::Held && self.mirrored[*place].is_none();
        (0..mode.cases.len()).filter(is_held).collect()
    }

    /// The letter of a reaction.
    pub(super) fn reaction(&self, [contact, component]: [usize; 2]) -> usize {
        self.mirrored.len() + PARTS * contact + component
    }

    /// Letters of the unknown reactions of a mode.
    pub(super) fn unknown_reactions(&self, mode: &Mode) -> Vec<usize> {
        unknown(mode, |contact| self.kinds[contact].is_in_space).into_iter().map(|of| self.reaction(of)).collect()
    }

    /// Letters of unknown reactions that depend on accelerations.
    pub(super) fn inertial_reactions(&self, mode: &Mode) -> Vec<usize> {
        let mut letters = self.unknown_reactions(mode);
        letters.retain(|&letter| !self.is_value(letter));
        letters
    }

    /// For each normal reaction of a contact that slides, T = factor N along each tangent.
    pub(super) fn tied<const N: usize>(&self, mode: &Mode, values: &[Jet<N>]) -> Vec<Option<[Jet<N>; 2]>> {
        let of = |(contact, phase): (usize, &Phase)| {
            let against = Jet::constant(-phase.face()?.sign(), 0.0);
            let most = against * self.of_contact(values, Quantity::Friction, contact);
            Some(self.way(values, contact, *phase)?.map(|along| most * along))
        };
        mode.phases.iter().enumerate().map(of).collect()
    }

    /// The direction of sliding that friction opposes at its bound, along each tangent.
    fn way<const N: usize>(&self, values: &[Jet<N>], contact: usize, phase: Phase) -> Option<[Jet<N>; 2]> {
        match phase {
            Phase::Glides { begins: Some(heading), .. } => Some(direction(heading)),
            Phase::Glides { begins: None, .. } => {
                let slides = [Quantity::Slide, Quantity::Aside].map(|of| self.of_contact(values, of, contact));
                let speed = (slides[0] * slides[0] + slides[1] * slides[1]).sqrt();
                Some(slides.map(|slide| slide / speed))
            }
            _ => Some([Jet::constant(phase.way()?, 0.0), Jet::zero()]),
        }
    }

    /// A quantity of a contact.
    pub(super) fn of_contact<S: Scalar>(&self, values: &[S], quantity: Quantity, contact: usize) -> S {
        let first = self.states + self.mirrored.len() + self.rows() + self.slopes.len();
        values[first + quantity as usize * self.kinds.len() + contact]
    }

    /// Slopes of some rows by some letters, the tangential reactions of contacts that slide with their normal ones.
    pub(super) fn slopes_by<S: Scalar>(
        &self,
        values: &[S],
        tied: &[Option<[S; 2]>],
        rows: &[usize],
        letters: &[usize],
    ) -> Vec<Vec<S>> {
        let mut all = vec![vec![S::zero(); letters.len()]; rows.len()];
        let first = self.states + self.mirrored.len() + self.rows();
        for (slope, value) in self.slopes.iter().zip(&values[first..]) {
            let Some(row) = rows.iter().position(|row| *row == slope.row) else { continue };
            if let Some(column) = letters.iter().position(|letter| *letter == slope.by) {
                all[row][column] += *value;
            }
            // T moves with N
            let reaction = slope.by.checked_sub(self.mirrored.len()).filter(|place| place % PARTS > 0);
            let tied_to = |place: usize| Some((place, (*tied.get(place / PARTS)?)?[place % PARTS - 1]));
            let Some((place, factor)) = reaction.and_then(tied_to) else { continue };
            let normal = self.mirrored.len() + place - place % PARTS;
            if let Some(column) = letters.iter().position(|letter| *letter == normal) {
                all[row][column] += *value * factor;
            }
        }
        all
    }
}

/// The relative accuracy of the rate of a direction.
const TURN: f64 = 1e-10;

/// A direction that begins at an angle and turns.
pub(in super::super) fn direction<const N: usize>(heading: Heading) -> [Jet<N>; 2] {
    let mut angle = Jet::constant(heading.angle(), heading.doubt());
    if N > 1 {
        angle.terms[1] = heading.turn();
        angle.doubts[1] = heading.doubt().max(TURN * heading.turn().abs());
    }
    let point = angle.circle();
    [point.cos, point.sin]
}
