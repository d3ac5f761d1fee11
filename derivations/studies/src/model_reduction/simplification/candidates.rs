//! Candidate simplifications, found in the equations and along a coarse run.
//!
//! * A state on which neither an output nor a retained rate depends is unfollowed: exact.
//! * States whose rates vanish at their initial values, for any values of the others, are fixed: exact.
//! * States with equal initial values and equal rates (as long as the states are equal) are equal: exact.
//! * A state that relaxes, or a coordinate that oscillates, many times faster than the length of the run is
//!   quasi-steady, the fastest first.
//! * A state that hardly changes along the run is fixed.
//! * A nonlinear law may be linearised if states are small.
//!
//! The error of an approximation decides later whether it suffices.

use super::Simplification;
use field::Over;
use integrators::Jacobian;
use simulation::{Law, SymbolicLaw, traced};
use symbolic::{Hypotheses, Sym, decide, substitute_all};

/// A transient is fast if the run is longer than this many of its time constants.
const FAST: f64 = 20.0;
/// The largest number of fast transients that are neglected together.
const MOST_FAST: usize = 6;
/// A state hardly changes if its range is below this fraction of its size.
const HARDLY: f64 = 1e-2;
/// The number of states along the run at which rates of transients are evaluated.
const LOOKS: usize = 5;
/// The largest number of states of a law that is searched.
const MOST: usize = 60;
/// The largest number of operations in all rates for which linearisation is a candidate.
const LINEARISED: usize = 2_000;
/// The largest number of operations of a rate whose vanishing is decided.
const DECIDED: usize = 2_000;

/// A system with a coarse run.
pub struct Facts<'a> {
    pub written: &'a dyn SymbolicLaw,
    pub law: &'a dyn Law,
    /// The names of the states, in order.
    pub names: &'a [String],
    /// Times (s) and states of the run.
    pub along: &'a [(f64, Vec<f64>)],
    /// For each state, whether an output depends on it.
    pub shown: &'a [bool],
}

/// The dependency structure of the equations.
struct Structure {
    /// Whether the rate i depends on the state j.
    depends: Vec<Vec<bool>>,
    /// For each coordinate its speed: the state that is its rate.
    speeds: Vec<Option<usize>>,
    /// Whether the rates are nonlinear in the states.
    is_curved: bool,
}

/// A fast transient of a state.
#[derive(Clone, Copy, Debug)]
struct Transient {
    /// The state that may be quasi-steady.
    state: usize,
    /// The rate constant, 1/s.
    rate: f64,
}

/// A simplification that may suffice, with its small parameter.
#[derive(Clone, Debug)]
pub struct Candidate {
    pub simplification: Simplification,
    pub parameter: &'static str,
    pub value: Option<f64>,
}

const OF_TRANSIENTS: &str = "time of the slowest transient over that of the run";
const OF_SQUARES: &str = "squares of the states relative to the states";
const OF_RANGES: &str = "range of what is fixed over its size";

/// The exact simplification, which may be empty, and approximations beyond it.
pub fn candidates(facts: &Facts<'_>) -> (Simplification, Vec<Candidate>) {
    if facts.names.len() > MOST {
        return (Simplification::default(), Vec::new());
    }
    let structure = structure(facts.written);
    let unfollowed = structure.unfollowed(facts.shown);
    let fixed = resting(facts, &unfollowed);
    let named = |places: &[usize]| places.iter().map(|&place| facts.names[place].clone()).collect::<Vec<_>>();
    let same = alike(facts, &[&unfollowed[..], &fixed].concat());
    let pair = |(one, other): &(usize, usize)| format!("{}={}", facts.names[*one], facts.names[*other]);
    let exact = Simplification {
        unfollowed: named(&unfollowed),
        fixed: named(&fixed),
        equal: same.iter().map(pair).collect(),
        ..Simplification::default()
    };
    let gone: Vec<usize> = unfollowed.iter().chain(&fixed).copied().chain(same.iter().map(|(one, _)| *one)).collect();
    // a state to which another is equal is not quasi-steady: it would be solved for twice
    let kept: Vec<usize> = same.iter().map(|(_, other)| *other).collect();
    let mut fast = structure.transients(facts);
    fast.retain(|one| !gone.contains(&one.state) && !kept.contains(&one.state));
    fast.sort_by(|a, b| b.rate.total_cmp(&a.rate));
    fast.truncate(MOST_FAST);
    let quasi_steady = |fast: &[Transient]| {
        let all: Vec<usize> = fast.iter().map(|one| one.state).collect();
        // a coordinate includes its speed
        let is_speed = |state: &usize| all.iter().any(|&other| structure.speeds[other] == Some(*state));
        let mut places: Vec<usize> = all.iter().copied().filter(|state| !is_speed(state)).collect();
        places.sort_unstable();
        Simplification { quasi_steady: named(&places), ..Simplification::default() }
    };
    let span = facts.span();
    // largest first: it saves the most
    let slaved = (1..=fast.len()).rev().map(|count| Candidate {
        simplification: exact.and(&quasi_steady(&fast[..count])),
        parameter: OF_TRANSIENTS,
        value: Some(1.0 / (fast[count - 1].rate * span)),
    });
    let mut found: Vec<Candidate> = slaved.collect();
    let still: Vec<(usize, f64)> = facts.still().into_iter().filter(|(place, _)| !gone.contains(place)).collect();
    // a coordinate is fixed only together with its speed
    let moves = |place: usize| structure.speeds[place].is_some_and(|speed| !gone.contains(&speed));
    let still: Vec<(usize, f64)> = still.into_iter().filter(|(place, _)| !moves(*place)).collect();
    let fixed = |still: &[(usize, f64)]| {
        let places: Vec<usize> = still.iter().map(|(place, _)| *place).collect();
        let fixed = Simplification { fixed: named(&places), ..Simplification::default() };
        let value = still.iter().map(|(_, range)| *range).fold(0.0, f64::max);
        Candidate { simplification: exact.and(&fixed), parameter: OF_RANGES, value: Some(value) }
    };
    if still.len() > 1 {
        found.push(fixed(&still));
    }
    found.extend(still.iter().map(|one| fixed(&[*one])));
    if structure.is_curved {
        let linear = Simplification { linear: true, ..Simplification::default() };
        found.push(Candidate { simplification: exact.and(&linear), parameter: OF_SQUARES, value: None });
    }
    (exact, found)
}

fn structure(written: &dyn SymbolicLaw) -> Structure {
    traced(written, |traced| {
        let place = |symbol: &Sym| traced.state.iter().position(|state| state == symbol);
        let depends = traced.rates.iter().map(|rate| {
            let used = rate.symbols_of();
            traced.state.iter().map(|state| used.contains(state)).collect()
        });
        let is_curved = |rate: &Sym| {
            let slopes = traced.state.iter().map(|state| rate.diff(*state));
            slopes.into_iter().any(|slope| slope.symbols_of().iter().any(|symbol| traced.state.contains(symbol)))
        };
        Structure {
            depends: depends.collect(),
            speeds: traced.rates.iter().map(place).collect(),
            is_curved: Sym::operations_of(&traced.rates) <= LINEARISED && traced.rates.iter().any(is_curved),
        }
    })
}

impl Structure {
    /// The states on which no output depends, directly or through retained rates.
    fn unfollowed(&self, shown: &[bool]) -> Vec<usize> {
        let mut needed = shown.to_vec();
        loop {
            let more: Vec<usize> = (0..needed.len())
                .filter(|&j| !needed[j] && (0..needed.len()).any(|i| needed[i] && self.depends[i][j]))
                .collect();
            if more.is_empty() {
                return (0..needed.len()).filter(|&place| !needed[place]).collect();
            }
            more.into_iter().for_each(|place| needed[place] = true);
        }
    }

    /// Transients that are fast all along the run.
    fn transients(&self, facts: &Facts<'_>) -> Vec<Transient> {
        let n = facts.names.len();
        let span = facts.span();
        let mut jacobian = Jacobian::of(facts.law);
        let looks = facts.along.len().div_ceil(LOOKS).max(1);
        let matrices: Vec<Vec<f64>> = facts
            .along
            .iter()
            .step_by(looks)
            .map(|(time, state)| {
                let mut matrix = vec![0.0; n * n];
                jacobian.matrix(*time, state, &mut matrix);
                matrix
            })
            .collect();
        // the smallest restoring coefficient along the run
        let falls = |i: usize, j: usize| matrices.iter().map(|matrix| -matrix[i * n + j]).fold(f64::INFINITY, f64::min);
        let mut found = Vec::new();
        for state in 0..n {
            let Some(speed) = self.speeds[state] else {
                // the speed of an oscillation is no separate transient
                let swings = |coordinate: usize| {
                    falls(state, coordinate) > 0.0 && falls(state, state).powi(2) < 4.0 * falls(state, coordinate)
                };
                if !(0..n).any(|other| self.speeds[other] == Some(state) && swings(other)) {
                    found.push(Transient { state, rate: falls(state, state) });
                }
                continue;
            };
            let (stiffness, damping) = (falls(speed, state), falls(speed, speed).max(0.0));
            // x'' + c x' + k x = 0: underdamped, or overdamped with the slow rate k/c
            let creeps = damping * damping >= 4.0 * stiffness;
            let rate = if creeps { stiffness / damping } else { stiffness.max(0.0).sqrt() };
            found.push(Transient { state, rate });
        }
        found.retain(|one| one.rate * span > FAST && one.rate.is_finite());
        found
    }
}

impl Facts<'_> {
    /// The duration of the run, s.
    fn span(&self) -> f64 {
        self.along.last().map_or(0.0, |(time, _)| *time)
    }

    /// The states that hardly change along the run, each with its range divided by its size.
    fn still(&self) -> Vec<(usize, f64)> {
        let range = |place: usize| {
            let values = || self.along.iter().map(|(_, state)| state[place]);
            let [least, most] = [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)];
            (most - least, least.abs().max(most.abs()))
        };
        let relative = |place: usize| {
            let (range, size) = range(place);
            (range < HARDLY * size).then_some((place, range / size))
        };
        (0..self.names.len()).filter_map(relative).collect()
    }
}

/// The states that keep their initial values because their rates vanish there for any values of the others.
fn resting(facts: &Facts<'_>, unfollowed: &[usize]) -> Vec<usize> {
    let Some((_, start)) = facts.along.first() else { return Vec::new() };
    let stays = |place: &usize| facts.along.iter().all(|(_, state)| state[*place] == start[*place]);
    let mut found: Vec<usize> =
        (0..start.len()).filter(|place| !unfollowed.contains(place)).filter(|place| stays(place)).collect();
    if found.is_empty() || found.len() + unfollowed.len() == start.len() {
        return Vec::new();
    }
    traced(facts.written, |traced| {
        loop {
            let values: Vec<(Sym, Sym)> =
                found.iter().map(|&place| (traced.state[place], Sym::lift(start[place]))).collect();
            let rates: Vec<Sym> = found.iter().map(|&place| traced.rates[place]).collect();
            let rates = substitute_all(&rates, &values);
            let vanishes =
                |rate: &Sym| Sym::operations_of(&[*rate]) <= DECIDED && decide(*rate, &Hypotheses::none()).is_zero();
            let kept: Vec<usize> =
                found.iter().zip(&rates).filter(|(_, rate)| vanishes(rate)).map(|(&place, _)| place).collect();
            if kept.len() == found.len() {
                return kept;
            }
            found = kept;
        }
    })
}

/// Pairs of equal states: their initial values are equal, and their rates are equal as long as all pairs are.
fn alike(facts: &Facts<'_>, gone: &[usize]) -> Vec<(usize, usize)> {
    let n = facts.names.len();
    let same = |one: usize, other: usize| facts.along.iter().all(|(_, state)| state[one] == state[other]);
    let first = |one: usize| (0..one).find(|other| !gone.contains(other) && same(one, *other));
    let mut found: Vec<(usize, usize)> =
        (0..n).filter(|one| !gone.contains(one)).filter_map(|one| Some((one, first(one)?))).collect();
    // the first of all equal states is retained
    let others: Vec<usize> = found.iter().map(|(one, _)| *one).collect();
    found.retain(|(_, other)| !others.contains(other));
    if found.is_empty() {
        return found;
    }
    traced(facts.written, |traced| {
        loop {
            let values: Vec<(Sym, Sym)> =
                found.iter().map(|&(one, other)| (traced.state[one], traced.state[other])).collect();
            let apart: Vec<Sym> = found.iter().map(|&(one, other)| traced.rates[one] - traced.rates[other]).collect();
            let apart = substitute_all(&apart, &values);
            let vanishes =
                |rate: &Sym| Sym::operations_of(&[*rate]) <= DECIDED && decide(*rate, &Hypotheses::none()).is_zero();
            let kept: Vec<(usize, usize)> =
                found.iter().zip(&apart).filter(|(_, rate)| vanishes(rate)).map(|(pair, _)| *pair).collect();
            if kept.len() == found.len() {
                return kept;
            }
            found = kept;
        }
    })
}
