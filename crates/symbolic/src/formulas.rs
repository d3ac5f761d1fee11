//! Expressions as a list of operations, for evaluation with exact fractions or interval enclosures.
//!
//! Enclosures are large and not `Copy`, hence a law cannot be evaluated with them directly. The law is evaluated once over [`Sym`], and the
//! recorded operations are evaluated here.

use crate::graph::Node;
use crate::{Sym, Unbound};
use algebra::real::Ordered;
use field::Rational;
use rustc_hash::FxHashMap;

#[derive(Clone, Copy, Debug)]
enum Step {
    Constant(Rational),
    Unknown(usize),
    Sum(usize, usize),
    Difference(usize, usize),
    Product(usize, usize),
    Quotient(usize, usize),
    Negation(usize),
    Power(usize, u32),
    Root(usize),
}

/// Expressions in some unknowns, as a list of operations. Unlike [`Sym`], the list can be sent to other threads.
#[derive(Clone, Debug)]
pub struct Formulas {
    steps: Vec<Step>,
    results: Vec<usize>,
}

impl Formulas {
    /// Records expressions that consist of the unknowns, constants, rational operations and square roots.
    ///
    /// # Errors
    /// [`Unbound`] contains a subexpression of another kind.
    pub fn of(expressions: &[Sym], unknowns: &[Sym]) -> Result<Self, Unbound> {
        let mut places: FxHashMap<Sym, usize> = FxHashMap::default();
        let mut steps = Vec::new();
        for each in Sym::ascending(expressions) {
            let place = |a: Sym| places.get(&a).copied().ok_or_else(|| Unbound(a.text_of_leaf()));
            let unknown = unknowns.iter().position(|unknown| *unknown == each);
            let step = match (unknown, each.node()) {
                (Some(unknown), _) => Step::Unknown(unknown),
                (None, Node::Constant(_)) => {
                    Step::Constant(each.as_constant().ok_or_else(|| Unbound(each.text_of_leaf()))?)
                }
                (None, Node::Sum(a, b)) => Step::Sum(place(a)?, place(b)?),
                (None, Node::Difference(a, b)) => Step::Difference(place(a)?, place(b)?),
                (None, Node::Product(a, b)) => Step::Product(place(a)?, place(b)?),
                (None, Node::Quotient(a, b)) => Step::Quotient(place(a)?, place(b)?),
                (None, Node::Negation(a)) => Step::Negation(place(a)?),
                (None, Node::Power(a, n)) => Step::Power(place(a)?, n),
                (None, Node::Root(a)) => Step::Root(place(a)?),
                (None, _) => return Err(Unbound(each.text_of_leaf())),
            };
            places.insert(each, steps.len());
            steps.push(step);
        }
        let place = |a: &Sym| places.get(a).copied().ok_or_else(|| Unbound(a.text_of_leaf()));
        let results = expressions.iter().map(place).collect::<Result<_, _>>()?;
        Ok(Formulas { steps, results })
    }

    /// Evaluates the expressions; `one` is any element of the field, and determines its precision. Returns `None` if a value may be undefined, or if a root is
    /// not in the field.
    pub fn values<R: Ordered>(&self, unknowns: &[R], one: &R) -> Option<Vec<R>> {
        let mut values: Vec<R> = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            let value = match *step {
                Step::Constant(value) => one.fraction(value)?,
                Step::Unknown(k) => unknowns.get(k)?.clone(),
                Step::Sum(a, b) => values[a].plus(&values[b]),
                Step::Difference(a, b) => values[a].minus(&values[b]),
                Step::Product(a, b) => values[a].times(&values[b]),
                Step::Quotient(a, b) => values[a].over(&values[b])?,
                Step::Negation(a) => one.integer(0).minus(&values[a]),
                Step::Power(a, n) => (1..n).fold(values[a].clone(), |power, _| power.times(&values[a])),
                Step::Root(a) => values[a].root()?,
            };
            values.push(value);
        }
        Some(self.results.iter().map(|place| values[*place].clone()).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbols;
    use algebra::real::Enclosure;
    use field::{Analytic, Scalar};

    #[test]
    fn fractions_and_enclosures_agree_with_the_expression() {
        let [x, y] = symbols(["x", "y"]);
        let expression = (x * y - Sym::int(3)).powi(2) / (x - y) - Sym::ratio(9, 4).sqrt();
        let formulas = Formulas::of(&[expression, x], &[x, y]).unwrap();
        let [a, b] = [Rational::new(2, 3), Rational::new(-7, 5)];
        let exact = expression
            .evaluate(&|name| match name {
                "x" => Some(a),
                "y" => Some(b),
                _ => Some(Rational::new(3, 2)),
            })
            .unwrap();
        assert_eq!(formulas.values(&[a, b], &a), Some(vec![exact, a]));
        let one = Enclosure::integer(1, 100);
        let enclosed = [a, b].map(|value| one.fraction(value).unwrap());
        let value = &formulas.values(&enclosed, &one).unwrap()[0];
        assert!(!value.is_apart_from(&one.fraction(exact).unwrap()) && value.is_within(80));
    }

    #[test]
    fn what_has_no_value_is_named_or_none() {
        let [x, y] = symbols(["x", "y"]);
        assert_eq!(Formulas::of(&[x * y.circle().cos], &[x, y]).unwrap_err(), Unbound("cos y".into()));
        let quotient = Formulas::of(&[x / y], &[x, y]).unwrap();
        assert_eq!(quotient.values(&[Rational::int(1), Rational::int(0)], &Rational::int(1)), None);
        let root = Formulas::of(&[x.sqrt()], &[x]).unwrap();
        assert_eq!(root.values(&[Rational::int(2)], &Rational::int(1)), None);
        assert_eq!(root.values(&[Rational::new(9, 4)], &Rational::int(1)), Some(vec![Rational::new(3, 2)]));
    }
}
