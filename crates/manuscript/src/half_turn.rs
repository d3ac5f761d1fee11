//! The number pi, a symbol that no point gives a value: pi is transcendental, so that an expression which is rational in it vanishes only where it
//! vanishes identically. Its sign follows from enclosures.

use claims::Condition;
use field::{Interval, Rational};
use std::f64::consts::PI;
use symbolic::{Hypotheses, Node, Sym, normal};

/// The number pi.
pub(crate) fn half_turn() -> Sym {
    Sym::symbol("pi")
}

/// Bounds of the number pi: 333/106 < pi < 355/113.
pub(crate) fn bounds() -> [Condition; 3] {
    let number = |above: i64, below: i64| Sym::constant(Rational::new(above, below));
    let pi = half_turn();
    [pi, pi - number(333, 106), number(355, 113) - pi].map(Condition::Positive)
}

/// Whether a symbol is the number pi.
pub(crate) fn is_half_turn(symbol: Sym) -> bool {
    symbol.symbol_name().is_some_and(|name| name == "pi")
}

/// Whether the number pi stands in an expression.
pub(crate) fn holds_half_turn(expression: Sym) -> bool {
    expression.symbols_of().into_iter().any(is_half_turn)
}

/// Whether an expression is a number by pi alone, such as cos(pi/5): no point gives it a value.
pub(crate) fn is_number_of_half_turn(expression: Sym) -> bool {
    let symbols = expression.symbols_of();
    !symbols.is_empty() && symbols.into_iter().all(is_half_turn)
}

/// The sign of an expression without letters other than pi, by an enclosure: none of one that has letters, or whose enclosure holds zero.
pub(crate) fn sign_of_number(expression: Sym) -> Option<i32> {
    let is_number = expression.symbols_of().into_iter().all(is_half_turn);
    is_number.then(|| enclosed(expression)?.sign()).flatten()
}

/// The enclosure of an expression without letters other than pi.
pub(crate) fn enclosed(number: Sym) -> Option<Interval> {
    // the double-precision number lies below pi
    number.evaluate_analytic(&|name: &str| (name == "pi").then(|| Interval::new(PI, PI.next_up()))).ok()
}

/// An expression in which sines and cosines of fractions of pi have their exact values.
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

/// The fraction of pi that an angle is.
fn half_turns_of(angle: Sym) -> Option<Rational> {
    let quotient = normal(angle / half_turn(), &Hypotheses::none()).ok()?;
    quotient.to_sym().as_constant().filter(|number| number.is_defined())
}
