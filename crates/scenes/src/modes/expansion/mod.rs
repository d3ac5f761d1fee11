//! The motion next after an instant in any mode: Taylor coefficients of conditions, switches and events, without compiling its law.
//!
//! Accelerations are written down once with every switch as an input. Switches that are held follow order by order from g' = 0,
//! which is linear in them.

mod elimination;
mod equations;
mod impulses;
mod parts;
mod trials;

pub(super) use elimination::solved;
pub(super) use parts::Slopes;

use super::Case;
use super::jet::{Jet, ROUNDING};
use super::multiples::Mirrored;
use crate::compiled_system::NotCompiled;
use model::Model;
use num_traits::{One, Zero};
use symbolic::{Tape, apart};

/// The number of roundings by which each number of a state, and the time, may be off.
const ROUNDINGS: f64 = 4.0;

/// Rates are known to so much of the largest, whatever the bound of their errors.
const DIGITS: f64 = 1e-12;

/// A switch, which lies between 0 and 1, is known to so much, whatever the bound of its error.
const KNOWN: f64 = 1e-9;

/// Newton's method from laws that are linear but for rounding.
const ROUNDS: usize = 3;

/// A model as a function of the time, the state and the switches.
#[derive(Debug)]
pub(super) struct Expansions {
    tape: Tape,
    states: usize,
    /// Slopes of the rates of conditions by switches, where they are not zero.
    slopes: Vec<Slope>,
    pub mirrored: Vec<Option<Mirrored>>,
    events: usize,
}

/// The slope of the rate of a condition by a switch, and the switches that change it.
#[derive(Debug)]
struct Slope {
    condition: usize,
    switch: usize,
    changed_by: Vec<usize>,
}

/// Where a motion goes on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant<'a> {
    pub time: f64,
    pub state: &'a [f64],
    /// The error of the time of the event that led here.
    pub late: f64,
}

/// Quantities along the motion from an instant on.
#[derive(Clone, Debug)]
pub(super) struct Expansion<const N: usize> {
    pub rates: Vec<Jet<N>>,
    pub conditions: Vec<Jet<N>>,
    pub switches: Vec<Jet<N>>,
    /// Each switch, or its part of what keeps conditions at zero where that is beyond its bound.
    pub parts: Vec<Jet<N>>,
    pub events: Vec<Jet<N>>,
    /// Slopes of the rates of conditions by switches.
    pub slopes: Slopes<N>,
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

    /// The motion in a mode; none where a condition cannot be held.
    pub fn at<const N: usize>(&self, instant: &Instant<'_>, mode: &[Case]) -> Option<Expansion<N>> {
        let Instant { time, state, late } = *instant;
        let mut clock = Jet::<N>::constant(time, ROUNDINGS * ROUNDING * time.abs() + late);
        if N > 1 {
            clock.terms[1] = 1.0;
        }
        let uncertain = |value: &f64| Jet::constant(*value, ROUNDINGS * ROUNDING * value.abs());
        let mut moved: Vec<Jet<N>> = state.iter().map(uncertain).collect();
        let value = |case: &Case| case.fixed().map_or(0.5, |on| if on { 1.0 } else { 0.0 });
        let confirmed = self.confirmed(time, state, &mode.iter().map(value).collect::<Vec<f64>>());
        let first = self.run(clock, &moved, mode, &confirmed)?;
        // errors of rates add up from the start on; a run whose digits are fewer than these is not decided by its roundings
        let known = DIGITS * first.rates.iter().map(|rate| rate.terms[0].abs()).fold(0.0, f64::max);
        for (part, rate) in moved.iter_mut().zip(&first.rates) {
            let own = (rate.doubts[0] + ROUNDINGS * ROUNDING * rate.terms[0].abs()).min(known);
            let moved = time.abs() * own + late * rate.terms[0].abs();
            // in a case that does not hold an exponential may be beyond all numbers
            part.doubts[0] += if moved.is_finite() { moved } else { 0.0 };
        }
        for order in 0..N - 1 {
            let found = self.run(clock, &moved, mode, &confirmed)?;
            moved.iter_mut().zip(&found.rates).for_each(|(part, rate)| part.follow(rate, order));
        }
        self.run(clock, &moved, mode, &confirmed)
    }

    /// Gives mirrored conditions the cases that follow from those of others.
    pub fn mirror(&self, mode: &mut [Case]) {
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

    /// Steps of Newton's method for the switches of held conditions: one where the rates are linear in them. A law of g that has
    /// |g| in it is linear where g is zero; rounding leaves powers of g.
    fn rounds(&self, held: &[usize]) -> usize {
        let changes = |slope: &Slope| {
            held.contains(&slope.condition) && slope.changed_by.iter().any(|switch| held.contains(switch))
        };
        if self.slopes.iter().any(changes) { ROUNDS } else { 1 }
    }

    /// Conditions of their own that a mode holds.
    pub fn held(&self, mode: &[Case]) -> Vec<usize> {
        (0..mode.len()).filter(|&place| mode[place] == Case::Held && self.mirrored[place].is_none()).collect()
    }

    /// The motion from a state; `confirmed` has the parts of the bounds of errors that count.
    fn run<const N: usize>(
        &self,
        time: Jet<N>,
        state: &[Jet<N>],
        mode: &[Case],
        confirmed: &[f64],
    ) -> Option<Expansion<N>> {
        let value = |case: &Case| match case {
            Case::Shared => Jet::constant(0.5, 0.0),
            case if case.fixed() == Some(true) => Jet::one(),
            _ => Jet::zero(),
        };
        let mut switches: Vec<Jet<N>> = mode.iter().map(value).collect();
        let held = self.held(mode);
        let mut values = self.values(time, state, &switches, confirmed);
        if !held.is_empty() {
            let first = self.states + mode.len();
            for _ in 0..self.rounds(&held) {
                let (mut rows, mut right) = (vec![vec![Jet::zero(); held.len()]; held.len()], Vec::new());
                let place = |switch: usize| held.iter().position(|held| *held == switch);
                for (slope, value) in self.slopes.iter().zip(&values[first + mode.len()..]) {
                    if let (Some(row), Some(column)) = (place(slope.condition), place(slope.switch)) {
                        rows[row][column] = *value;
                    }
                }
                right.extend(held.iter().map(|&switch| -values[first + switch]));
                for (&switch, change) in held.iter().zip(solved(rows, right)?) {
                    switches[switch] += change;
                }
                values = self.values(time, state, &switches, confirmed);
            }
        }
        let slopes = self.slopes_of(mode, &values[self.states + 2 * mode.len()..]);
        let mut parts = self.shared(mode, &slopes, &switches)?;
        for switch in (0..mode.len()).filter(|&switch| mode[switch].fixed().is_none()) {
            switches[switch] = parts[switch];
        }
        for (place, mirrored) in self.mirrored.iter().enumerate() {
            if let Some(Mirrored { of, same_side }) = *mirrored {
                let own = |all: &[Jet<N>]| if same_side { all[of] } else { Jet::one() - all[of] };
                (switches[place], parts[place]) = (own(&switches), own(&parts));
            }
        }
        let events = values.split_off(values.len() - self.events);
        let conditions = values[self.states..][..mode.len()].to_vec();
        values.truncate(self.states);
        Some(Expansion { rates: values, conditions, switches, parts, events, slopes })
    }

    fn values<const N: usize>(
        &self,
        time: Jet<N>,
        state: &[Jet<N>],
        switches: &[Jet<N>],
        confirmed: &[f64],
    ) -> Vec<Jet<N>> {
        let constants: Vec<Jet<N>> = self
            .tape
            .rounded()
            .iter()
            .map(|value| Jet::constant(*value, if value.fract() == 0.0 { 0.0 } else { ROUNDING * value.abs() }))
            .collect();
        let mut values = vec![Jet::zero(); self.tape.outputs()];
        let inputs = state.iter().chain([&time]).chain(switches).copied();
        self.tape.evaluate_long(&constants, inputs, &mut values);
        for (value, part) in values.iter_mut().zip(confirmed) {
            value.doubts = value.doubts.map(|doubt| doubt * part);
        }
        values
    }
}
