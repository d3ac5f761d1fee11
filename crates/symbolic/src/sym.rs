//! Making expressions, and their scalar traits.

use crate::Sym;
use crate::graph::{Name, Node};
use field::{Base, Circle, Over, Rational, Scalar};
use num_traits::{One, Zero};
use std::fmt;

/// Symbols by their names: `let [l1, l2, l3] = symbols(["l1", "l2", "l3"])`.
pub fn symbols<const N: usize>(names: [&str; N]) -> [Sym; N] {
    names.map(Sym::symbol)
}

impl Sym {
    /// The symbol with this name; within a thread the same name is the same symbol.
    pub fn symbol(name: &str) -> Self {
        Sym::from_node(Node::Symbol(Name::of(name)))
    }

    /// A symbol that prints in LaTeX as given. The LaTeX given last holds.
    pub fn named(name: &str, latex: &str) -> Self {
        let name = Name::of(name);
        name.set_latex(latex);
        Sym::from_node(Node::Symbol(name))
    }

    /// An arbitrary smooth law of one argument. Its derivative is the function of the next order: `M2'`, `M2''`.
    pub fn function(name: &str, argument: Sym) -> Self {
        Sym::function_of_order(Name::of(name), 0, argument)
    }

    pub(crate) fn function_of_order(name: Name, order: u32, argument: Sym) -> Self {
        if argument == Sym::UNDEFINED {
            return Sym::UNDEFINED;
        }
        Sym::from_node(Node::Function(name, order, argument))
    }

    /// The integer power; negative ones are quotients.
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

    /// The circle point of an angle as it is written: cos(a - b), not expanded. For reading only: decisions and runs work with
    /// [`field::Analytic::circle`].
    pub fn circle_as_written(self) -> Circle<Sym> {
        Circle { cos: Sym::from_node(Node::Cos(self)), sin: Sym::from_node(Node::Sin(self)) }
    }

    /// The expression as a sum of distinct terms with rational coefficients, in the order of writing; the constant is a multiple of
    /// the term 1.
    pub fn linear_terms(self) -> Vec<(Sym, Rational)> {
        crate::analytic::linear_terms(self)
    }

    /// The name of a symbol; `None` for anything else.
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

    /// Whether this is the constant 0. An expression that merely vanishes is for [`decide`](crate::decide).
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

/// Data read as `f64` are exact constants.
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
