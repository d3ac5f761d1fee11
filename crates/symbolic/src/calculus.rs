//! Exact derivative, substitution, and the symbols of an expression.

use crate::Sym;
use crate::graph::Node;
use field::{Analytic, Scalar};
use rustc_hash::FxHashMap;

/// The derivative of expressions whose symbols change at given rates, forward through the graph: d/dt along a motion where the rates
/// are velocities, d/dx where x alone has the rate one. (A derivation in the sense of algebra: linear, with the product rule.) It
/// keeps every rate that it has found: parts shared by expressions cost once.
pub struct Derivation {
    known: FxHashMap<Sym, Sym>,
}

impl Derivation {
    /// A derivation in which each of these expressions, usually symbols, changes at a rate; all other symbols are constant. An
    /// expression that is no symbol is taken as an independent quantity wherever it occurs.
    pub fn new(rates: impl IntoIterator<Item = (Sym, Sym)>) -> Self {
        Derivation { known: rates.into_iter().collect() }
    }

    /// The rate of an expression.
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
    /// The partial derivative with respect to `variable`, with everything else constant. `variable` is usually a
    /// symbol; any other expression is taken as an independent quantity wherever it occurs.
    pub fn diff(self, variable: Sym) -> Sym {
        Derivation::new([(variable, Sym::ONE)]).of(self)
    }

    /// The expression with every `(old, new)` replaced, all at once. Old ones are usually symbols, but any expression
    /// is found where it occurs as written. Circle points of new sums are expanded again.
    pub fn substitute(self, replacements: &[(Sym, Sym)]) -> Sym {
        substitute_all(&[self], replacements)[0]
    }

    /// The leaves from which rational operations make the expression: symbols, cosines, sines, roots, functions, in the
    /// order of making.
    pub fn leaves_of(self) -> Vec<Sym> {
        Sym::ascending_to_leaves(&[self]).into_iter().filter(|each| each.node().is_leaf()).collect()
    }

    /// The number of different parts of expressions together: the cost of evaluating or walking them.
    pub fn operations_of(expressions: &[Sym]) -> usize {
        Sym::ascending(expressions).len()
    }

    /// The symbols in the expression, by name in natural order (l2 before l10).
    pub fn symbols_of(self) -> Vec<Sym> {
        let mut symbols: Vec<Sym> =
            Sym::ascending(&[self]).into_iter().filter(|each| matches!(each.node(), Node::Symbol(_))).collect();
        symbols.sort_by_cached_key(|each| crate::print::natural_key(&each.to_string()));
        symbols
    }
}

/// [`Sym::substitute`] in several expressions that share parts.
pub fn substitute_all(expressions: &[Sym], replacements: &[(Sym, Sym)]) -> Vec<Sym> {
    // the first of two replacements for one expression holds
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
    /// The node `itself` over new children, with the operations' usual folding.
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
