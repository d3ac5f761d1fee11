//! Expressions as text, in the order in which they were written.

use crate::Sym;
use crate::graph::Node;
use std::fmt;

impl fmt::Display for Sym {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&text(*self))
    }
}

fn text(expression: Sym) -> String {
    let inside = |a: Sym| match a.node() {
        Node::Symbol(_) | Node::Cos(_) | Node::Sin(_) | Node::Root(_) | Node::Function(..) => text(a),
        _ => format!("({})", text(a)),
    };
    match expression.node() {
        Node::Constant(_) => expression.as_constant().map_or_else(String::new, |value| value.to_string()),
        Node::Symbol(name) => name.text().to_string(),
        Node::Sum(a, b) => format!("{} + {}", text(a), text(b)),
        Node::Difference(a, b) => format!("{} - {}", text(a), inside(b)),
        Node::Product(a, b) => format!("{}*{}", inside(a), inside(b)),
        Node::Quotient(a, b) => format!("{}/{}", inside(a), inside(b)),
        Node::Negation(a) => format!("-{}", inside(a)),
        Node::Power(a, n) => format!("{}^{n}", inside(a)),
        Node::Cos(a) => format!("cos({})", text(a)),
        Node::Sin(a) => format!("sin({})", text(a)),
        Node::Root(a) => format!("sqrt({})", text(a)),
        Node::Function(name, order, a) => format!("{}{}({})", name.text(), "'".repeat(order as usize), text(a)),
    }
}

/// A key under which names sort as people sort them: digits by their number.
pub(crate) fn natural_key(name: &str) -> Vec<(u64, char)> {
    let mut key = Vec::new();
    let mut number = None;
    for letter in name.chars() {
        match letter.to_digit(10) {
            Some(digit) => number = Some(number.unwrap_or(0u64).saturating_mul(10).saturating_add(digit.into())),
            None => {
                key.extend(number.take().map(|n| (n + 1, '\0')));
                key.push((0, letter));
            }
        }
    }
    key.extend(number.map(|n| (n + 1, '\0')));
    key
}
