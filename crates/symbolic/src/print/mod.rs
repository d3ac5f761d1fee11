//! Expressions as text, LaTeX and SymPy, in the order in which they were written.

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

/// The number of symbols and signs beyond which an expression is replaced by its size.
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
    /// The expression in LaTeX, for mathematical mode.
    pub fn latex(self) -> String {
        match written_size(self) {
            size if size > LONGEST => format!("\\text{{(an expression of {size} operations)}}"),
            _ => Writer(&latex::Latex, Numbers::Fractions).whole(self),
        }
    }
}

impl Sym {
    /// The expression as text, with decimals where these are shorter than fractions: 0.35 and not 7/20, but 1/2.
    pub fn decimal_text(self) -> String {
        match written_size(self) {
            size if size > LONGEST => self.to_string(),
            _ => Writer(&text::Text, Numbers::Decimals).whole(self),
        }
    }

    /// The expression in LaTeX, with decimals where these are shorter than fractions.
    pub fn decimal_latex(self) -> String {
        match written_size(self) {
            size if size > LONGEST => self.latex(),
            _ => Writer(&latex::Latex, Numbers::Decimals).whole(self),
        }
    }

    /// The expression in Python, over the names of SymPy: `Rational`, `sqrt`, `cos`, `sin` and [`Sym::identifier`]s.
    pub fn sympy(self) -> String {
        match written_size(self) {
            size if size > LONGEST => format!("# an expression of {size} operations\n"),
            _ => Writer(&sympy::SymPy, Numbers::Fractions).whole(self),
        }
    }

    /// The identifier of a symbol in that notation; `None` for other expressions.
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

/// A printed part, without its sign.
struct Printed {
    text: String,
    bond: Bond,
}

/// The differences between notations; on one line unless they say otherwise.
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

    /// `cos` or `sin` of an argument, and its power.
    fn circle(&self, function: &str, angle: Printed, exponent: u32) -> Printed {
        let base = Printed { text: format!("{function}({})", angle.text), bond: Bond::Atom };
        if exponent == 1 { base } else { self.power(base, exponent) }
    }

    fn held(&self, printed: Printed, bond: Bond) -> String {
        if printed.bond < bond { self.parentheses(&printed.text) } else { printed.text }
    }
}

/// The form in which constants are written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Numbers {
    /// Always fractions.
    Fractions,
    /// Decimals where they are shorter: see [`decimal`].
    Decimals,
}

struct Writer<'a>(&'a dyn Notation, Numbers);

impl Writer<'_> {
    fn whole(&self, expression: Sym) -> String {
        let (negative, printed) = self.signed(expression);
        format!("{}{}", if negative { "-" } else { "" }, printed.text)
    }

    /// The expression with its sign inside.
    fn unsigned(&self, expression: Sym) -> Printed {
        match self.signed(expression) {
            (false, printed) => printed,
            (true, printed) => Printed { text: format!("-{}", printed.text), bond: Bond::Sum },
        }
    }

    /// The sign and the rest.
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

    /// Terms from the left; a part in parentheses on the right of a minus keeps them.
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

/// The sign of a product and its factors, with equal neighbours gathered into a power.
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

/// The size of the expression written out, every shared part as often as it occurs.
fn written_size(expression: Sym) -> u64 {
    let mut sizes: FxHashMap<Sym, u64> = FxHashMap::default();
    for each in Sym::ascending(&[expression]) {
        let size = each.node().children().fold(1u64, |sum, child| sum.saturating_add(sizes[&child]));
        sizes.insert(each, size);
    }
    sizes[&expression]
}
