//! The motion just after an instant in any mode: Taylor coefficients of conditions, switches and events, without compilation of the law
//! of the mode.
//!
//! Accelerations are compiled once, with every switch and every reaction of a contact as an input. Switches of held conditions follow
//! order by order from g' = 0, reactions of closed contacts from gap'' = 0 and v' = 0; these equations are linear in the unknowns.

mod accelerations;
mod closed_gaps;
mod distribution;
mod elimination;
mod equations;
mod exact_impulses;
mod impact_in_space;
mod impact_law;
mod impulses;
mod letters;
mod parts;
mod shared_impacts;
mod simultaneous_impacts;
mod trials;

pub(super) use accelerations::{Accelerations, Reacting};
pub(super) use elimination::solved;
pub(super) use impact_law::NotStruck;
pub(super) use letters::direction;
pub(super) use parts::Slopes;

use letters::Quantity;

use super::contacts::PARTS;
use super::jet::{Jet, ROUNDING};
use super::mode::{Case, Mode};
use super::multiples::Mirrored;
use crate::compiled_system::NotCompiled;
use model::{Model, Restitution, Sides};
use num_traits::{One, Zero};
use symbolic::{Tape, apart};

/// The assumed error of time and of each component of a state, in roundings.
const ROUNDINGS: f64 = 4.0;

/// An upper limit of the assumed relative error of rates.
const DIGITS: f64 = 1e-12;

/// An upper limit of the assumed error of a switch, which lies between 0 and 1.
const KNOWN: f64 = 1e-9;

/// The number of Newton steps for laws that are linear up to rounding.
const ROUNDS: usize = 3;

/// The largest number of Newton steps for laws with products of unknowns.
const MOST_ROUNDS: usize = 20;

/// The compiled function of a model: its inputs are the state, the time, and the symbols (switches, reactions, algebraic speeds).
#[derive(Debug)]
pub(super) struct Expansions {
    tape: Tape,
    states: usize,
    positions: usize,
    /// The nonzero derivatives of rows by symbols. Symbols are switches, then the reactions of each contact; rows are the rates of
    /// conditions, then for each reaction the equation that determines it.
    slopes: Vec<Slope>,
    /// For each condition: the condition whose positive or negative multiple it is, if any.
    pub mirrored: Vec<Option<Mirrored>>,
    /// The properties of each contact.
    pub kinds: Vec<Kind>,
    /// For each condition: true if it contains an algebraic speed, so that the mode determines its value.
    pub direct_conditions: Vec<bool>,
    /// The number of algebraic speeds and multipliers of their constraints, and the indices of these speeds.
    algebraic: usize,
    algebraic_speeds: Vec<usize>,
    /// Indices of the state components that are integrated: all except algebraic speeds, which the mode determines, and impulses, on
    /// which nothing depends.
    summed: Vec<usize>,
    events: usize,
}

/// The properties of a contact that do not change.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kind {
    /// One-sided or two-sided.
    pub sides: Sides,
    /// True if it has a coefficient of friction.
    pub is_rough: bool,
    /// The law of impact.
    pub law: Restitution,
    /// True if the contact is a guide that the coordinates satisfy.
    pub is_guide: bool,
    /// True if its gap is a speed, as for a diode or a freewheel.
    pub is_one_way: bool,
    /// True if it has two tangents.
    pub is_in_space: bool,
    /// True if its gap is an algebraic speed, which the mode determines.
    pub is_direct: bool,
}

/// The derivative of a row by a symbol, and the symbols on which this derivative depends.
#[derive(Debug)]
struct Slope {
    row: usize,
    by: usize,
    changed_by: Vec<usize>,
}

/// The Taylor series of the quantities of a contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touching<const N: usize> {
    /// Distance, m; for a diode its current, A, for a freewheel a speed, rad/s.
    pub gap: Jet<N>,
    /// Rate of the gap, m/s.
    pub gap_rate: Jet<N>,
    /// Sliding velocity along the first tangent, m/s.
    pub slide: Jet<N>,
    /// Sliding velocity along the second tangent, m/s; zero in the plane.
    pub aside: Jet<N>,
    /// Coefficient of friction.
    pub friction: Jet<N>,
    /// Normal reaction, then friction along each tangent, N.
    pub reactions: [Jet<N>; PARTS],
    /// True if it has two tangents.
    pub is_in_space: bool,
}

/// The instant and state from which a motion continues.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant<'a> {
    /// The time, s.
    pub time: f64,
    /// Coordinates, then speeds.
    pub state: &'a [f64],
    /// The error of the time of the last event, s.
    pub late: f64,
    /// Rates of the state before the event, for an error estimate of the state. Empty without algebraic speeds: held quantities are then
    /// set to zero.
    pub before: &'a [f64],
}

impl<'a> Instant<'a> {
    /// An instant and a state that are known exactly.
    pub fn at(time: f64, state: &'a [f64]) -> Self {
        Instant { time, state, late: 0.0, before: &[] }
    }
}

/// Taylor series of the motion in a mode, from an instant on; N coefficients each.
#[derive(Clone, Debug)]
pub(super) struct Expansion<const N: usize> {
    /// The rates of the state.
    pub rates: Vec<Jet<N>>,
    /// The expressions of the conditions.
    pub conditions: Vec<Jet<N>>,
    /// The value of each switch: 0, 1, or the value for which the condition stays at zero.
    pub switches: Vec<Jet<N>>,
    /// The switches; for a switch at its bound the value that it would have without the bound.
    pub parts: Vec<Jet<N>>,
    /// The contacts.
    pub contacts: Vec<Touching<N>>,
    /// The expressions of the events of the model.
    pub events: Vec<Jet<N>>,
    /// Derivatives of the rates of conditions by the switches, including the effect of the reactions that depend on these.
    pub slopes: Slopes<N>,
    /// The residuals of the hidden constraints of the mode.
    pub hidden: Vec<Jet<N>>,
    /// For each condition: true if the mode determines its value.
    pub is_direct: Vec<bool>,
}

impl<const N: usize> Expansion<N> {
    /// The distances of a switch from 0 and from 1.
    pub fn margins(&self, switch: usize) -> [Jet<N>; 2] {
        let mut part = self.parts[switch];
        part.doubts[0] = part.doubts[0].min(KNOWN);
        [part, Jet::one() - part]
    }
}

impl Expansions {
    /// Compiles the function of a model.
    ///
    /// # Errors
    /// The equations of motion are singular, or an expression has no value.
    pub fn of(model: &Model) -> Result<Self, NotCompiled> {
        apart(|| equations::expansions(model))
    }

    /// The motion in a mode; `None` if the mode does not determine it.
    pub fn at<const N: usize>(&self, instant: &Instant<'_>, mode: &Mode) -> Option<Expansion<N>> {
        let mut unknown = self.held(mode);
        unknown.extend(self.unknown_reactions(mode));
        unknown.extend(self.algebraic());
        self.with_unknown(instant, mode, &unknown)
    }

    /// The values at a state, with its own algebraic speeds and without reactions.
    pub fn as_given(&self, instant: &Instant<'_>, mode: &Mode) -> Option<Expansion<1>> {
        self.with_unknown(instant, mode, &[])
    }

    fn with_unknown<const N: usize>(
        &self,
        instant: &Instant<'_>,
        mode: &Mode,
        unknown: &[usize],
    ) -> Option<Expansion<N>> {
        let Instant { time, state, late, before } = *instant;
        let mut clock = Jet::<N>::constant(time, ROUNDINGS * ROUNDING * time.abs() + late);
        if N > 1 {
            clock.terms[1] = 1.0;
        }
        let uncertain = |value: &f64| Jet::constant(*value, ROUNDINGS * ROUNDING * value.abs());
        let mut moved: Vec<Jet<N>> = state.iter().map(uncertain).collect();
        let value = |case: &Case| case.fixed().map_or(0.5, |on| if on { 1.0 } else { 0.0 });
        let mut letters: Vec<f64> = mode.cases.iter().map(value).collect();
        letters.resize(self.letters(), 0.0);
        let confirmed = self.confirmed(time, state, &letters);
        let first = self.shorter::<1, N>((clock, &moved), mode, &confirmed, unknown)?;
        // errors of rates accumulate from the start, but not beyond the assumed accuracy
        let sizes = self.summed.iter().map(|&place| first[place].terms[0].abs());
        let known = DIGITS * sizes.fold(0.0, f64::max);
        let before = before.iter().copied().chain(std::iter::repeat(0.0));
        for ((part, rate), before) in moved.iter_mut().zip(&first).zip(before) {
            let own = (rate.doubts[0] + ROUNDINGS * ROUNDING * rate.terms[0].abs()).min(known);
            let moved = time.abs() * own + late * rate.terms[0].abs().max(before.abs());
            // in an inconsistent case an exponential may overflow
            part.doubts[0] += if moved.is_finite() { moved } else { 0.0 };
        }
        for order in 0..N - 1 {
            let at = (clock, &*moved);
            // only terms up to this order are known
            let rates = match order {
                0 => self.shorter::<1, N>(at, mode, &confirmed, unknown),
                1 => self.shorter::<2, N>(at, mode, &confirmed, unknown),
                2 => self.shorter::<3, N>(at, mode, &confirmed, unknown),
                3 => self.shorter::<4, N>(at, mode, &confirmed, unknown),
                _ => self.shorter::<N, N>(at, mode, &confirmed, unknown),
            }?;
            moved.iter_mut().zip(&rates).for_each(|(part, rate)| part.follow(rate, order));
        }
        self.run((clock, &moved), mode, &confirmed, unknown)
    }

    /// Rates of the state from the first K terms.
    fn shorter<const K: usize, const N: usize>(
        &self,
        (time, state): (Jet<N>, &[Jet<N>]),
        mode: &Mode,
        confirmed: &[f64],
        unknown: &[usize],
    ) -> Option<Vec<Jet<N>>> {
        let state: Vec<Jet<K>> = state.iter().map(Jet::resized).collect();
        let found = self.run((time.resized(), &state), mode, confirmed, unknown)?;
        Some(found.rates.iter().map(Jet::resized).collect())
    }

    /// Sets the cases of mirrored conditions to those that follow from the original conditions.
    pub fn mirror(&self, mode: &mut Mode) {
        let mode = &mut mode.cases;
        for (place, mirrored) in self.mirrored.iter().enumerate() {
            if let Some(Mirrored { of, same_side }) = *mirrored {
                mode[place] = match (mode[of], same_side) {
                    (Case::On, false) => Case::Off,
                    (Case::Off, false) => Case::On,
                    (Case::Spent { on }, false) => Case::Spent { on: !on },
                    (case, _) => case,
                };
            }
        }
    }

    /// The motion from a time and a state, solved for the unknown symbols. `confirmed` has the fractions of the error bounds that trials
    /// confirm.
    fn run<const N: usize>(
        &self,
        (time, state): (Jet<N>, &[Jet<N>]),
        mode: &Mode,
        confirmed: &[f64],
        unknown: &[usize],
    ) -> Option<Expansion<N>> {
        let value = |case: &Case| match case {
            Case::Shared => Jet::constant(0.5, 0.0),
            case if case.fixed() == Some(true) => Jet::one(),
            _ => Jet::zero(),
        };
        let cases = mode.cases.len();
        let mut letters: Vec<Jet<N>> = mode.cases.iter().map(value).collect();
        letters.resize(self.letters(), Jet::zero());
        // the iteration starts from the last values: they give friction that is proportional to an unknown a bound
        for (letter, speed) in self.algebraic().zip(&self.algebraic_speeds) {
            let last = state[self.positions + speed];
            letters[letter] = if unknown.is_empty() { last } else { Jet::constant(last.terms[0], 0.0) };
        }
        let mut hidden = Vec::new();
        let mut values = self.values(time, state, &letters, confirmed);
        let tied = self.tied(mode, &values);
        if !unknown.is_empty() {
            let first = self.states + cases;
            let rounds = self.rounds(unknown);
            for round in 1..=rounds {
                let row_of = |letter: usize| -values[first + letter];
                let right = |row: usize| {
                    let rate =
                        if self.is_value(unknown[row]) { row_of(self.letters() + unknown[row]) } else { Jet::zero() };
                    [row_of(unknown[row]), rate]
                };
                let (changes, left) = self.solved_for((&values, &tied), unknown, right)?;
                hidden = left;
                let is_found = unknown.iter().zip(&changes).all(|(&letter, change)| change.is_beside(&letters[letter]));
                let is_last = round >= ROUNDS && is_found || round == rounds;
                for (&letter, change) in unknown.iter().zip(changes) {
                    // the start of a step is taken as exact, the end has the error of the step
                    let found = letters[letter].exact() + change;
                    letters[letter] = if is_last { found } else { found.exact() };
                }
                for (contact, factor) in tied.iter().enumerate() {
                    for (factor, part) in factor.iter().flatten().zip(1..) {
                        letters[self.reaction([contact, part])] = *factor * letters[self.reaction([contact, 0])];
                    }
                }
                values = self.values(time, state, &letters, confirmed);
                if is_last {
                    break;
                }
            }
        }
        self.distribute(mode, (&values, &tied), unknown, &mut letters);
        let following: Vec<usize> = unknown.iter().copied().filter(|letter| *letter >= cases).collect();
        let slopes = self.slopes_of(cases, &values, &tied, &following)?;
        let touching = |contact: usize| Touching {
            gap: self.of_contact(&values, Quantity::Gap, contact),
            gap_rate: self.of_contact(&values, Quantity::GapRate, contact),
            slide: self.of_contact(&values, Quantity::Slide, contact),
            aside: self.of_contact(&values, Quantity::Aside, contact),
            friction: self.of_contact(&values, Quantity::Friction, contact),
            reactions: std::array::from_fn(|part| letters[self.reaction([contact, part])]),
            is_in_space: self.kinds[contact].is_in_space,
        };
        let contacts = (0..self.kinds.len()).map(touching).collect();
        letters.truncate(cases);
        let mut switches = letters;
        let mut parts = self.shared(&mode.cases, &slopes, &switches)?;
        for switch in (0..cases).filter(|&switch| mode.cases[switch].fixed().is_none()) {
            switches[switch] = parts[switch];
        }
        for (place, mirrored) in self.mirrored.iter().enumerate() {
            if let Some(Mirrored { of, same_side }) = *mirrored {
                let own = |all: &[Jet<N>]| if same_side { all[of] } else { Jet::one() - all[of] };
                (switches[place], parts[place]) = (own(&switches), own(&parts));
            }
        }
        let events = values.split_off(values.len() - self.events);
        let conditions = values[self.states..][..cases].to_vec();
        values.truncate(self.states);
        Some(Expansion {
            rates: values,
            conditions,
            switches,
            parts,
            contacts,
            events,
            slopes,
            hidden,
            is_direct: self.direct_conditions.clone(),
        })
    }

    fn values<const N: usize>(
        &self,
        time: Jet<N>,
        state: &[Jet<N>],
        letters: &[Jet<N>],
        confirmed: &[f64],
    ) -> Vec<Jet<N>> {
        let constants: Vec<Jet<N>> = self
            .tape
            .rounded()
            .iter()
            .map(|value| Jet::constant(*value, if value.fract() == 0.0 { 0.0 } else { ROUNDING * value.abs() }))
            .collect();
        let mut values = vec![Jet::zero(); self.tape.outputs()];
        let inputs = state.iter().chain([&time]).chain(letters).copied();
        self.tape.evaluate_long(&constants, inputs, &mut values);
        for (value, part) in values.iter_mut().zip(confirmed) {
            value.doubts = value.doubts.map(|doubt| doubt * part);
        }
        values
    }
}
