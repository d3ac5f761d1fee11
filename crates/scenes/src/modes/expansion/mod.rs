//! The motion just after an instant in any mode: Taylor coefficients of conditions, switches and events, without compiling its law.
//!
//! Accelerations are recorded once, with every switch and every reaction of a contact as an input. Held switches follow
//! order by order from g' = 0, reactions of closed contacts from gap'' = 0 and v' = 0; these equations are linear in them.

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
use elimination::{Row, with_hidden};
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

/// The assumed error of each number of a state and of the time, in roundings.
const ROUNDINGS: f64 = 4.0;

/// The assumed relative accuracy of rates, if their error bound is larger.
const DIGITS: f64 = 1e-12;

/// The assumed accuracy of a switch, which lies between 0 and 1, if its error bound is larger.
const KNOWN: f64 = 1e-9;

/// Steps of Newton's method for laws that are linear up to rounding.
const ROUNDS: usize = 3;

/// Steps of Newton's method for laws with products of unknowns.
const MOST_ROUNDS: usize = 20;

/// A model as a function of the time, the state and the switches.
#[derive(Debug)]
pub(super) struct Expansions {
    tape: Tape,
    states: usize,
    positions: usize,
    /// The nonzero derivatives of rows by letters. Letters are switches, then the reactions of each contact; rows are the rates of
    /// conditions, then for each reaction the equation that determines it.
    slopes: Vec<Slope>,
    pub mirrored: Vec<Option<Mirrored>>,
    pub kinds: Vec<Kind>,
    /// Whether the mode determines the value of each condition, since the condition contains an algebraic speed.
    pub direct_conditions: Vec<bool>,
    /// The number of algebraic speeds, with the multipliers of their constraints; the speeds, which stand first.
    algebraic: usize,
    algebraic_speeds: Vec<usize>,
    /// States in which errors of rates accumulate: not algebraic speeds, which the mode determines, nor impulses, on which nothing depends.
    summed: Vec<usize>,
    events: usize,
}

/// A contact as it is built.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kind {
    pub sides: Sides,
    pub is_rough: bool,
    pub law: Restitution,
    /// Whether the coordinates keep the body in it.
    pub is_guide: bool,
    /// Whether its gap is a speed.
    pub is_one_way: bool,
    /// Whether it slides in two directions.
    pub is_in_space: bool,
    /// Whether the mode determines this speed.
    pub is_direct: bool,
}

/// The slope of a row by a letter, and the letters that change it.
#[derive(Debug)]
struct Slope {
    row: usize,
    by: usize,
    changed_by: Vec<usize>,
}

/// A contact along the motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touching<const N: usize> {
    pub gap: Jet<N>,
    pub gap_rate: Jet<N>,
    pub slide: Jet<N>,
    /// Along the second tangent; zero in the plane.
    pub aside: Jet<N>,
    pub friction: Jet<N>,
    /// Normal and tangential.
    pub reactions: [Jet<N>; PARTS],
    pub is_in_space: bool,
}

/// The instant and state from which a motion continues.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant<'a> {
    pub time: f64,
    pub state: &'a [f64],
    /// The error of the time of the event that led here.
    pub late: f64,
    /// Rates of the state before the event, from which the error of the state is estimated. Empty for a system
    /// without algebraic speeds, in which held quantities are set to zero.
    pub before: &'a [f64],
}

impl<'a> Instant<'a> {
    /// An instant and a state that are known exactly.
    pub fn at(time: f64, state: &'a [f64]) -> Self {
        Instant { time, state, late: 0.0, before: &[] }
    }
}

/// Quantities along the motion from an instant on.
#[derive(Clone, Debug)]
pub(super) struct Expansion<const N: usize> {
    pub rates: Vec<Jet<N>>,
    pub conditions: Vec<Jet<N>>,
    pub switches: Vec<Jet<N>>,
    /// Each switch; for a switch at its bound, the share that it would have without the bound.
    pub parts: Vec<Jet<N>>,
    pub contacts: Vec<Touching<N>>,
    pub events: Vec<Jet<N>>,
    /// Derivatives of the rates of conditions by the values of switches, including the reactions that follow from these.
    pub slopes: Slopes<N>,
    /// Constraints that the mode hides: of positions, or of speeds with inertia.
    pub hidden: Vec<Jet<N>>,
    /// Whether the mode determines the value of each condition.
    pub is_direct: Vec<bool>,
}

impl<const N: usize> Expansion<N> {
    /// The distances of a switch, or of its part, from 0 and from 1.
    pub fn margins(&self, switch: usize) -> [Jet<N>; 2] {
        let mut part = self.parts[switch];
        part.doubts[0] = part.doubts[0].min(KNOWN);
        [part, Jet::one() - part]
    }
}

impl Expansions {
    pub fn of(model: &Model) -> Result<Self, NotCompiled> {
        apart(|| equations::expansions(model))
    }

    /// The motion in a mode; none if a condition cannot be held.
    pub fn at<const N: usize>(&self, instant: &Instant<'_>, mode: &Mode) -> Option<Expansion<N>> {
        let mut unknown = self.held(mode);
        unknown.extend(self.unknown_reactions(mode));
        unknown.extend(self.algebraic());
        self.with_unknown(instant, mode, &unknown)
    }

    /// Values at a given state, with its algebraic speeds and without reactions.
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
        // errors of rates accumulate from the start; the roundings do not decide a run with fewer digits than this
        let sizes = self.summed.iter().map(|&place| first[place].terms[0].abs());
        let known = DIGITS * sizes.fold(0.0, f64::max);
        let before = before.iter().copied().chain(std::iter::repeat(0.0));
        for ((part, rate), before) in moved.iter_mut().zip(&first).zip(before) {
            let own = (rate.doubts[0] + ROUNDINGS * ROUNDING * rate.terms[0].abs()).min(known);
            let moved = time.abs() * own + late * rate.terms[0].abs().max(before.abs());
            // in a case that does not hold an exponential may overflow
            part.doubts[0] += if moved.is_finite() { moved } else { 0.0 };
        }
        for order in 0..N - 1 {
            let at = (clock, &*moved);
            // terms beyond this order are not known yet
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

    /// Rates by the first terms alone.
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

    /// Gives mirrored conditions the cases that follow from those of others.
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

    /// The motion from a time and a state, solved for the unknown letters; `confirmed` has the fractions of the error bounds that trials confirm.
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
        // the iteration starts from the last values, at which friction that is proportional to them has a bound
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
                    // the step begins at an exact number and ends at one with the error of the step
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

    /// The values of unknown letters for which their rows have the given right sides, with their rates; and hidden constraints.
    fn solved_for<const N: usize>(
        &self,
        (values, tied): (&[Jet<N>], &[Option<[Jet<N>; 2]>]),
        unknown: &[usize],
        right: impl Fn(usize) -> [Jet<N>; 2],
    ) -> Option<(Vec<Jet<N>>, Vec<Jet<N>>)> {
        let slopes = self.slopes_by(values, tied, unknown, unknown);
        if self.algebraic == 0 {
            let right = (0..unknown.len()).map(|row| right(row)[0]).collect();
            return Some((solved(slopes, right)?, Vec::new()));
        }
        let rates: Vec<usize> = unknown.iter().map(|letter| self.letters() + letter).collect();
        let of_rates = self.slopes_by(values, tied, &rates, unknown);
        let row = |(place, (slopes, of_rate)): (usize, (Vec<Jet<N>>, Vec<Jet<N>>))| {
            let [right, right_of_rate] = right(place);
            Row { slopes, right, rate: self.is_value(unknown[place]).then_some((of_rate, right_of_rate)) }
        };
        with_hidden(&slopes.into_iter().zip(of_rates).enumerate().map(row).collect::<Vec<_>>())
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
