//! Expressions as sums of squares and of products of given conditions, whose form shows the sign.

use crate::circle_forms::{by_bounds, by_squares_of_circles};
use crate::line_signs::number;
use crate::natural_domain::natural_domain;
use crate::signs::is_written_as_positive;
use claims::Condition;
use std::cell::Cell;
use symbolic::{Hypotheses, Node, Sym, coefficients, normal};

/// The largest depth of nested completions of the square.
const DEPTH: usize = 4;

/// An expression in a form whose terms show its sign, and the conditions that this form uses.
pub(crate) struct SquareSum {
    pub written: Sym,
    pub known: Vec<Condition>,
}

/// The largest number of operations of an expression that [`shows`] examines.
const LONGEST: usize = 240;

/// The largest number of parts of an expression that [`shows`] examines.
const MOST_PARTS: u32 = 300;

/// The limits of a search.
struct Effort {
    /// The number of parts that may still be examined.
    left: Cell<u32>,
    /// Whether only forms that prove positivity are accepted.
    excludes_zero: bool,
}

/// Whether a short expression with sines or cosines is proved nonnegative as a sum of squares and of products of conditions. `None` without a proof,
/// otherwise whether it is positive.
pub(crate) fn shows(expression: Sym, conditions: &[Condition]) -> Option<bool> {
    // polynomials in letters are left to other rules
    let is_circle = |leaf: &Sym| matches!(leaf.node(), Node::Cos(_) | Node::Sin(_));
    if Sym::operations_of(&[expression]) > LONGEST || !expression.leaves_of().iter().any(is_circle) {
        return None;
    }
    let within = |excludes_zero: bool| {
        let effort = Effort { left: Cell::new(MOST_PARTS), excludes_zero };
        within(expression, excludes_zero, conditions, &effort)
    };
    within(false).map(|_| within(true).is_some())
}

/// The form of an expression that shows its sign; `None` if none was found.
pub(crate) fn square_sum(expression: Sym, is_strict: bool, conditions: &[Condition]) -> Option<SquareSum> {
    within(expression, is_strict, conditions, &Effort { left: Cell::new(u32::MAX), excludes_zero: false })
}

fn within(expression: Sym, is_strict: bool, conditions: &[Condition], effort: &Effort) -> Option<SquareSum> {
    // an expression in one angle alone is left to the rule of real roots
    if !expression.leaves_of().iter().any(|leaf| leaf.symbol_name().is_some()) {
        return None;
    }
    let known = [conditions, &natural_domain(&[expression])].concat();
    let form = normal(expression, &Hypotheses::none()).ok()?;
    let of = |part: Sym| sum(part, &known, DEPTH, effort);
    let (above, below) = match of(form.denominator()) {
        Some(below) => (of(form.numerator())?, below),
        None => (of(-form.numerator())?, of(-form.denominator())?),
    };
    let written = if below == Sym::ONE { above } else { above / below };
    let is_shown = is_written_as_positive(written, &known)? || !is_strict;
    let is_same = normal(written - expression, &Hypotheses::none()).ok()?.is_zero();
    (is_shown && is_same).then_some(SquareSum { written, known })
}

fn sum(polynomial: Sym, known: &[Condition], depth: usize, effort: &Effort) -> Option<Sym> {
    effort.left.set(effort.left.get().checked_sub(1)?);
    let polynomial = normal(polynomial, &Hypotheses::none()).ok()?.to_sym();
    if is_written_as_positive(polynomial, known).is_some() {
        return Some(polynomial);
    }
    if let Some(form) = by_squares_of_circles(polynomial, known) {
        return Some(form);
    }
    if depth == 0 || polynomial.as_constant().is_some() {
        return None;
    }
    let letters = || polynomial.symbols_of().into_iter();
    let by_powers = || letters().find_map(|letter| by_powers(polynomial, letter, known, depth, effort));
    let by_square = || letters().find_map(|letter| by_square(polynomial, letter, known, depth, effort));
    let by_factor = || known.iter().find_map(|condition| by_factor(polynomial, *condition, known, depth, effort));
    let by_edge = || known.iter().find_map(|condition| by_edge(polynomial, *condition, known, depth, effort));
    let by_bounds = || by_bounds(polynomial, |part| sum(part, known, depth - 1, effort));
    let rules: [&dyn Fn() -> Option<Sym>; 5] = [&by_powers, &by_square, &by_factor, &by_edge, &by_bounds];
    let mut found = rules.into_iter().filter_map(|rule| rule());
    if !effort.excludes_zero {
        return found.next();
    }
    // a completed square may vanish where a form with a slack variable does not
    let first = found.next()?;
    let is_strict = |form: &Sym| is_written_as_positive(*form, known) == Some(true);
    if is_strict(&first) { Some(first) } else { found.find(is_strict).or(Some(first)) }
}

/// The form as a sum of powers of a letter with nonnegative coefficients, all powers nonnegative.
fn by_powers(polynomial: Sym, letter: Sym, known: &[Condition], depth: usize, effort: &Effort) -> Option<Sym> {
    let terms = coefficients(polynomial, &[letter]).ok().filter(|terms| terms.len() > 1)?;
    let term = |(exponents, value): (Vec<u32>, Sym)| {
        let power = letter.powi(exponents[0] as i32);
        is_written_as_positive(power, known)?;
        Some(sum(value, known, depth - 1, effort)? * power)
    };
    terms.into_iter().map(term).try_fold(Sym::ZERO, |sum, term| Some(sum + term?))
}

/// The form of a s²ⁿ + b sⁿ + c as a (sⁿ + b/2a)² + (4 a c - b²)/4a.
fn by_square(polynomial: Sym, letter: Sym, known: &[Condition], depth: usize, effort: &Effort) -> Option<Sym> {
    let terms = coefficients(polynomial, &[letter]).ok()?;
    let degree = terms.iter().map(|(exponents, _)| exponents[0]).max().filter(|degree| degree % 2 == 0)?;
    let is_quadratic = terms.iter().all(|(exponents, _)| [0, degree / 2, degree].contains(&exponents[0]));
    if !is_quadratic || degree == 0 {
        return None;
    }
    let of =
        |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map_or(Sym::ZERO, |(_, value)| *value);
    let (a, b, c) = (of(degree), of(degree / 2), of(0));
    let lead = sum(a, known, depth - 1, effort).filter(|lead| is_written_as_positive(*lead, known) == Some(true))?;
    let rest = sum(number(4) * a * c - b * b, known, depth - 1, effort)?;
    let square = (letter.powi((degree / 2) as i32) + b / (number(2) * a)).powi(2);
    Some(lead * square + rest / (number(4) * lead))
}

/// The form as a condition, or the square of a nonzero expression, times a form of the quotient.
fn by_factor(polynomial: Sym, condition: Condition, known: &[Condition], depth: usize, effort: &Effort) -> Option<Sym> {
    let by = match condition {
        Condition::Positive(of) | Condition::NotNegative(of) => of,
        Condition::NonZero(of) => of.powi(2),
        _ => return None,
    };
    let rest = normal(polynomial / by, &Hypotheses::none()).ok().filter(|rest| rest.denominator() == Sym::ONE)?;
    Some(by * sum(rest.to_sym(), known, depth - 1, effort)?)
}

/// The form after replacement of a letter, in which a condition is linear, by the value of the condition (a slack variable).
fn by_edge(polynomial: Sym, condition: Condition, known: &[Condition], depth: usize, effort: &Effort) -> Option<Sym> {
    let (Condition::Positive(of) | Condition::NotNegative(of)) = condition else { return None };
    if of.symbol_name().is_some() {
        return None;
    }
    let edge = Sym::symbol("distance from an edge");
    of.symbols_of().into_iter().find_map(|letter| {
        let terms = coefficients(of, &[letter]).ok()?;
        let part = |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map(|(_, value)| *value);
        let factor = part(1)?.as_constant().filter(|_| terms.iter().all(|(exponents, _)| exponents[0] <= 1))?;
        let value = (edge - part(0).unwrap_or(Sym::ZERO)) / Sym::constant(factor);
        let others = known.iter().filter(|other| **other != condition).copied();
        let with = others.chain([condition.mapped(|_| edge)]).collect::<Vec<_>>();
        Some(sum(polynomial.substitute(&[(letter, value)]), &with, depth - 1, effort)?.substitute(&[(edge, of)]))
    })
}
