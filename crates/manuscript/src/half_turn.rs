//! The number pi, a symbol that no point gives a value: pi is transcendental, so that an expression which is rational in it vanishes only where it
//! vanishes identically. Its sign follows from enclosures.

use field::Interval;
use std::f64::consts::PI;
use symbolic::Sym;

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
