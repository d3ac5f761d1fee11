//! Expressions as one straight-line program: a list of operations whose operands are earlier entries.

use serde::{Serialize, Serializer};
use std::collections::HashMap;
use symbolic::{Node, Sym};

/// An operation of a program; its operands are indices of earlier entries.
#[derive(Clone, Debug, PartialEq)]
pub enum Operation {
    /// A rational number, as text `p` or `p/q`.
    Constant(String),
    /// A letter that stands for any real number.
    Letter(String),
    /// `+`, `-`, `*` or `/` applied to two entries.
    Binary(&'static str, usize, usize),
    /// `neg`, `cos`, `sin` or `root` (the non-negative square root) applied to an entry.
    Unary(&'static str, usize),
    /// An entry to an integer power of at least two.
    Power(usize, u32),
    /// `exp`, `ln` or `tanh`, with the argument given twice, or `atan2` of two entries.
    Elementary(&'static str, usize, usize),
    /// An arbitrary smooth function of an entry, given by its name; each prime of the name is one derivative.
    Function(String, usize),
}

impl Serialize for Operation {
    /// Serialises as a list: the name of the operation, then its operands.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Operation::Constant(value) => ("const", value).serialize(serializer),
            Operation::Letter(name) => ("letter", name).serialize(serializer),
            Operation::Binary(name, a, b) => (name, a, b).serialize(serializer),
            Operation::Unary(name, a) => (name, a).serialize(serializer),
            Operation::Power(a, exponent) => ("pow", a, exponent).serialize(serializer),
            Operation::Elementary(name, a, b) => (name, a, b).serialize(serializer),
            Operation::Function(name, a) => ("function", name, a).serialize(serializer),
        }
    }
}

/// Records expressions of the calling thread as a program.
#[derive(Default)]
pub struct Recorder {
    /// The index of the entry of each recorded expression.
    places: HashMap<Sym, usize>,
    operations: Vec<Operation>,
}

impl Recorder {
    /// The index of the entry of an expression, without simplification; new entries are added after those of their operands.
    pub fn place(&mut self, expression: Sym) -> usize {
        for each in Sym::reached(&[expression], |each, _| !self.places.contains_key(&each)) {
            if !self.places.contains_key(&each) {
                let operation = self.operation(each);
                self.operations.push(operation);
                self.places.insert(each, self.operations.len() - 1);
            }
        }
        self.places[&expression]
    }

    /// The indices of the entries of several expressions.
    pub fn places(&mut self, expressions: impl IntoIterator<Item = Sym>) -> Vec<usize> {
        expressions.into_iter().map(|expression| self.place(expression)).collect()
    }

    /// The recorded program.
    pub fn finished(self) -> Vec<Operation> {
        self.operations
    }

    fn operation(&self, each: Sym) -> Operation {
        let at = |part: Sym| self.places[&part];
        match each.node() {
            Node::Constant(_) => Operation::Constant(each.to_string()),
            Node::Symbol(_) => Operation::Letter(each.to_string()),
            Node::Sum(a, b) => Operation::Binary("+", at(a), at(b)),
            Node::Difference(a, b) => Operation::Binary("-", at(a), at(b)),
            Node::Product(a, b) => Operation::Binary("*", at(a), at(b)),
            Node::Quotient(a, b) => Operation::Binary("/", at(a), at(b)),
            Node::Negation(a) => Operation::Unary("neg", at(a)),
            Node::Power(a, exponent) => Operation::Power(at(a), exponent),
            Node::Cos(a) => Operation::Unary("cos", at(a)),
            Node::Sin(a) => Operation::Unary("sin", at(a)),
            Node::Root(a) => Operation::Unary("root", at(a)),
            Node::Elementary(function, a, b) => Operation::Elementary(function.name(), at(a), at(b)),
            Node::Function(_, _, a) => {
                let text = each.to_string();
                let name = text.split('(').next().unwrap_or_default();
                Operation::Function(name.to_owned(), at(a))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::{Analytic, Scalar};
    use symbolic::symbols;

    #[test]
    fn an_expression_is_written_once_and_after_its_parts() {
        let [a, x] = symbols(["a", "x"]);
        let square = (a + x.circle().cos).powi(2);
        let mut recorder = Recorder::default();
        let places = recorder.places([square, square / Sym::ratio(1, 3), Sym::function("M", x)]);
        let text = serde_json::to_string(&recorder.finished()).unwrap_or_default();
        let program = r#"[["letter","a"],["letter","x"],["cos",1],["+",0,2],["pow",3,2],["const","1/3"],["/",4,5],["function","M",1]]"#;
        assert_eq!((text.as_str(), &places[..]), (program, &[4, 6, 7][..]));
    }
}
