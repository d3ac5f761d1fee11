//! Impulses: corrections that return held conditions and closed contacts to zero, and impacts.

use super::super::contacts::PARTS;
use super::super::jet::{Jet, ROUNDING};
use super::super::mode::{Case, Mode, Phase};
use super::impact_in_space::Struck;
use super::impact_law::{Impact, NotStruck};
use super::letters::Quantity;
use super::{Expansion, Expansions, Instant, Kind, ROUNDINGS, Touching};
use field::Scalar;
use integrators::Real;
use model::Sides;
use nalgebra::DMatrix;
use num_traits::{One, Zero};

/// Steps of Newton's method to remove the residuals of an integration.
pub(super) const IMPULSES: usize = 3;

/// A change counts if it exceeds its error bound by this factor.
const CHANGES: f64 = 16.0;

impl Expansions {
    /// The changes of the rates of the state by a unit of each of the symbols `letters`, at given values of all symbols.
    pub(super) fn responses(
        &self,
        clock: Jet<1>,
        state: &[Jet<1>],
        all: &[Jet<1>],
        letters: &[usize],
    ) -> Vec<Vec<f64>> {
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

    /// Corrects the speeds so that held conditions and closed contacts are at zero, by impulses of the forces that hold them; these
    /// preserve the constraints. Returns whether the impulses are determined.
    pub fn return_to_zero(&self, time: f64, state: &mut [f64], mode: &Mode, slack: f64) -> bool {
        self.return_to(time, state, mode, slack, |_| [0.0; 2])
    }

    /// Corrects the speeds so that each held contact has a given sliding velocity, m/s, by impulses of the forces that hold the contact.
    /// Returns whether the impulses are determined.
    pub fn return_to(
        &self,
        time: f64,
        state: &mut [f64],
        mode: &Mode,
        slack: f64,
        sliding: impl Fn(usize) -> [f64; 2],
    ) -> bool {
        let mut unknown = self.held(mode);
        unknown.extend(self.unknown_reactions(mode));
        unknown.extend(self.algebraic());
        for _ in 0..IMPULSES {
            let clock = Jet::<1>::constant(time, 0.0);
            let parts = rounded(state);
            let Some(found) = self.run((clock, &parts), mode, &[], &unknown) else { return false };
            let Expansion { conditions, contacts, switches, hidden, .. } = found;
            let off = |&letter: &usize| match letter.checked_sub(conditions.len()) {
                // an equation of values has no residual; the residual of the hidden constraint counts
                _ if self.is_value(letter) => Jet::zero(),
                None => conditions[letter],
                Some(place) => {
                    let (contact, [along, aside]) = (&contacts[place / PARTS], sliding(place / PARTS));
                    match place % PARTS {
                        0 => contact.gap_rate,
                        1 => contact.slide - Jet::constant(along, 0.0),
                        _ => contact.aside - Jet::constant(aside, 0.0),
                    }
                }
            };
            let off: Vec<Jet<1>> = unknown.iter().map(off).collect();
            if off.iter().chain(&hidden).all(|value| value.sign_of(0, slack) == 0.0) {
                return true;
            }
            let mut all = switches;
            all.resize(self.letters(), Jet::zero());
            let values = self.values(clock, &parts, &all, &[]);
            let tied = vec![None; self.kinds.len()];
            let first = self.states + conditions.len();
            // a combination of values without unknowns is a hidden constraint
            let right = |row: usize| match self.is_value(unknown[row]) {
                true => [Jet::zero(), -values[first + unknown[row]]],
                false => [-off[row], Jet::zero()],
            };
            let Some((impulses, _)) = self.solved_for((&values, &tied), &unknown, right) else { return false };
            for (impulse, added) in impulses.iter().zip(self.responses(clock, &parts, &all, &unknown)) {
                for (part, rate) in state.iter_mut().zip(added) {
                    *part += impulse.terms[0] * rate;
                }
            }
        }
        true
    }

    /// The impulses of a contact that closes, normal and along each tangent, by the values of the tape.
    pub(super) fn impulses<S: Real>(&self, values: &[S], contact: usize) -> Result<[S; PARTS], NotStruck> {
        let letters: [usize; PARTS] = std::array::from_fn(|part| self.reaction([contact, part]));
        let slopes = self.slopes_by(values, &vec![None; self.kinds.len()], &letters, &letters);
        let of = |quantity: Quantity| self.of_contact(values, quantity, contact);
        let Kind { law, is_rough, .. } = self.kinds[contact];
        let struck = Struck {
            closing: of(Quantity::GapRate),
            sliding: [of(Quantity::Slide), of(Quantity::Aside)],
            responses: std::array::from_fn(|row| std::array::from_fn(|column| slopes[row][column])),
        };
        let way = if is_rough { struck.way()? } else { [S::one(), S::zero()] };
        let (closing, sliding, responses) = struck.along(way);
        let friction = is_rough.then(|| of(Quantity::Friction));
        let impact = Impact { law, closing, sliding, responses, friction, restitution: of(Quantity::Restitution) };
        let [normal, tangent] = impact.impulses()?;
        Ok([normal, way[0] * tangent, way[1] * tangent])
    }

    /// Values of all symbols: switches by their cases, zero reactions.
    pub(super) fn letters_in<S: Scalar>(&self, cases: &[Case]) -> Vec<S> {
        let value = |case: &Case| if case.fixed() == Some(true) { S::one() } else { S::zero() };
        let mut letters: Vec<S> = cases.iter().map(value).collect();
        letters.resize(self.letters(), S::zero());
        letters
    }

    /// Changes the state by the impact of one contact, by its law of impacts. Returns the closed contacts that the impact opens. The
    /// impact must not press any closed contact.
    ///
    /// # Errors
    /// The impulses are not determined, or the impact presses other contacts; the state is then unchanged.
    pub fn struck(
        &self,
        time: f64,
        state: &mut [f64],
        (contact, cases): (usize, &[Case]),
        in_touch: &[usize],
    ) -> Result<Vec<usize>, NotStruck> {
        let clock = Jet::<1>::constant(time, 0.0);
        let parts = rounded(state);
        let letters: [usize; PARTS] = std::array::from_fn(|part| self.reaction([contact, part]));
        let all = self.letters_in::<Jet<1>>(cases);
        let values = self.values(clock, &parts, &all, &[]);
        let rounded_values: Vec<f64> = values.iter().map(|value| value.terms[0]).collect();
        let impulses = self.impulses(&rounded_values, contact)?;
        let before = state.to_vec();
        for (impulse, added) in impulses.iter().zip(self.responses(clock, &parts, &all, &letters)) {
            for (part, rate) in state.iter_mut().zip(added) {
                *part += impulse * rate;
            }
        }
        // a closed contact that opens, or continues to slide, has no impulse
        let after = self.values(clock, &rounded(state), &all, &[]);
        let mut opened = Vec::new();
        for &other in in_touch {
            let Kind { sides, is_guide, is_rough, .. } = self.kinds[other];
            let [now, then] = [&after, &values].map(|values| self.of_contact(values, Quantity::GapRate, other));
            let change = (now - then).sign_of(0, CHANGES);
            let takes_part = match is_guide {
                true => is_rough && self.presses(&values, other, (&letters, impulses)),
                false => change < 0.0 || change > 0.0 && sides == Sides::Both,
            };
            if takes_part {
                state.copy_from_slice(&before);
                return Err(NotStruck::Together);
            }
            opened.extend((change > 0.0).then_some(other));
        }
        Ok(opened)
    }

    /// True if impulses of another contact have an effect across a guide that the coordinates satisfy.
    fn presses(&self, values: &[Jet<1>], guide: usize, (letters, impulses): (&[usize], [f64; PARTS])) -> bool {
        let own = self.reaction([guide, 0]);
        let slopes = self.slopes_by(values, &vec![None; self.kinds.len()], &[own], letters);
        let parts: Vec<Jet<1>> =
            slopes[0].iter().zip(impulses).map(|(slope, impulse)| *slope * Jet::constant(impulse, 0.0)).collect();
        parts.iter().fold(Jet::zero(), |sum: Jet<1>, part| sum + *part).sign_of(0, CHANGES) != 0.0
    }

    /// The response matrix: changes of gap'' and of both components of v' of each contact by unit reactions, normal and tangential, of
    /// each contact. Three rows and columns per contact.
    pub fn responses_of_contacts(&self, Instant { time, state, .. }: &Instant<'_>) -> DMatrix<f64> {
        let letters: Vec<usize> = (0..self.kinds.len())
            .flat_map(|contact| (0..PARTS).map(move |part| self.reaction([contact, part])))
            .collect();
        let values = self.values(Jet::constant(*time, 0.0), &rounded(state), &vec![Jet::zero(); self.letters()], &[]);
        let slopes = self.slopes_by(&values, &vec![None; self.kinds.len()], &letters, &letters);
        DMatrix::from_fn(letters.len(), letters.len(), |row, column| slopes[row][column].terms[0])
    }

    /// True if an impulse along the normal of a contact changes the rate of its gap.
    pub fn yields(&self, Instant { time, state, .. }: &Instant<'_>, contact: usize) -> bool {
        let own = self.reaction([contact, 0]);
        let values = self.values(Jet::constant(*time, 0.0), &rounded(state), &vec![Jet::zero(); self.letters()], &[]);
        self.slopes_by(&values, &vec![None; self.kinds.len()], &[own], &[own])[0][0].sign_of(0, CHANGES) > 0.0
    }

    /// The coefficients of friction and restitution of a contact.
    pub fn coefficients(&self, time: f64, state: &[f64], (contact, cases): (usize, &[Case])) -> [f64; 2] {
        let values = self.values(Jet::constant(time, 0.0), &rounded(state), &self.letters_in(cases), &[]);
        [Quantity::Friction, Quantity::Restitution].map(|of| self.of_contact(&values, of, contact).terms[0])
    }

    /// The contacts at an instant without reactions. Gaps and velocities may depend on the cases of conditions.
    pub fn contacts(&self, instant: &Instant<'_>, cases: &[Case]) -> Vec<Touching<1>> {
        let settled = |case: &Case| if case.fixed() == Some(true) { Case::On } else { Case::Off };
        let phases = vec![Phase::Apart; self.kinds.len()];
        let mode = Mode { cases: cases.iter().map(settled).collect(), phases };
        self.as_given(instant, &mode).map_or_else(Vec::new, |found| found.contacts)
    }

    /// The determinant of the equations for the reactions of a mode.
    pub fn determinant(&self, Instant { time, state, .. }: &Instant<'_>, mode: &Mode) -> f64 {
        let letters = self.inertial_reactions(mode);
        let values = self.values(Jet::constant(*time, 0.0), &rounded(state), &vec![Jet::zero(); self.letters()], &[]);
        let rows = self.slopes_by(&values, &self.tied(mode, &values), &letters, &letters);
        let matrix = DMatrix::from_fn(letters.len(), letters.len(), |row, column| rows[row][column].terms[0]);
        matrix.determinant()
    }
}

/// A state with the errors of its numbers.
pub(super) fn rounded(state: &[f64]) -> Vec<Jet<1>> {
    state.iter().map(|value| Jet::constant(*value, ROUNDINGS * ROUNDING * value.abs())).collect()
}
