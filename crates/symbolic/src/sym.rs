//! Constructors of expressions, and the scalar traits.

use crate::Sym;
use crate::graph::{Name, Node};
use field::{Base, Circle, Over, Rational, Scalar};
use num_traits::{One, Zero};
use std::fmt;

/// Returns the symbols with the given names: `let [l1, l2, l3] = symbols(["l1", "l2", "l3"])`.
pub fn symbols<const N: usize>(names: [&str; N]) -> [Sym; N] {
    names.map(Sym::symbol)
}

impl Sym {
    /// Returns the symbol with this name. Within a thread, equal names give equal symbols.
    pub fn symbol(name: &str) -> Self {
        Sym::from_node(Node::Symbol(Name::of(name)))
    }

    /// Returns the symbol with this name and sets its LaTeX form. A later call replaces the LaTeX form.
    pub fn named(name: &str, latex: &str) -> Self {
        let name = Name::of(name);
        name.set_latex(latex);
        Sym::from_node(Node::Symbol(name))
    }

    /// Returns the value of an arbitrary smooth function. Its derivatives are functions of higher order, printed as `M2'`, `M2''`.
    pub fn function(name: &str, argument: Sym) -> Self {
        Sym::function_of_order(Name::of(name), 0, argument)
    }

    pub(crate) fn function_of_order(name: Name, order: u32, argument: Sym) -> Self {
        if argument == Sym::UNDEFINED {
            return Sym::UNDEFINED;
        }
        Sym::from_node(Node::Function(name, order, argument))
    }

    /// Returns an integer power; a negative exponent gives a quotient.
    pub fn powi(self, exponent: i32) -> Self {
        let size = exponent.unsigned_abs();
        let power = match (size, self.as_constant()) {
            (_, Some(value)) => Sym::constant((0..size).fold(Rational::one(), |product, _| product * value)),
            (0, _) => Sym::ONE,
            (1, _) => self,
            _ => Sym::from_node(Node::Power(self, size)),
        };
        if exponent < 0 { Sym::ONE / power } else { power }
    }

    /// Returns unexpanded (cos, sin) of an angle, such as cos(a - b), for printing. Decisions and runs need the expanded form
    /// of [`field::Analytic::circle`].
    pub fn circle_as_written(self) -> Circle<Sym> {
        Circle { cos: Sym::from_node(Node::Cos(self)), sin: Sym::from_node(Node::Sin(self)) }
    }

    /// Splits the expression into distinct terms with rational coefficients, in the order of their appearance. A constant is a multiple of the
    /// term 1.
    pub fn linear_terms(self) -> Vec<(Sym, Rational)> {
        crate::analytic::linear_terms(self)
    }

    /// Returns the name of a symbol; `None` for other expressions.
    pub fn symbol_name(self) -> Option<String> {
        match self.node() {
            Node::Symbol(name) => Some(name.text().to_string()),
            _ => None,
        }
    }
}

impl Zero for Sym {
    fn zero() -> Self {
        Sym::ZERO
    }

    /// Returns whether this is the constant 0. Use [`decide`](crate::decide) for expressions that may simplify to 0.
    fn is_zero(&self) -> bool {
        *self == Sym::ZERO
    }
}

impl One for Sym {
    fn one() -> Self {
        Sym::ONE
    }
}

impl Scalar for Sym {
    const CALLS: bool = true;

    fn ratio(numerator: i64, denominator: i64) -> Self {
        match (numerator, denominator) {
            (0, 1) => Sym::ZERO,
            (1, 1) => Sym::ONE,
            _ => Sym::constant(Rational::new(numerator, denominator)),
        }
    }
}

impl Base for Sym {}

impl Over<Sym> for Sym {
    #[inline]
    fn lift(parameter: Sym) -> Self {
        parameter
    }
}

/// A parameter read as `f64` becomes an exact constant.
impl Over<f64> for Sym {
    fn lift(parameter: f64) -> Self {
        Sym::constant(Rational::exactly(parameter))
    }
}

impl Over<Rational> for Sym {
    fn lift(parameter: Rational) -> Self {
        Sym::constant(parameter)
    }
}

impl fmt::Debug for Sym {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
