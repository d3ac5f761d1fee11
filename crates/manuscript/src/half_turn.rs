//! The number π, represented by a symbol without a value at points. Since π is transcendental, an expression that is rational in π vanishes only if it
//! vanishes identically. Signs of such expressions follow from enclosures.

use claims::Condition;
use field::{Interval, Rational};
use std::f64::consts::PI;
use symbolic::{Hypotheses, Node, Sym, normal};

/// The symbol of the number π.
pub(crate) fn half_turn() -> Sym {
    Sym::symbol("pi")
}

/// Bounds of π as conditions: π > 0 and 333/106 < π < 355/113.
pub(crate) fn bounds() -> [Condition; 3] {
    let number = |above: i64, below: i64| Sym::constant(Rational::new(above, below));
    let pi = half_turn();
    [pi, pi - number(333, 106), number(355, 113) - pi].map(Condition::Positive)
}

/// Whether a symbol is that of the number π.
pub(crate) fn is_half_turn(symbol: Sym) -> bool {
    symbol.symbol_name().is_some_and(|name| name == "pi")
}

/// Whether an expression contains π.
pub(crate) fn holds_half_turn(expression: Sym) -> bool {
    expression.symbols_of().into_iter().any(is_half_turn)
}

/// Whether an expression is a number that contains π, such as cos(π/5).
pub(crate) fn is_number_of_half_turn(expression: Sym) -> bool {
    let symbols = expression.symbols_of();
    !symbols.is_empty() && symbols.into_iter().all(is_half_turn)
}

/// The sign of an expression without letters other than π, by an enclosure; `None` for other expressions, or if the enclosure contains zero.
pub(crate) fn sign_of_number(expression: Sym) -> Option<i32> {
    let is_number = expression.symbols_of().into_iter().all(is_half_turn);
    is_number.then(|| enclosed(expression)?.sign()).flatten()
}

/// An enclosure of an expression without letters other than π.
pub(crate) fn enclosed(number: Sym) -> Option<Interval> {
    // the double-precision number `PI` is less than π
    number.evaluate_analytic(&|name: &str| (name == "pi").then(|| Interval::new(PI, PI.next_up()))).ok()
}

/// An expression in which sines and cosines of fractions of π are replaced by their exact values.
pub(crate) fn with_exact_turns(expression: Sym) -> Sym {
    let value = |leaf: Sym| {
        let (Node::Cos(angle) | Node::Sin(angle)) = leaf.node() else { return None };
        let is_number = angle.symbols_of().into_iter().all(is_half_turn);
        let point = if is_number { Sym::of_half_turns(half_turns_of(angle)?)? } else { return None };
        Some((leaf, if matches!(leaf.node(), Node::Cos(_)) { point.cos } else { point.sin }))
    };
    let known: Vec<(Sym, Sym)> = Sym::ascending(&[expression]).into_iter().filter_map(value).collect();
    if known.is_empty() { expression } else { expression.substitute(&known) }
}

/// The quotient of an angle and π, if it is a rational number.
fn half_turns_of(angle: Sym) -> Option<Rational> {
    let quotient = normal(angle / half_turn(), &Hypotheses::none()).ok()?;
    quotient.to_sym().as_constant().filter(|number| number.is_defined())
}
