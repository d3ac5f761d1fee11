//! Equations of motion for readers and for other programs: matrix form, vectors, kinds of constraints.

mod axes;
mod code;
mod conditions;
mod contacts;
mod cosines;
mod identifiers;
mod latex;
mod matrix_form;
mod piecewise;
mod quasi_velocities;
mod reading;
mod sympy;
mod text;
mod turns;
mod vectors;

pub use axes::{axes, titles};
pub use code::{casadi, code, code_from, exchange, modelica};
pub use conditions::left_out;
pub use cosines::Cosine;
pub use latex::{Typeset, equations as typeset, latex};
pub use matrix_form::{HeldEquation, Lines, MatrixForm};
pub use piecewise::conditions_by_name;
pub use quasi_velocities::{Divisor, InQuasiVelocities};
pub use sympy::sympy;
pub use text::text;
pub(crate) use turns::{FreeTurn, short_form};
pub use vectors::{DerivedVector, derived_vectors, vectors};

use crate::Trace;
use crate::equations::{Equation, Integrability, Level, constraints_of as equations_of};
use num_traits::Zero;
use reading::Reading;
use symbolic::{Hypotheses, Node, Sym, normal};

/// Returns whether a text has several terms outside of parentheses.
pub(crate) fn is_sum(text: &str) -> bool {
    let mut depth = 0;
    text.char_indices().any(|(at, letter)| {
        match letter {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        depth == 0 && at > 0 && letter == ' '
    })
}

/// Prepares the simplification of expressions for printing, with symbols in the order of the model.
pub(crate) fn reading_of(trace: &Trace<'_>) -> Reading {
    let is_positive = |parameter: &crate::Parameter| parameter.value.is_some_and(|value| value > 0.0);
    let parameters = trace.parameters.iter().zip(&trace.model.parameters);
    let parameters = parameters.map(|(&letter, parameter)| (letter, is_positive(parameter))).chain([(trace.pi, true)]);
    let letters = [&trace.coordinates, &trace.speeds, &trace.accelerations].into_iter().flatten().copied();
    let named = cosines::cosines(trace).into_iter().map(|cosine| (cosine.value, cosine.letter));
    Reading::new(parameters, letters.chain([trace.time])).with_letters(named)
}

/// Returns a line for each constraint with its kind: on positions or on speeds; linear, affine or nonlinear in the speeds; with or
/// without the time. A last line states whether the constraints of speeds are integrable.
pub fn constraints(trace: &Trace<'_>) -> Vec<String> {
    let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let kind = |(k, (constraint, axis)): (usize, (Equation, Option<String>))| {
        let moves =
            constraint.row.iter().any(|slope| slope.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol)));
        let kind = match constraint.level {
            Level::Position => "of positions",
            Level::Speed if moves => "of speeds, nonlinear",
            Level::Speed if simplified(constraint.zero.substitute(&at_rest)).is_zero() => "of speeds, linear",
            Level::Speed => "of speeds, affine",
        };
        let knows_time = constraint.zero.symbols_of().contains(&trace.time);
        let time = if knows_time { ", with the time" } else { "" };
        format!("{}{}: {kind}{time}", constraint.title(k), axes::along(axis.as_deref()))
    };
    let equations = equations_of(trace);
    let kept = equations.iter().any(|constraint| constraint.level == Level::Position);
    let general = if kept { ", for general constants of those of positions" } else { "" };
    let whole = match Integrability::of(trace, &equations) {
        _ if equations.iter().all(|constraint| constraint.level == Level::Position) => None,
        Integrability::Open(why) => {
            Some(format!("constraints of speeds: it is not decided whether they are integrable, since {why}"))
        }
        Integrability::Integrable => Some("constraints of speeds: integrable (Frobenius, identified)".to_owned()),
        Integrability::NotIntegrable => Some(format!("constraints of speeds: not integrable (Frobenius{general})")),
    };
    let lines = equations.into_iter().zip(axes(trace)).enumerate().map(kind);
    lines.chain(whole).collect()
}

/// Replaces an overflowed number of operations by words.
pub(crate) fn with_counts(text: &str) -> String {
    text.replace(
        &format!("an expression of {} operations", u64::MAX),
        "an expression of more than 18 quintillion operations",
    )
}

/// Returns the shorter of two forms of an expression: a quotient of polynomials, or the form for reading with recombined angles and direction cosines.
///
/// Long expressions are unchanged.
pub fn shorter(trace: &Trace<'_>, expression: Sym) -> Sym {
    if Sym::operations_of(&[expression]) > MOST_SIMPLIFIED {
        return expression;
    }
    let forms = [simplified(expression), reading_of(trace).of(expression)];
    forms.into_iter().min_by_key(|form| Sym::operations_of(&[*form])).unwrap_or(expression)
}

/// Expressions with more operations are unchanged.
const MOST_SIMPLIFIED: usize = 2_000;

/// Returns the normal form, unless its denominator was multiplied by conjugates. These may vanish where the expression is defined, as
/// sin(a - q) sin(a + q) = cos(q)^2 - cos(a)^2 does for sin(a - q). In that case numerator and denominator are brought to normal form separately.
pub(crate) fn simplified_as_defined(expression: Sym) -> Sym {
    if Sym::operations_of(&[expression]) > MOST_SIMPLIFIED {
        return expression;
    }
    match normal(expression, &Hypotheses::none()) {
        Ok(form) if !has_conjugates(form.denominator()) => form.to_sym(),
        Ok(_) => {
            let quotient = |expression: Sym| {
                let leaves = expression.leaves_of().into_iter().filter(|leaf| !matches!(leaf.node(), Node::Symbol(_)));
                // names in systems contain no spaces, hence these are unused
                let named = |(k, leaf): (usize, Sym)| (leaf, Sym::symbol(&format!("leaf {k}")));
                let letters: Vec<(Sym, Sym)> = leaves.enumerate().map(named).collect();
                let back: Vec<(Sym, Sym)> = letters.iter().map(|&(leaf, letter)| (letter, leaf)).collect();
                let form = normal(expression.substitute(&letters), &Hypotheses::none()).ok()?;
                Some([form.numerator(), form.denominator()].map(|part| part.substitute(&back)))
            };
            let parts = |[above, below]: [Sym; 2]| quotient(simplified(above) / simplified(below));
            quotient(expression).and_then(parts).map_or(expression, |[above, below]| above / below)
        }
        Err(_) => expression,
    }
}

/// Returns whether a denominator in normal form has a factor that is a sum with angles or roots.
fn has_conjugates(denominator: Sym) -> bool {
    let mut open = vec![denominator];
    while let Some(each) = open.pop() {
        match each.node() {
            Node::Product(a, b) => open.extend([a, b]),
            Node::Power(a, _) | Node::Negation(a) => open.push(a),
            _ if each.node().is_leaf() => {}
            _ => {
                return each.leaves_of().iter().any(|leaf| !matches!(leaf.node(), Node::Symbol(_) | Node::Constant(_)));
            }
        }
    }
    false
}

pub(crate) fn simplified(expression: Sym) -> Sym {
    if Sym::operations_of(&[expression]) > MOST_SIMPLIFIED {
        return expression;
    }
    normal(expression, &Hypotheses::none()).map_or(expression, |form| form.to_sym())
}
