//! Sentences of `prove`, checked numerically at a state by difference quotients along the motion through this state.

use super::mechanics::Mechanics;
use super::numbers::{curvature, dot, slope, unit, value};
use super::system::{State, System};
use dalembert_model::equations::Level;

/// The reason why a sentence is false at a state.
pub type Fault = String;

/// A state with the accelerations and multipliers of the motion at this state.
pub struct At<'a, 's, 't, 'm> {
    pub mechanics: &'a Mechanics<'s, 't, 'm>,
    pub state: State,
    pub solved: Vec<f64>,
}

/// Admissible error of a difference quotient, relative to the size of the compared values.
const TOLERANCE: f64 = 1e-6;

pub fn equal(claim: &str, one: f64, other: f64, size: f64) -> Result<(), Fault> {
    let size = 1.0 + size.abs() + one.abs() + other.abs();
    if (one - other).abs() <= TOLERANCE * size { Ok(()) } else { Err(format!("{claim}: {one} is not {other}")) }
}

impl<'t, 'm> At<'_, '_, 't, 'm> {
    fn system(&self) -> &System<'t, 'm> {
        self.mechanics.system
    }

    /// Returns the value of a printed expression at the state.
    fn printed(&self, text: &str) -> f64 {
        value(text, &|name| self.system().letter(name, &self.state, &self.solved))
    }

    /// Returns J u of a constraint, computed from differences of the constraint function.
    fn along(&self, place: usize) -> f64 {
        let (system, state) = (self.system(), &self.state);
        let constraint = &system.constraints[place];
        let zero = system.numbers(&[constraint.zero]);
        let f = |at: &State| system.at(&zero, at, &[])[0];
        match constraint.level {
            Level::Position => slope(|length| f(&system.displaced(state, &state.u, length))),
            Level::Speed => slope(|length| {
                let u = state.u.iter().map(|u| (1.0 + length) * u).collect();
                f(&State { u, ..state.clone() })
            }),
        }
    }

    fn multiplier(&self, place: usize) -> f64 {
        self.solved[self.state.u.len() + place]
    }

    /// Checks a sentence such as `(T + V)' is the power of the forces plus ...`.
    pub fn energy(&self, says: &str) -> Result<(), Fault> {
        let (mechanics, system, state) = (self.mechanics, self.system(), &self.state);
        let (name, sum) = bare(says).split_once(" is ").ok_or("no sentence")?;
        let is_whole = match name {
            "(T + V)'" => true,
            "(H = sum u dT/du - T + V)'" => false,
            other => return Err(format!("`{other}` is no energy")),
        };
        let is_relative = sum.contains(RELATIVE);
        let mut expected = 0.0;
        for part in sum.replace(RELATIVE, "").split(" plus ") {
            expected += match part {
                "zero" => 0.0,
                "the power of the forces" => {
                    let still = mechanics.power(state, &vec![0.0; state.u.len()], &self.solved);
                    let whole = mechanics.power(state, &state.u, &self.solved);
                    if is_relative { whole - still } else { whole }
                }
                "the partial rate of V - T by t" => slope(|length| {
                    let later = State { time: state.time + length, ..state.clone() };
                    mechanics.potential(&later, state) - mechanics.kinetic(&later, &state.u, state)
                }),
                "sum m' d(T + V)/dm over the masses and moments of inertia m that vary"
                | "sum m' d(H)/dm over the masses and moments of inertia m that vary" => {
                    slope(|length| mechanics.energy(is_whole, state, &system.later(state, length)))
                }
                other => {
                    let printed =
                        other.strip_prefix("the power of the reactions (").and_then(|sum| sum.strip_suffix(')'));
                    let printed = printed.ok_or(format!("`{other}`?"))?;
                    let works = |place: usize| self.multiplier(place) * self.along(place);
                    let power: f64 = (0..system.constraints.len()).map(works).sum();
                    if printed != "sum lambda J u" {
                        equal(printed, self.printed(printed), power, 0.0)?;
                    }
                    power
                }
            };
        }
        let rate = slope(|length| {
            let later = system.later(state, length);
            mechanics.energy(is_whole, &later, &later)
        });
        equal(says, rate, expected, mechanics.energy(is_whole, state, state))
    }

    /// Checks the sentence `(dT/dx')' is zero` for the speed with an index.
    pub fn momentum(&self, speed: usize, says: &str) -> Result<(), Fault> {
        let name = self.system().trace.speeds[speed];
        if bare(says) != format!("(dT/d{name})' is zero") {
            return Err(format!("`{says}`?"));
        }
        let momentum = |at: &State| self.mechanics.momentum(at, speed, at);
        let rate = slope(|length| momentum(&self.system().later(&self.state, length)));
        equal(says, rate, 0.0, momentum(&self.state))
    }

    /// Checks a sentence such as `J u' + c is its rate; its reaction does no work` for a constraint, with arbitrary accelerations.
    pub fn constraint(&self, place: usize, accelerations: &[f64], says: &str) -> Result<(), Fault> {
        let (system, state) = (self.system(), &self.state);
        let (rates, work) = bare(says).split_once("; ").ok_or("no sentence")?;
        let constraint = &system.constraints[place];
        let zero = system.numbers(&[constraint.zero]);
        let f = |length: f64| system.at(&zero, &system.moved(state, accelerations, length), &[])[0];
        let gains = constraint.gains.as_ref().map_or(Vec::new(), |gains| system.at(&system.numbers(gains), state, &[]));
        let led = match (rates.strip_prefix("J u' + c is ").ok_or("no sentence")?, constraint.level) {
            ("its second rate", Level::Position) => curvature(f),
            ("its rate", Level::Speed) => slope(f),
            ("f'' + g1 f' + g2 f", Level::Position) => curvature(f) + gains[0] * slope(f) + gains[1] * f(0.0),
            ("f'' + g1 f'", Level::Position) => curvature(f) + gains[0] * slope(f),
            ("f' + g1 f", Level::Speed) => slope(f) + gains[0] * f(0.0),
            (other, _) => return Err(format!("`{other}`?")),
        };
        equal(rates, system.kept(state, accelerations)[place], led, f(0.0))?;
        let is_relative = work.ends_with(CARRIED);
        if !is_relative && self.mechanics.is_carried(state) {
            return Err(format!("{work}: bodies move at u = 0"));
        }
        let work = work.replace(CARRIED, "");
        let power = self.multiplier(place) * self.along(place);
        match work.strip_prefix("the power of its reaction is ") {
            None if work == "its reaction does no work" => equal(&work, power, 0.0, self.multiplier(place)),
            Some(printed) if printed.ends_with(" J u") => Ok(()),
            Some(printed) => equal(printed, self.printed(printed), power, 0.0),
            None => Err(format!("`{work}`?")),
        }
    }

    /// Checks Newton's and Euler's law of all bodies by differences; if a kinetic energy is given, Lagrange's equations.
    pub fn law(&self) -> Result<(), Fault> {
        let (mut inertia, mut left) = self.mechanics.inertia_less_forces(&self.state, &self.solved);
        if self.system().model().energies.kinetic.is_some() {
            for (i, (of_bodies, left)) in inertia.iter_mut().zip(&mut left).enumerate() {
                let whole = super::mistakes::inertia(self, i);
                *left += whole - *of_bodies;
                *of_bodies = whole;
            }
        }
        left.iter()
            .zip(self.reactions())
            .zip(inertia)
            .try_for_each(|((left, reaction), size)| equal("Newton's law", *left, reaction, size))
    }

    /// Returns J^T lambda, computed from differences of the constraint functions.
    pub fn reactions(&self) -> Vec<f64> {
        let (system, state) = (self.system(), &self.state);
        let n = state.u.len();
        let zeros = system.constraints.iter().map(|one| one.zero).collect::<Vec<_>>();
        let zeros = system.numbers(&zeros);
        let of = |i: usize| {
            let unit = unit(n, i);
            let row = (0..system.constraints.len()).map(|place| {
                let f = |at: &State| system.at(&zeros, at, &[])[place];
                match system.constraints[place].level {
                    Level::Position => slope(|length| f(&system.displaced(state, &unit, length))),
                    Level::Speed => slope(|length| {
                        let mut u = state.u.clone();
                        u[i] += length;
                        f(&State { u, ..state.clone() })
                    }),
                }
            });
            dot(&row.collect::<Vec<_>>(), &self.solved[n..])
        };
        (0..n).map(of).collect()
    }
}

const RELATIVE: &str = "; powers are computed with velocities less the velocities at u = 0";
const CARRIED: &str = " with velocities less the velocities at u = 0";

/// Returns a sentence without its leading conditions ("at constant ...:", "between events").
fn bare(says: &str) -> &str {
    let says =
        says.strip_prefix("at constant ").map_or(says, |rest| rest.split_once(": ").map_or(rest, |(_, says)| says));
    says.strip_prefix("between events ").unwrap_or(says)
}
