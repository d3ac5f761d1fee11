//! Impulses: speeds that return conditions and contacts to zero, and impacts.

use super::super::jet::{Jet, ROUNDING};
use super::super::mode::{Case, Mode, Phase};
use super::{Expansion, Expansions, Instant, ROUNDINGS, Touching, solved};
use nalgebra::DMatrix;
use num_traits::{One, Zero};

/// Newton's method from what an integration has left.
const IMPULSES: usize = 3;

/// The direction of an impulse of friction, or none where the contact sticks when the impact ends.
const WAYS: [Option<f64>; 3] = [None, Some(1.0), Some(-1.0)];

/// Why an impact is not decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum NotStruck {
    /// Other contacts in touch take part in it.
    Together,
    /// No impulse within the cone of friction, or several.
    Undetermined,
}

impl Expansions {
    /// What a unit of each of some letters adds to the rates of a state, beside the values of all.
    fn responses(&self, clock: Jet<1>, state: &[Jet<1>], all: &[Jet<1>], letters: &[usize]) -> Vec<Vec<f64>> {
        let of = |&letter: &usize| {
            let [none, one] = [Jet::zero(), Jet::one()].map(|value| {
                let mut all = all.to_vec();
                all[letter] = value;
                self.values(clock, state, &all, &[])
            });
            (0..self.states).map(|place| one[place].terms[0] - none[place].terms[0]).collect()
        };
        letters.iter().map(of).collect()
    }

    /// Takes from the speeds what held conditions, and contacts in touch, have moved off zero: impulses of the forces that hold them, so
    /// that constraints stay as they are.
    pub fn return_to_zero(&self, time: f64, state: &mut [f64], mode: &Mode, slack: f64) {
        let held = self.held(mode);
        let reactions = self.unknown_reactions(mode);
        let unknown: Vec<usize> = held.iter().chain(&reactions).copied().collect();
        for _ in 0..IMPULSES {
            let clock = Jet::<1>::constant(time, 0.0);
            let parts = rounded(state);
            let Some(Expansion { conditions, contacts, switches, .. }) = self.run(clock, &parts, mode, &[]) else {
                return;
            };
            let off = |&letter: &usize| match letter.checked_sub(conditions.len()) {
                None => conditions[letter],
                Some(place) if place % 2 == 0 => contacts[place / 2].gap_rate,
                Some(place) => contacts[place / 2].slide,
            };
            let off: Vec<Jet<1>> = unknown.iter().map(off).collect();
            if off.iter().all(|value| value.sign_of(0, slack) == 0.0) {
                return;
            }
            let mut all = switches;
            all.resize(self.letters(), Jet::zero());
            let values = self.values(clock, &parts, &all, &[]);
            let rows = self.slopes_by(&values, &vec![None; self.kinds.len()], &unknown, &unknown);
            let Some(impulses) = solved(rows, off.into_iter().map(|value| -value).collect()) else { return };
            for (impulse, added) in impulses.iter().zip(self.responses(clock, &parts, &all, &unknown)) {
                for (part, rate) in state.iter_mut().zip(added) {
                    *part += impulse.terms[0] * rate;
                }
            }
        }
    }

    /// The speeds after a contact has closed, by Newton's law of restitution and Coulomb's of impulses; other contacts must let go.
    ///
    /// # Errors
    /// Where the impulses are not determined.
    pub fn struck(&self, time: f64, state: &mut [f64], contact: usize, in_touch: &[usize]) -> Result<(), NotStruck> {
        let clock = Jet::<1>::constant(time, 0.0);
        let parts = rounded(state);
        let mut letters = vec![self.reaction([contact, 0])];
        if self.kinds[contact].is_rough {
            letters.push(self.reaction([contact, 1]));
        }
        let all = vec![Jet::zero(); self.letters()];
        let values = self.values(clock, &parts, &all, &[]);
        let slopes = self.slopes_by(&values, &vec![None; self.kinds.len()], &letters, &letters);
        let slope = |row: usize, column: usize| slopes[row][column].terms[0];
        let of = |quantity: usize, of: usize| self.of_contact(&values, quantity, of).terms[0];
        let (closing, sliding, friction) = (of(1, contact), of(2, contact), of(3, contact));
        let restitution = of(4, contact);
        let needed = -(1.0 + restitution) * closing;
        let mut found: Option<[f64; 2]> = None;
        for way in WAYS {
            let impulse = match (letters.len(), way) {
                (1, None) => [needed / slope(0, 0), 0.0],
                (1, Some(_)) => continue,
                (_, None) => {
                    let (a, b, c, d) = (slope(0, 0), slope(0, 1), slope(1, 0), slope(1, 1));
                    let determinant = a * d - b * c;
                    [(needed * d + b * sliding) / determinant, (-a * sliding - c * needed) / determinant]
                }
                (_, Some(way)) => {
                    let normal = needed / (slope(0, 0) - way * friction * slope(0, 1));
                    [normal, -way * friction * normal]
                }
            };
            let [normal, tangent] = impulse;
            let agrees = normal > 0.0
                && match way {
                    None => letters.len() == 1 || tangent.abs() <= friction * normal,
                    Some(way) => way * (sliding + slope(1, 0) * normal + slope(1, 1) * tangent) > 0.0,
                };
            if agrees && found.replace(impulse).is_some() {
                return Err(NotStruck::Undetermined);
            }
        }
        let impulse = found.ok_or(NotStruck::Undetermined)?;
        let before = state.to_vec();
        for (impulse, added) in impulse.iter().zip(self.responses(clock, &parts, &all, &letters)) {
            for (part, rate) in state.iter_mut().zip(added) {
                *part += impulse * rate;
            }
        }
        // contacts that would be pressed, or dragged along, take a part in it
        let after = self.values(clock, &rounded(state), &all, &[]);
        let is_still = |other: &usize| {
            let change = |quantity: usize| {
                let [now, then] = [&after, &values].map(|values| self.of_contact(values, quantity, *other));
                (now - then).sign_of(0, 16.0)
            };
            let drags = self.kinds[*other].is_rough && change(2) != 0.0;
            change(1) == 0.0 && !drags
        };
        if in_touch.iter().all(is_still) {
            return Ok(());
        }
        state.copy_from_slice(&before);
        Err(NotStruck::Together)
    }

    /// The contacts at an instant, apart.
    pub fn contacts(&self, instant: &Instant<'_>) -> Vec<Touching<1>> {
        let off = Mode { cases: vec![Case::Off; self.mirrored.len()], phases: vec![Phase::Apart; self.kinds.len()] };
        self.at::<1>(instant, &off).map_or_else(Vec::new, |found| found.contacts)
    }

    /// The determinant of the equations for the reactions of a mode.
    pub fn determinant(&self, Instant { time, state, .. }: &Instant<'_>, mode: &Mode) -> f64 {
        let letters = self.unknown_reactions(mode);
        let values = self.values(Jet::constant(*time, 0.0), &rounded(state), &vec![Jet::zero(); self.letters()], &[]);
        let rows = self.slopes_by(&values, &self.tied(mode, &values), &letters, &letters);
        let matrix = DMatrix::from_fn(letters.len(), letters.len(), |row, column| rows[row][column].terms[0]);
        matrix.determinant()
    }
}

/// A state with the errors of its numbers.
fn rounded(state: &[f64]) -> Vec<Jet<1>> {
    state.iter().map(|value| Jet::constant(*value, ROUNDINGS * ROUNDING * value.abs())).collect()
}
