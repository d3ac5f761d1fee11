//! Printing of expressions as text, LaTeX and SymPy. Terms and factors are printed in the order in which they were written.

mod decimal;
mod latex;
mod names;
mod sympy;
mod text;

pub(crate) use names::natural_key;

use crate::Sym;
use crate::graph::{Name, Node};
use field::{Elementary, Rational};
use rustc_hash::FxHashMap;
use std::fmt;

/// The size, in symbols and operators, beyond which only the size of an expression is printed.
const LONGEST: u64 = 200_000;

impl fmt::Display for Sym {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match written_size(*self) {
            size if size > LONGEST => write!(f, "(an expression of {size} operations)"),
            _ => f.write_str(&Writer(&text::Text, Numbers::Fractions).whole(*self)),
        }
    }
}

impl Sym {
    /// Returns the expression in LaTeX, for mathematical mode.
    pub fn latex(self) -> String {
        match written_size(self) {
            size if size > LONGEST => format!("\\text{{(an expression of {size} operations)}}"),
            _ => Writer(&latex::Latex, Numbers::Fractions).whole(self),
        }
    }
}

impl Sym {
    /// Returns the expression as text, with decimals where these are shorter than fractions: 0.35 in place of 7/20, but 1/2.
    pub fn decimal_text(self) -> String {
        match written_size(self) {
            size if size > LONGEST => self.to_string(),
            _ => Writer(&text::Text, Numbers::Decimals).whole(self),
        }
    }

    /// Returns the expression in LaTeX, with decimals where these are shorter than fractions.
    pub fn decimal_latex(self) -> String {
        match written_size(self) {
            size if size > LONGEST => self.latex(),
            _ => Writer(&latex::Latex, Numbers::Decimals).whole(self),
        }
    }

    /// Returns the expression in Python with the functions of SymPy: `Rational`, `sqrt`, `cos`, `sin`. Symbols are printed as their [`Sym::identifier`].
    pub fn sympy(self) -> String {
        match written_size(self) {
            size if size > LONGEST => format!("# an expression of {size} operations\n"),
            _ => Writer(&sympy::SymPy, Numbers::Fractions).whole(self),
        }
    }

    /// Returns the Python identifier of a symbol; `None` for other expressions.
    pub fn identifier(self) -> Option<String> {
        self.symbol_name().map(|name| sympy::identifier(&name))
    }
}

/// The binding strength of a printed part, for parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    Sum,
    Product,
    Power,
    Atom,
}

/// A printed expression without its sign.
struct Printed {
    text: String,
    bond: Bond,
}

/// The notation of a printed language. The provided methods give the notation of programming languages, on one line.
trait Notation {
    fn symbol(&self, name: Name) -> String;
    fn number(&self, size: Rational) -> Printed;
    fn power(&self, base: Printed, exponent: u32) -> Printed;
    fn derivative(&self, name: Name, order: u32, argument: String) -> String;

    fn decimal(&self, digits: String) -> Printed {
        let bond = if digits.contains('e') { Bond::Product } else { Bond::Atom };
        Printed { text: digits, bond }
    }

    fn parentheses(&self, inside: &str) -> String {
        format!("({inside})")
    }

    fn product(&self, factors: &[String]) -> String {
        factors.join("*")
    }

    fn quotient(&self, above: Printed, below: Printed) -> Printed {
        let text = format!("{}/{}", self.held(above, Bond::Product), self.held(below, Bond::Power));
        Printed { text, bond: Bond::Product }
    }

    fn root(&self, square: String) -> String {
        format!("sqrt({square})")
    }

    fn elementary(&self, function: Elementary, arguments: &str) -> String {
        format!("{}({arguments})", function.name())
    }

    /// Prints a power of a cosine or sine; `function` is `cos` or `sin`.
    fn circle(&self, function: &str, angle: Printed, exponent: u32) -> Printed {
        let base = Printed { text: format!("{function}({})", angle.text), bond: Bond::Atom };
        if exponent == 1 { base } else { self.power(base, exponent) }
    }

    fn held(&self, printed: Printed, bond: Bond) -> String {
        if printed.bond < bond { self.parentheses(&printed.text) } else { printed.text }
    }
}

/// The notation of rational constants.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Numbers {
    /// Fractions only.
    Fractions,
    /// Decimals where these are shorter: see [`decimal`].
    Decimals,
}

struct Writer<'a>(&'a dyn Notation, Numbers);

impl Writer<'_> {
    fn whole(&self, expression: Sym) -> String {
        let (negative, printed) = self.signed(expression);
        format!("{}{}", if negative { "-" } else { "" }, printed.text)
    }

    /// Prints an expression including its sign.
    fn unsigned(&self, expression: Sym) -> Printed {
        match self.signed(expression) {
            (false, printed) => printed,
            (true, printed) => Printed { text: format!("-{}", printed.text), bond: Bond::Sum },
        }
    }

    /// Returns whether the printed expression is negative, and its absolute part.
    fn signed(&self, expression: Sym) -> (bool, Printed) {
        if matches!(expression.node(), Node::Sum(..) | Node::Difference(..)) {
            return (false, self.sum(expression));
        }
        let (negative, factors) = factors(expression);
        let printed = match factors.as_slice() {
            [] => self.0.number(Rational::new(1, 1)),
            [(factor, exponent)] if negative => {
                Printed { text: self.0.held(self.factor(*factor, *exponent), Bond::Product), bond: Bond::Product }
            }
            [(factor, exponent)] => self.factor(*factor, *exponent),
            _ => {
                let held = |&(factor, exponent)| self.0.held(self.factor(factor, exponent), Bond::Product);
                let held: Vec<String> = factors.iter().map(held).collect();
                Printed { text: self.0.product(&held), bond: Bond::Product }
            }
        };
        (negative, printed)
    }

    /// Prints a sum from left to right. A sum that is subtracted stays in parentheses.
    fn sum(&self, expression: Sym) -> Printed {
        let mut terms = Vec::new();
        let mut open = vec![(expression, false)];
        while let Some((next, subtracted)) = open.pop() {
            match next.node() {
                Node::Sum(a, b) if !subtracted => open.extend([(b, false), (a, false)]),
                Node::Difference(a, b) if !subtracted => open.extend([(b, true), (a, false)]),
                _ => terms.push((next, subtracted)),
            }
        }
        let mut text = String::new();
        for (place, (term, subtracted)) in terms.into_iter().enumerate() {
            let (negative, printed) = self.signed(term);
            text.push_str(match (place, negative != subtracted) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            });
            let bond = if subtracted { Bond::Product } else { Bond::Sum };
            text.push_str(&self.0.held(printed, bond));
        }
        Printed { text, bond: Bond::Sum }
    }

    fn factor(&self, factor: Sym, exponent: u32) -> Printed {
        let atom = |text| Printed { text, bond: Bond::Atom };
        let base = match factor.node() {
            Node::Constant(_) => match factor.as_constant() {
                Some(value) => match decimal::shorter(value) {
                    Some(decimal) if self.1 == Numbers::Decimals => self.0.decimal(decimal),
                    _ => self.0.number(value),
                },
                None => atom(String::new()),
            },
            Node::Symbol(name) => atom(self.0.symbol(name)),
            Node::Cos(angle) => return self.0.circle("cos", self.unsigned(angle), exponent),
            Node::Sin(angle) => return self.0.circle("sin", self.unsigned(angle), exponent),
            Node::Root(square) => atom(self.0.root(self.whole(square))),
            Node::Elementary(function, first, second) => {
                let arguments: Vec<String> =
                    [first, second].into_iter().take(function.arguments()).map(|each| self.whole(each)).collect();
                atom(self.0.elementary(function, &arguments.join(", ")))
            }
            Node::Function(name, order, argument) => atom(self.0.derivative(name, order, self.whole(argument))),
            Node::Quotient(above, below) => {
                let (_, printed) = self.signed(above);
                self.0.quotient(printed, self.unsigned(below))
            }
            _ => self.unsigned(factor),
        };
        if exponent == 1 { base } else { self.0.power(base, exponent) }
    }
}

/// Returns whether a product is negative, and its factors with exponents. Equal neighbouring factors become one power.
fn factors(expression: Sym) -> (bool, Vec<(Sym, u32)>) {
    let mut negative = false;
    let mut factors: Vec<(Sym, u32)> = Vec::new();
    let mut open = vec![expression];
    while let Some(next) = open.pop() {
        let (base, exponent) = match next.node() {
            Node::Product(a, b) => {
                open.extend([b, a]);
                continue;
            }
            Node::Negation(a) => {
                negative = !negative;
                open.push(a);
                continue;
            }
            Node::Quotient(above, _) => {
                negative ^= !matches!(above.node(), Node::Sum(..) | Node::Difference(..)) && self::factors(above).0;
                (next, 1)
            }
            Node::Constant(_) if next.as_constant().and_then(Rational::sign) == Some(-1) => {
                negative = !negative;
                (-next, 1)
            }
            Node::Power(a, n) => (a, n),
            _ => (next, 1),
        };
        if base == Sym::ONE {
            continue;
        }
        match factors.last_mut() {
            Some((last, count)) if *last == base && base.as_constant().is_none() => *count += exponent,
            _ => factors.push((base, exponent)),
        }
    }
    (negative, factors)
}

/// Returns the number of symbols and operators of the printed expression, in which shared subexpressions are repeated.
fn written_size(expression: Sym) -> u64 {
    let mut sizes: FxHashMap<Sym, u64> = FxHashMap::default();
    for each in Sym::ascending(&[expression]) {
        let size = each.node().children().fold(1u64, |sum, child| sum.saturating_add(sizes[&child]));
        sizes.insert(each, size);
    }
    sizes[&expression]
}
