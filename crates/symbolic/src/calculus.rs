//! Derivatives, substitution, and the symbols of an expression.

use crate::Sym;
use crate::graph::Node;
use field::{Analytic, Scalar};
use rustc_hash::FxHashMap;

/// Forward differentiation: rates of expressions whose symbols have given rates. If the rates are velocities, the result is d/dt along the motion; if x
/// has the rate one and all else zero, it is d/dx. Rates are cached, so that a subexpression shared by several expressions is differentiated once.
pub struct Derivation {
    known: FxHashMap<Sym, Sym>,
}

impl Derivation {
    /// Creates a derivation from pairs (expression, rate); all other symbols are constant. An expression that is not a symbol counts as an
    /// independent quantity wherever it occurs.
    pub fn new(rates: impl IntoIterator<Item = (Sym, Sym)>) -> Self {
        Derivation { known: rates.into_iter().collect() }
    }

    /// Returns the rate of an expression.
    pub fn of(&mut self, expression: Sym) -> Sym {
        if let Some(&known) = self.known.get(&expression) {
            return known;
        }
        let open = Sym::reached(&[expression], |each, _| !self.known.contains_key(&each));
        for each in open {
            if self.known.contains_key(&each) {
                continue;
            }
            let slope = |a: &Sym| self.known[a];
            let value = match each.node() {
                Node::Constant(_) | Node::Symbol(_) => Sym::ZERO,
                Node::Sum(a, b) => slope(&a) + slope(&b),
                Node::Difference(a, b) => slope(&a) - slope(&b),
                Node::Product(a, b) => slope(&a) * b + a * slope(&b),
                Node::Quotient(a, b) if slope(&b) == Sym::ZERO => slope(&a) / b,
                Node::Quotient(a, b) => (slope(&a) - each * slope(&b)) / b,
                Node::Negation(a) => -slope(&a),
                Node::Power(a, n) => Sym::int(n.into()) * a.powi(n as i32 - 1) * slope(&a),
                Node::Cos(a) => -(Sym::from_node(Node::Sin(a)) * slope(&a)),
                Node::Sin(a) => Sym::from_node(Node::Cos(a)) * slope(&a),
                Node::Root(a) => slope(&a) / (Sym::int(2) * each),
                Node::Elementary(function, a, b) => {
                    let [by_first, by_second] = function.slopes(a, b, each);
                    let second = if by_second == Sym::ZERO { Sym::ZERO } else { by_second * slope(&b) };
                    by_first * slope(&a) + second
                }
                Node::Function(name, order, a) => Sym::function_of_order(name, order + 1, a) * slope(&a),
            };
            self.known.insert(each, value);
        }
        self.known[&expression]
    }
}

impl Sym {
    /// Returns the partial derivative with respect to `variable`; everything else is constant. A `variable` that is not a symbol counts as an
    /// independent quantity wherever it occurs.
    pub fn diff(self, variable: Sym) -> Sym {
        Derivation::new([(variable, Sym::ONE)]).of(self)
    }

    /// Replaces every pair `(old, new)` simultaneously. An `old` expression is usually a symbol; any other one is found where it occurs literally.
    /// Sines and cosines of new sums are expanded.
    pub fn substitute(self, replacements: &[(Sym, Sym)]) -> Sym {
        substitute_all(&[self], replacements)[0]
    }

    /// Returns the leaves of the expression in order of creation: symbols, cosines, sines, roots and functions. The expression is a rational function of them.
    pub fn leaves_of(self) -> Vec<Sym> {
        Sym::ascending_to_leaves(&[self]).into_iter().filter(|each| each.node().is_leaf()).collect()
    }

    /// Returns the number of distinct subexpressions of all expressions together. It measures the cost of an evaluation.
    pub fn operations_of(expressions: &[Sym]) -> usize {
        Sym::ascending(expressions).len()
    }

    /// Returns the symbols of the expression, sorted by name in natural order (l2 before l10).
    pub fn symbols_of(self) -> Vec<Sym> {
        let mut symbols: Vec<Sym> =
            Sym::ascending(&[self]).into_iter().filter(|each| matches!(each.node(), Node::Symbol(_))).collect();
        symbols.sort_by_cached_key(|each| crate::print::natural_key(&each.to_string()));
        symbols
    }
}

/// Applies [`Sym::substitute`] to several expressions that share subexpressions.
pub fn substitute_all(expressions: &[Sym], replacements: &[(Sym, Sym)]) -> Vec<Sym> {
    // reversed, so that the first of two replacements for one expression applies
    let mut new: FxHashMap<Sym, Sym> = replacements.iter().rev().copied().collect();
    for each in Sym::ascending(expressions) {
        if !new.contains_key(&each) {
            let value = each.node().rebuild(each, |a| new[a]);
            new.insert(each, value);
        }
    }
    expressions.iter().map(|each| new[each]).collect()
}

impl Node {
    /// Returns the operation applied to new operands, with the usual simplifications. `itself` is the old expression of the node.
    pub(crate) fn rebuild(self, itself: Sym, of: impl Fn(&Sym) -> Sym) -> Sym {
        match self {
            Node::Constant(_) | Node::Symbol(_) => itself,
            Node::Sum(a, b) => of(&a) + of(&b),
            Node::Difference(a, b) => of(&a) - of(&b),
            Node::Product(a, b) => of(&a) * of(&b),
            Node::Quotient(a, b) => of(&a) / of(&b),
            Node::Negation(a) => -of(&a),
            Node::Power(a, n) => of(&a).powi(n as i32),
            Node::Cos(a) => unless_same(itself, a, of(&a), |angle| angle.circle().cos),
            Node::Sin(a) => unless_same(itself, a, of(&a), |angle| angle.circle().sin),
            Node::Root(a) => unless_same(itself, a, of(&a), Sym::sqrt),
            Node::Elementary(function, a, b) => of(&a).elementary(function, of(&b)),
            Node::Function(name, order, a) => Sym::function_of_order(name, order, of(&a)),
        }
    }
}

fn unless_same(itself: Sym, old: Sym, new: Sym, make: impl Fn(Sym) -> Sym) -> Sym {
    if old == new { itself } else { make(new) }
}
