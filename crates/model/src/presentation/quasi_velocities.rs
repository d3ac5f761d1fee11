//! The matrix form in quasi-velocities: kinematic equations, and dynamic equations without reactions.

use super::axes::axes;
use super::matrix_form::{Dynamics, HeldEquation, MatrixForm, without_forces};
use super::reading_of;
use crate::equations::constraints_of;
use crate::principles::NotApplicable;
use crate::{Coefficient, QuasiPrinciple, QuasiVelocities, Trace};
use field::Rational;
use rustc_hash::FxHashMap;
use std::f64::consts::PI;
use symbolic::{Node, Sym, substitute_all};

/// The meaning of quasi-velocities, and the constraints that all of their values satisfy.
#[derive(Clone, Debug)]
pub struct InQuasiVelocities {
    /// The quasi-velocities as functions of coordinates, their rates and the time.
    pub definitions: Vec<Sym>,
    /// Constraints that are satisfied identically, over coordinates, their rates and the time.
    pub met: Vec<HeldEquation>,
    /// Rates of coordinates, and angular velocities of free frames.
    pub(super) rates: Vec<Sym>,
    /// Symbols of long derivatives of the speeds, with their meanings.
    pub coefficients: Vec<Coefficient>,
    /// Expressions by which the speeds are divided.
    pub divisors: Vec<Divisor>,
}

fn mapped(coefficient: &Coefficient, map: &mut dyn FnMut(&[Sym]) -> Vec<Sym>) -> Coefficient {
    let Coefficient { letter, is, rate, rate_is } = *coefficient;
    let [letter, is, rate, rate_is] = [letter, is, rate, rate_is].map(|each| map(&[each])[0]);
    Coefficient { letter, is, rate, rate_is }
}

/// A divisor of the speeds as functions of the quasi-velocities.
#[derive(Clone, Copy, Debug)]
pub struct Divisor {
    /// The expression of the divisor.
    pub is: Sym,
    /// Whether the divisor vanishes at the start; `None` if this is not known.
    pub vanishes_at_start: Option<bool>,
}

impl Divisor {
    /// Returns a sentence on the divisor.
    pub(super) fn told(&self, trace: &Trace<'_>) -> String {
        let operations = written_operations(&[self.is]);
        let is = match operations <= MOST_TOLD {
            true => reading_of(trace).of(self.is).decimal_text(),
            false => format!("a determinant of {operations:.0e} operations"),
        };
        let sentence = format!("The quasi-velocities determine the speeds where this divisor does not vanish: {is}.");
        match self.vanishes_at_start {
            None => sentence,
            Some(false) => format!("{sentence} It does not vanish at the start."),
            Some(true) => {
                format!("{sentence} It vanishes at the start: these equations have no value there.")
            }
        }
    }
}

impl InQuasiVelocities {
    pub(super) fn mapped(&self, map: &mut dyn FnMut(&[Sym]) -> Vec<Sym>) -> Self {
        InQuasiVelocities {
            definitions: map(&self.definitions),
            met: self.met.iter().map(|held| held.mapped(map)).collect(),
            rates: map(&self.rates),
            coefficients: self.coefficients.iter().map(|each| mapped(each, map)).collect(),
            divisors: self.divisors.clone(),
        }
    }
}

impl MatrixForm {
    /// Returns the number of printed operations, in which shared subexpressions are repeated and direction cosines count as one.
    pub fn written_operations(&self) -> f64 {
        let cosines = self.turns.iter().flat_map(|(_, cosines)| cosines.iter().flatten());
        let letters: Vec<(Sym, Sym)> = cosines.map(|&cosine| (cosine, self.time)).collect();
        let all: Vec<Sym> = self.expressions().collect();
        written_operations(&substitute_all(&all, &letters))
    }

    /// Returns whether equations in quasi-velocities are short enough to be simplified for reading. For longer ones this takes
    /// minutes.
    pub fn is_read(&self) -> bool {
        self.quasi.is_none() || Sym::operations_of(&self.expressions().collect::<Vec<_>>()) <= MOST_READ
    }

    /// Determines which divisors vanish at a start; all parameters must have values.
    #[must_use]
    pub fn with_start(mut self, trace: &Trace<'_>, start: &[f64]) -> Self {
        let value = |is: Sym, by: f64| {
            let moved = start.iter().enumerate().map(|(k, value)| value + by * (1.0 + k as f64).sqrt());
            let state = trace.coordinates.iter().zip(moved).map(|(letter, value)| (letter.to_string(), value));
            let parameters = trace.model.parameters.iter();
            let parameters = parameters.filter_map(|one| one.value.map(|value| (one.name.clone(), value)));
            let own = [(trace.time.to_string(), 0.0), (trace.pi.to_string(), PI)];
            let values: FxHashMap<String, f64> = state.chain(parameters).chain(own).collect();
            is.evaluate_analytic(&|name| values.get(name).copied()).ok()
        };
        for divisor in self.quasi.iter_mut().flat_map(|quasi| &mut quasi.divisors) {
            let beside = [0.1, -0.07].into_iter().filter_map(|by| value(divisor.is, by));
            let size = beside.fold(0.0, |most: f64, value: f64| most.max(value.abs()));
            divisor.vanishes_at_start =
                value(divisor.is, 0.0).map(|value| value.is_nan() || value.abs() <= ROUNDED * size);
        }
        self
    }

    /// Derives the form by a principle in quasi-velocities. Reactions of satisfied constraints have no power along quasi-velocities, hence the form does not contain them.
    ///
    /// # Errors
    /// The principle does not apply to the model, or the quasi-velocities are not independent.
    pub fn in_quasi_velocities(
        trace: &Trace<'_>,
        quasi: &QuasiVelocities<'_, '_>,
        principle: QuasiPrinciple,
    ) -> Result<Self, NotApplicable> {
        let free = without_forces(trace.model);
        let free = Trace::of(&free);
        let of_inertia = quasi.beside(&free).map_err(|_| NotApplicable("they are not independent".to_owned()))?;
        let residual = principle.residual(quasi)?;
        let at_rest: Vec<(Sym, Sym)> = quasi.accelerations.iter().map(|&letter| (letter, Sym::ZERO)).collect();
        let derivatives = |row: &Sym| quasi.accelerations.iter().map(|&letter| row.diff(letter)).collect();
        let bias = substitute_all(&residual, &at_rest);
        let inertia = substitute_all(&principle.residual(&of_inertia)?, &at_rest);
        let forces = inertia.iter().zip(&bias).map(|(&free, &moved)| free - moved).collect();
        let constraints = constraints_of(trace).into_iter().zip(axes(trace));
        let (met, programmed): (Vec<_>, Vec<_>) = constraints.partition(|(one, _)| one.gains.is_none());
        let programmed = programmed.into_iter().map(|(one, axis)| {
            let held = HeldEquation::of(one, axis);
            // J u' + c as a function of w and w'
            let terms = held.row.iter().zip(&trace.accelerations);
            let rate = terms.fold(held.bias, |sum, (&slope, &acceleration)| sum + slope * acceleration);
            let [zero, rate] = [held.zero, rate].map(|each| quasi.by_quasi_velocities(&[each])[0]);
            HeldEquation { zero, row: derivatives(&rate), bias: rate.substitute(&at_rest), ..held }
        });
        let mass = residual.iter().map(derivatives).collect();
        let dynamics = Dynamics { mass, inertia, forces, constraints: programmed.collect() };
        let (speeds, accelerations) = (quasi.symbols.clone(), quasi.accelerations.clone());
        let rates = quasi.position_rates.clone();
        let form = MatrixForm::with(trace, dynamics, speeds.clone(), speeds, accelerations, rates);
        let quasi_velocities = InQuasiVelocities {
            definitions: quasi.definitions.clone(),
            met: met.into_iter().map(|(one, axis)| HeldEquation::of(one, axis)).collect(),
            rates: trace.speeds.clone(),
            coefficients: quasi.coefficients.clone(),
            divisors: quasi.divisors.iter().map(|&is| Divisor { is, vanishes_at_start: None }).collect(),
        };
        let switches =
            form.switches.iter().map(|&(letter, is)| (letter, quasi.by_quasi_velocities(&[is])[0])).collect();
        Ok(MatrixForm { quasi: Some(quasi_velocities), switches, ..form })
    }
}

/// Returns the number of operations of expressions, in which shared subexpressions are repeated.
pub(super) fn written_operations(expressions: &[Sym]) -> f64 {
    let mut known: FxHashMap<Sym, f64> = FxHashMap::default();
    let mut open: Vec<Sym> = expressions.to_vec();
    while let Some(&each) = open.last() {
        let inside = match each.node() {
            Node::Sum(a, b) | Node::Difference(a, b) | Node::Product(a, b) | Node::Quotient(a, b) => vec![a, b],
            Node::Negation(a) | Node::Power(a, _) | Node::Root(a) | Node::Cos(a) | Node::Sin(a) => vec![a],
            _ => Vec::new(),
        };
        let missing: Vec<Sym> = inside.iter().copied().filter(|part| !known.contains_key(part)).collect();
        if missing.is_empty() {
            let parts = inside.iter().map(|part| known[part]).sum::<f64>();
            known.insert(each, 1.0 + parts);
            open.pop();
        }
        open.extend(missing);
    }
    expressions.iter().map(|each| known[each]).sum()
}

/// Divisors with more operations are described by their number.
const MOST_TOLD: f64 = 150.0;

/// A divisor counts as zero below this fraction of its values nearby.
const ROUNDED: f64 = 1e-10;

/// Longer systems are exported without simplification. A chain of ten links has 2,400 operations and takes four seconds.
const MOST_READ: usize = 3_000;

/// Polynomials in more symbols are not collected.
const MOST_COLLECTED: usize = 12;

/// Writes a polynomial of at most second degree in some symbols by its coefficients, each in a short form; `None` for other expressions.
pub(super) fn collected(expression: Sym, letters: &[Sym], read: impl Fn(Sym) -> Sym) -> Option<Sym> {
    if letters.len() > MOST_COLLECTED {
        return None;
    }
    let at_zero: Vec<(Sym, Sym)> = letters.iter().map(|&letter| (letter, Sym::ZERO)).collect();
    let mut sum = read(expression.substitute(&at_zero));
    for (place, &one) in letters.iter().enumerate() {
        let slope = expression.diff(one);
        sum += read(slope.substitute(&at_zero)) * one;
        for &other in &letters[place..] {
            let half = if one == other { Rational::new(1, 2) } else { Rational::new(1, 1) };
            let coefficient = read(slope.diff(other) * Sym::constant(half));
            if coefficient.symbols_of().iter().any(|symbol| letters.contains(symbol)) {
                return None;
            }
            sum += coefficient * one * other;
        }
    }
    Some(sum)
}
