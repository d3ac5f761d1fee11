//! Signs of expressions in real letters: in one unknown by roots of polynomials, for square roots by squares, by factors with known signs, and
//! by squares and discriminants.

use crate::circle_signs::circle_signs;
use crate::half_turn::sign_of_number;
use crate::line_signs::least;
use crate::motion::Motion;
use crate::natural_domain::{factors, natural_domain};
use crate::polynomial_signs;
use crate::signs::{Shown, is_written_as_positive};
use crate::square_sums;
use claims::Condition;
use symbolic::{Hypotheses, Node, Sym, coefficients, decide, normal};

/// The largest depth of nested rules.
const DEPTH: usize = 2;

/// The largest number of letters, numbers and signs in an expression that is examined.
const LONGEST: usize = 600;

/// Whether an expression is proved positive or nonnegative wherever it has a value and the conditions hold; `None` without a proof.
pub(crate) fn shows(expression: Sym, conditions: &[Condition]) -> Option<Shown> {
    if length(expression) > LONGEST {
        return None;
    }
    let short = |condition: &Condition| length(condition.expression()) <= LONGEST;
    let of_parts = natural_domain(&[expression]).into_iter().chain(circle_signs(&[expression], conditions));
    let known: Vec<Condition> = conditions.iter().copied().chain(of_parts).filter(short).collect();
    let known = with_factors(&known);
    let is_strict = is_at_least_zero(expression, &known, DEPTH)?;
    let evidence =
        "an expression without a negative value: by squares, discriminants and real roots, exactly".to_owned();
    Some(Shown { is_strict, evidence, is_of_normal_form: true })
}

/// The conditions, and the conditions that factors of nonzero products do not vanish.
fn with_factors(conditions: &[Condition]) -> Vec<Condition> {
    let mut all = conditions.to_vec();
    for condition in conditions {
        if let Condition::NonZero(of) | Condition::Positive(of) = condition {
            let parts = factors(*of).into_iter().map(Condition::NonZero);
            all.extend(parts.filter(|part| part.expression().as_constant().is_none()));
        }
    }
    all.dedup();
    all
}

/// The number of letters, numbers and signs in an expression, counted no further than slightly beyond `LONGEST`.
fn length(expression: Sym) -> usize {
    let (mut open, mut length) = (vec![expression], 0);
    while let Some(part) = open.pop().filter(|_| length <= LONGEST) {
        length += 1;
        open.extend(part.node().children());
    }
    length
}

/// `Some(true)`: the expression is proved positive under the conditions `known`; `Some(false)`: it is proved nonnegative; `None`: neither is proved.
/// `depth` is the number of nested steps of the proof that may still be made.
fn is_at_least_zero(expression: Sym, known: &[Condition], depth: usize) -> Option<bool> {
    if length(expression) > LONGEST {
        return None;
    }
    if let Some(value) = expression.as_constant() {
        return value.sign().filter(|sign| *sign >= 0).map(|sign| sign > 0);
    }
    if let Some(root) = Sym::ascending(&[expression]).into_iter().find(|part| matches!(part.node(), Node::Root(_))) {
        let by_root = || if depth == 0 { None } else { by_root(expression, root, known, depth) };
        return match is_written_as_positive(expression, known) {
            Some(true) => Some(true),
            written => by_root().or(written),
        };
    }
    // the first rule that proves positivity, otherwise the first that proves nonnegativity
    let rules: [&dyn Fn() -> Option<bool>; 5] = [
        &|| is_written_as_positive(expression, known),
        &|| least(expression, known).filter(|least| least.sign >= 0).map(|least| least.sign > 0),
        &|| polynomial_signs::shows(expression, known),
        &|| by_factor(expression, known, depth),
        &|| square_sums::shows(expression, known),
    ];
    let mut shown = None;
    for rule in rules {
        match rule() {
            Some(true) => return Some(true),
            found => shown = shown.or(found),
        }
    }
    shown
}

/// The sign of P + Q √a, by the signs of both parts, or of the difference of their squares.
fn by_root(expression: Sym, root: Sym, known: &[Condition], depth: usize) -> Option<bool> {
    let Node::Root(inside) = root.node() else { return None };
    let form = normal(expression, &Hypotheses::none()).ok()?;
    let of = |part: Sym| is_at_least_zero(part, known, depth - 1);
    let below = form.denominator();
    let (above, below) = match of(below) {
        Some(true) => (form.numerator(), below),
        _ => (-form.numerator(), -below),
    };
    if of(below) != Some(true) {
        return None;
    }
    let terms = coefficients(above, &[root]).ok()?;
    if terms.iter().any(|(exponents, _)| exponents[0] > 1) {
        return None;
    }
    let part = |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map_or(Sym::ZERO, |(_, c)| *c);
    let (plain, factor) = (part(0), part(1));
    let (plain_sign, factor_sign) = (of(plain), of(factor));
    if let (Some(plain_is), Some(factor_is)) = (plain_sign, factor_sign) {
        return Some(plain_is || factor_is && of(inside) == Some(true));
    }
    let difference = factor * factor * inside - plain * plain;
    let by_larger = |is_larger: bool, difference: Sym| if is_larger { of(difference) } else { None };
    by_larger(factor_sign.is_some(), difference).or_else(|| by_larger(plain_sign.is_some(), -difference))
}

/// The sign of an expression that is a condition, or the square of a nonzero expression, times an expression with a proved sign.
fn by_factor(expression: Sym, known: &[Condition], depth: usize) -> Option<bool> {
    if depth == 0 {
        return None;
    }
    let divided = |by: Sym| normal(expression / by, &Hypotheses::none()).ok().map(|form| form.to_sym());
    let longest = length(expression);
    known.iter().find_map(|condition| {
        let (by, is_strict) = match *condition {
            Condition::Positive(of) => (of, true),
            Condition::NotNegative(of) => (of, false),
            Condition::NonZero(of) => (of * of, true),
            _ => return None,
        };
        if by.symbols_of().iter().any(|symbol| !expression.symbols_of().contains(symbol)) {
            return None;
        }
        // a quotient that is longer means that the expression does not contain this factor
        let rest = divided(by).filter(|rest| length(*rest) <= longest)?;
        let of_number = || sign_of_number(rest).filter(|sign| *sign >= 0).map(|sign| sign > 0);
        let shown = is_at_least_zero(rest, known, depth - 1).or_else(of_number);
        shown.map(|rest| rest && is_strict)
    })
}

/// Whether an expression with roots is proved neither positive nor negative where the conditions hold, so that it vanishes.
pub(crate) fn vanishes_by_signs(expression: Sym, conditions: &[Condition]) -> bool {
    let has_root = Sym::ascending(&[expression]).into_iter().any(|part| matches!(part.node(), Node::Root(_)));
    has_root && [expression, -expression].into_iter().all(|side| shows(side, conditions).is_some())
}

/// Whether two sides have equal squares and equal signs.
pub(crate) fn are_equal_by_squares(sides: [Sym; 2], motion: &Motion<'_, '_>, conditions: &[Condition]) -> bool {
    let [left, right] = sides.map(|side| motion.reduced(side));
    let of_circles = circle_signs(&[left, right], conditions);
    let known = [conditions, &natural_domain(&[left, right]), &of_circles].concat();
    let is_up = |side: Sym| shows(side, &known).is_some();
    let squares = left * left - right * right;
    let have_one_sign = || is_up(left) && is_up(right) || is_up(-left) && is_up(-right);
    decide(squares, &motion.hypotheses).is_zero() && have_one_sign()
}
