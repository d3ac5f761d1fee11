//! The arguments of exponentials in a law, and the largest step sizes of Taylor series for them.
//!
//! For x = 100 d the function exp(u) with u = -x/d underflows, with all its Taylor terms; a step that takes x to zero
//! ends where the function is 1. Over a step h that changes u by D the terms of exp(u) are those of e^u D^k/k!; beyond
//! the order p they decrease if D < p/2. The step is therefore small enough if
//!
//!   D = sum_k |u_k| h^k <= p/2,  or  u + D is so small that exp(u) is below rounding all the way.
//!
//! For tanh x = 1 - 2/(1 + exp 2x) the exponent is u = -|2x|. Near tanh x = 1 its derivative has few correct digits: D
//! is at most 8 there.

use field::Elementary;
use series::{Equations, Recurrence};
use std::collections::HashSet;
use symbolic::{Derivation, Node, Sym, Tape, Untapeable};

/// Logarithms below which exponentials are negligible, in `f64` and in double-double.
const NOTHING: [f64; 2] = [-40.0, -80.0];

/// Below this argument an exponential underflows.
const UNDERFLOWS: f64 = -690.0;

/// The largest change of the exponent within a step where the derivative of tanh has few digits.
const DIGITS: f64 = 8.0;

/// The factor by which a too long step is shortened.
const SHORTER: f64 = 0.7;

/// The Taylor recurrence of a law; the arguments of its exponentials follow the state.
#[derive(Clone, Debug)]
pub struct Expandable {
    pub recurrence: Recurrence,
    pub exponents: Option<Exponents>,
    /// Whether square roots or angles of the state occur.
    pub has_branches: bool,
}

/// The arguments u of exponentials.
#[derive(Clone, Debug)]
pub struct Exponents {
    /// Computes the arguments from the state, the time if the law depends on it, and the parameters.
    values: Tape,
    knows_time: bool,
    /// Whether each argument belongs to tanh.
    both_sides: Vec<bool>,
}

/// Buffers for the values of the arguments at a state.
#[derive(Clone, Debug, Default)]
pub struct Room {
    pub values: Vec<f64>,
    registers: Vec<f64>,
}

impl Expandable {
    /// Records the recurrence of equations.
    ///
    /// # Errors
    /// [`Untapeable`] where an expression has no Taylor series.
    pub fn record(equations: &Equations<'_>) -> Result<Self, Untapeable> {
        let solved = equations.solve.map(|solve| solve.expressions()).unwrap_or_default();
        let all = [equations.rates, &solved].concat();
        let (found, has_branches) = (exponents_of(&all), has_branches(&all));
        if found.is_empty() {
            return Ok(Expandable { recurrence: Recurrence::record(equations)?, exponents: None, has_branches });
        }
        let (arguments, both_sides): (Vec<Sym>, Vec<bool>) = found.into_iter().unzip();
        let moved = equations.state.iter().copied().zip(equations.rates.iter().copied());
        let mut along = Derivation::new(moved.chain(equations.time.map(|time| (time, Sym::ONE))));
        let names: Vec<Sym> = (0..arguments.len()).map(|place| Sym::symbol(&format!("exponent{place}"))).collect();
        let state = [equations.state, &names].concat();
        let rates = equations.rates.iter().copied().chain(arguments.iter().map(|&argument| along.of(argument)));
        let rates: Vec<Sym> = rates.collect();
        let recurrence = Recurrence::record(&Equations { state: &state, rates: &rates, ..*equations })?;
        let inputs = equations.state.iter().chain(&equations.time).chain(equations.parameters);
        let values = Tape::record(&inputs.copied().collect::<Vec<Sym>>(), &arguments)?;
        let knows_time = equations.time.is_some();
        Ok(Expandable { recurrence, exponents: Some(Exponents { values, knows_time, both_sides }), has_branches })
    }

    /// The number of states of the law.
    pub fn states(&self) -> usize {
        self.recurrence.states() - self.exponents.as_ref().map_or(0, Exponents::count)
    }

    /// The number of parameters of the law.
    pub fn parameters(&self) -> usize {
        self.recurrence.parameters()
    }
}

impl Exponents {
    /// The number of arguments.
    pub fn count(&self) -> usize {
        self.both_sides.len()
    }

    /// Computes the values of the arguments from the state, the time and the parameters. Allocates at the first call
    /// only.
    pub fn evaluate(&self, room: &mut Room, state: impl Iterator<Item = f64>, time: f64, parameters: &[f64]) {
        room.values.resize(self.count(), f64::NAN);
        let inputs = state.chain(self.knows_time.then_some(time)).chain(parameters.iter().copied());
        self.values.evaluate_in(&mut room.registers, self.values.rounded(), inputs, &mut room.values);
    }

    /// The largest step size for which the Taylor terms up to `order` represent the exponentials, from the values of
    /// their arguments and `term(number, order)`, the Taylor coefficients of the arguments.
    pub fn longest(&self, values: &[f64], order: usize, is_finer: bool, term: impl Fn(usize, usize) -> f64) -> f64 {
        let mut longest = f64::INFINITY;
        for (place, (&value, &both_sides)) in values.iter().zip(&self.both_sides).enumerate() {
            let value = if both_sides { -value.abs() } else { value };
            let shown = 0.5 * order as f64;
            let shown = if both_sides { shown.min(DIGITS) } else { shown };
            let shown = if value < UNDERFLOWS { 0.0 } else { shown };
            let allowed = shown.max(NOTHING[usize::from(is_finer)] - value);
            let size = |k: usize| term(place, k).abs();
            // no longer than where a single term reaches the bound
            let mut step = longest;
            for k in (1..=order).filter(|k| size(*k) > 0.0) {
                step = step.min((allowed / size(k)).powf(1.0 / k as f64));
            }
            let change = |step: f64| (1..=order).rev().fold(0.0, |sum, k| (sum + size(k)) * step);
            while step.is_finite() && step > 0.0 && change(step) > allowed {
                step *= SHORTER;
            }
            longest = step;
        }
        longest
    }
}

/// Whether a square root or an angle of symbols occurs in the expressions.
fn has_branches(roots: &[Sym]) -> bool {
    let (mut open, mut seen) = (roots.to_vec(), HashSet::new());
    while let Some(each) = open.pop() {
        let is_branched = matches!(each.node(), Node::Root(_) | Node::Elementary(Elementary::Atan2, ..));
        if is_branched && !each.symbols_of().is_empty() {
            return true;
        }
        open.extend(each.node().children().filter(|child| seen.insert(*child)));
    }
    false
}

/// The arguments of exponentials, and twice those of tanh, with a mark for tanh.
fn exponents_of(roots: &[Sym]) -> Vec<(Sym, bool)> {
    let (mut open, mut seen, mut found) = (roots.to_vec(), HashSet::new(), Vec::new());
    while let Some(each) = open.pop() {
        if !seen.insert(each) {
            continue;
        }
        let exponent = match each.node() {
            Node::Elementary(Elementary::Exp, argument, _) => Some((argument, false)),
            Node::Elementary(Elementary::Tanh, argument, _) => Some((argument + argument, true)),
            _ => None,
        };
        found.extend(exponent.filter(|(argument, _)| !argument.symbols_of().is_empty()));
        open.extend(each.node().children());
    }
    found
}
