//! The symbols of the compiled function (switches, reactions, algebraic speeds): those that a mode leaves unknown, and derivatives of
//! rows by them.

use super::super::contacts::{PARTS, unknown};
use super::super::jet::Jet;
use super::super::mode::{Case, Heading, Mode, Phase};
use super::{Expansions, MOST_ROUNDS, ROUNDS, Slope};
use field::{Analytic, Scalar};
use num_traits::Zero;
use std::ops::Range;

/// Quantities of a contact, in the order of the outputs of the compiled function.
#[derive(Clone, Copy)]
pub(super) enum Quantity {
    /// The distance, m.
    Gap,
    /// The rate of the gap, m/s.
    GapRate,
    /// The sliding velocity along the first tangent, m/s.
    Slide,
    /// The sliding velocity along the second tangent, m/s.
    Aside,
    /// The coefficient of friction.
    Friction,
    /// The coefficient of restitution.
    Restitution,
}

impl Expansions {
    /// The number of symbols: switches, reactions, algebraic speeds, multipliers of their constraints.
    pub(super) fn letters(&self) -> usize {
        self.mirrored.len() + PARTS * self.kinds.len() + self.algebraic
    }

    /// True if the model has algebraic speeds.
    pub fn has_algebraic(&self) -> bool {
        self.algebraic > 0
    }

    /// The indices of the symbols of algebraic speeds and of their multipliers.
    pub(super) fn algebraic(&self) -> Range<usize> {
        self.letters() - self.algebraic..self.letters()
    }

    /// The number of rows: one for each symbol, and with algebraic speeds one more for its rate.
    pub(super) fn rows(&self) -> usize {
        if self.has_algebraic() { 2 * self.letters() } else { self.letters() }
    }

    /// True if the row of a symbol is an equation for a value, which the mode determines, instead of a rate.
    pub(super) fn is_value(&self, letter: usize) -> bool {
        let cases = self.mirrored.len();
        match letter.checked_sub(cases) {
            None => self.direct_conditions[letter],
            Some(place) => self.kinds.get(place / PARTS).is_none_or(|kind| kind.is_direct && place % PARTS == 0),
        }
    }

    /// The number of Newton steps for unknown symbols: one if the rows are linear in them. A law of g that contains |g| is linear at g =
    /// 0 up to rounding.
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

    /// The indices of conditions that a mode holds at zero, without those that mirror another condition.
    pub fn held(&self, mode: &Mode) -> Vec<usize> {
        let is_held = |place: &usize| mode.cases[*place] == Case::Held && self.mirrored[*place].is_none();
        (0..mode.cases.len()).filter(is_held).collect()
    }

    /// The index of the symbol of a reaction.
    pub(super) fn reaction(&self, [contact, component]: [usize; 2]) -> usize {
        self.mirrored.len() + PARTS * contact + component
    }

    /// The indices of the symbols of the unknown reactions of a mode.
    pub(super) fn unknown_reactions(&self, mode: &Mode) -> Vec<usize> {
        unknown(mode, |contact| self.kinds[contact].is_in_space).into_iter().map(|of| self.reaction(of)).collect()
    }

    /// The indices of the symbols of unknown reactions that depend on accelerations.
    pub(super) fn inertial_reactions(&self, mode: &Mode) -> Vec<usize> {
        let mut letters = self.unknown_reactions(mode);
        letters.retain(|&letter| !self.is_value(letter));
        letters
    }

    /// For each sliding contact, the factors T/N along each tangent; `None` for other contacts.
    pub(super) fn tied<const N: usize>(&self, mode: &Mode, values: &[Jet<N>]) -> Vec<Option<[Jet<N>; 2]>> {
        let of = |(contact, phase): (usize, &Phase)| {
            let against = Jet::constant(-phase.face()?.sign(), 0.0);
            let most = against * self.of_contact(values, Quantity::Friction, contact);
            Some(self.way(values, contact, *phase)?.map(|along| most * along))
        };
        mode.phases.iter().enumerate().map(of).collect()
    }

    /// The unit vector of sliding of a contact, which friction opposes; `None` if the contact does not slide.
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

    /// The value of a quantity of a contact in the outputs of the compiled function.
    pub(super) fn of_contact<S: Scalar>(&self, values: &[S], quantity: Quantity, contact: usize) -> S {
        let first = self.states + self.mirrored.len() + self.rows() + self.slopes.len();
        values[first + quantity as usize * self.kinds.len() + contact]
    }

    /// Derivatives of rows by symbols. For a sliding contact the derivative by N includes that by T, since T = factor N.
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

/// The relative accuracy of the rate of rotation of a direction.
const TURN: f64 = 1e-10;

/// The unit vector of a direction, with its rate of rotation.
pub(in super::super) fn direction<const N: usize>(heading: Heading) -> [Jet<N>; 2] {
    let mut angle = Jet::constant(heading.angle(), heading.doubt());
    if N > 1 {
        angle.terms[1] = heading.turn();
        angle.doubts[1] = heading.doubt().max(TURN * heading.turn().abs());
    }
    let point = angle.circle();
    [point.cos, point.sin]
}
