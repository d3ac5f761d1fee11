//! The domain of an expression: divisors do not vanish, radicands are nonnegative.

use claims::Condition;
use symbolic::{Node, Sym};

/// The conditions under which all parts of some expressions have values.
pub(crate) fn natural_domain(expressions: &[Sym]) -> Vec<Condition> {
    let mut all: Vec<Condition> = Vec::new();
    let mut add = |condition: Condition| {
        if condition.expression().as_constant().is_none() && !all.contains(&condition) {
            all.push(condition);
        }
    };
    for each in Sym::ascending(expressions) {
        match each.node() {
            Node::Quotient(_, below) => factors(below).into_iter().for_each(|factor| match factor.node() {
                Node::Root(inside) => add(Condition::Positive(inside)),
                _ => add(Condition::NonZero(factor)),
            }),
            Node::Root(inside) => add(Condition::NotNegative(inside)),
            _ => {}
        }
    }
    all
}

/// The written divisors in an expression, without simplification.
pub(crate) fn written_divisors(expression: Sym) -> Vec<Sym> {
    let divisor = |part: Sym| match part.node() {
        Node::Quotient(_, below) if below.as_constant().is_none() => Some(below),
        _ => None,
    };
    // each shared part is visited once, since multiples of an angle have many parts in common
    Sym::ascending(&[expression]).into_iter().filter_map(divisor).collect()
}

/// The factors of a product, without exponents.
pub(crate) fn factors(product: Sym) -> Vec<Sym> {
    match product.node() {
        Node::Product(a, b) => [factors(a), factors(b)].concat(),
        Node::Power(of, _) | Node::Negation(of) => factors(of),
        _ => vec![product],
    }
}
