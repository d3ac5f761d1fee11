//! Accelerations of contacts, and linear equations for reactions, at one state in many modes.
//!
//! If the rows are linear in switches and reactions, they and their derivatives are evaluated once, and each mode needs one elimination.

use super::super::contacts::PARTS;
use super::super::jet::Jet;
use super::super::mode::Mode;
use super::letters::Quantity;
use super::{Expansions, Instant, solved};
use nalgebra::{DMatrix, DVector};

/// An acceleration below this part of the largest term of its sum is a rounding error.
const ROUNDED: f64 = 1e-12;

/// The rows and their derivatives at a state, for given cases of conditions.
pub(in super::super) struct Accelerations<'a> {
    expansions: &'a Expansions,
    values: Vec<Jet<1>>,
}

/// The linear equations of a mode: slopes times unknowns = right.
pub(in super::super) struct Equations {
    pub slopes: DMatrix<f64>,
    pub right: DVector<f64>,
    /// The largest error bound of the right sides.
    pub doubt: f64,
    unknown: Vec<usize>,
    tied: Vec<Option<[Jet<1>; 2]>>,
}

/// A contact with its reactions and accelerations.
pub(in super::super) struct Reacting {
    /// The normal reaction, then friction along both tangents, N.
    pub reactions: [f64; PARTS],
    /// The accelerations along normal and tangents, m/s².
    pub accelerations: [f64; PARTS],
    /// The coefficient of friction.
    pub friction: f64,
}

impl<'a> Accelerations<'a> {
    /// Evaluates the rows; `None` if they are not linear or there are algebraic speeds.
    pub fn of(expansions: &'a Expansions, Instant { time, state, .. }: &Instant<'_>, mode: &Mode) -> Option<Self> {
        if expansions.has_algebraic() || expansions.slopes.iter().any(|slope| !slope.changed_by.is_empty()) {
            return None;
        }
        let exact = |value: f64| Jet::constant(value, 0.0);
        let parts: Vec<Jet<1>> = state.iter().map(|&part| exact(part)).collect();
        let letters = expansions.letters_in(&mode.cases);
        Some(Accelerations { expansions, values: expansions.values(exact(*time), &parts, &letters, &[]) })
    }

    /// Accelerations along both tangents of each contact in a mode, m/s²; NaN if they are rounding errors. `None` if the reactions are
    /// not determined.
    pub fn along_tangents(&self, mode: &Mode) -> Option<Vec<[f64; 2]>> {
        let (tied, unknown) = self.unknown(mode);
        let slopes = self.expansions.slopes_by(&self.values, &tied, &unknown, &unknown);
        let found = solved(slopes, unknown.iter().map(|&letter| -self.row(mode, letter)).collect())?;
        let tangents: Vec<usize> =
            (0..tied.len()).flat_map(|contact| [1, 2].map(|part| self.letter(contact, part))).collect();
        let rates = self.rows(mode, &tangents, (&tied, &unknown), &found);
        let or_none = |pair: &[[f64; 2]; PARTS - 1]| {
            let [[along, _], [aside, _]] = *pair;
            let among = pair.iter().map(|[_, among]| *among).fold(0.0, f64::max);
            if along.hypot(aside) > ROUNDED * among { [along, aside] } else { [f64::NAN; 2] }
        };
        Some(rates.as_chunks::<{ PARTS - 1 }>().0.iter().map(or_none).collect())
    }

    /// The linear equations of a mode.
    pub fn equations(&self, mode: &Mode) -> Equations {
        let (tied, unknown) = self.unknown(mode);
        let slopes = self.expansions.slopes_by(&self.values, &tied, &unknown, &unknown);
        let slopes = DMatrix::from_fn(unknown.len(), unknown.len(), |row, column| slopes[row][column].terms[0]);
        let rows = || unknown.iter().map(|&letter| self.row(mode, letter));
        let doubt = rows().map(|row| row.doubts[0]).fold(0.0, f64::max);
        let right = DVector::from_iterator(unknown.len(), rows().map(|row| -row.terms[0]));
        Equations { slopes, right, doubt, unknown, tied }
    }

    /// The contacts of a mode for values `found` of its unknowns.
    pub fn contacts(
        &self,
        mode: &Mode,
        Equations { unknown, tied, .. }: &Equations,
        found: &DVector<f64>,
    ) -> Vec<Reacting> {
        let found: Vec<Jet<1>> = found.iter().map(|&value| Jet::constant(value, 0.0)).collect();
        let all: Vec<usize> = (0..tied.len())
            .flat_map(|contact| (0..PARTS).map(move |part| (contact, part)))
            .map(|(contact, part)| self.letter(contact, part))
            .collect();
        let accelerations: Vec<f64> =
            self.rows(mode, &all, (tied, unknown), &found).into_iter().map(|[rate, _]| rate).collect();
        let known =
            |letter: usize| unknown.iter().position(|own| *own == letter).map_or(0.0, |place| found[place].terms[0]);
        let of = |(contact, accelerations): (usize, &[f64; PARTS])| {
            let normal = known(self.letter(contact, 0));
            let tangential = |part: usize| match tied[contact] {
                Some(factors) => factors[part - 1].terms[0] * normal,
                None => known(self.letter(contact, part)),
            };
            Reacting {
                reactions: [normal, tangential(1), tangential(2)],
                accelerations: *accelerations,
                friction: self.expansions.of_contact(&self.values, Quantity::Friction, contact).terms[0],
            }
        };
        accelerations.as_chunks::<PARTS>().0.iter().enumerate().map(of).collect()
    }

    fn unknown(&self, mode: &Mode) -> (Vec<Option<[Jet<1>; 2]>>, Vec<usize>) {
        let mut unknown = self.expansions.held(mode);
        unknown.extend(self.expansions.unknown_reactions(mode));
        (self.expansions.tied(mode, &self.values), unknown)
    }

    fn letter(&self, contact: usize, part: usize) -> usize {
        self.expansions.reaction([contact, part])
    }

    /// The value of the row of a symbol, with all unknowns zero.
    fn row(&self, mode: &Mode, letter: usize) -> Jet<1> {
        self.values[self.expansions.states + mode.cases.len() + letter]
    }

    /// Values of rows for values of the unknowns, each with its largest term.
    fn rows(
        &self,
        mode: &Mode,
        letters: &[usize],
        (tied, unknown): (&[Option<[Jet<1>; 2]>], &[usize]),
        found: &[Jet<1>],
    ) -> Vec<[f64; 2]> {
        let moved = self.expansions.slopes_by(&self.values, tied, letters, unknown);
        let of = |(&letter, slopes): (&usize, &Vec<Jet<1>>)| {
            let own = self.row(mode, letter).terms[0];
            let terms = slopes.iter().zip(found).map(|(slope, one)| slope.terms[0] * one.terms[0]);
            terms.fold([own, own.abs()], |[sum, among], term| [sum + term, among.max(term.abs())])
        };
        letters.iter().zip(&moved).map(of).collect()
    }
}
