//! The elements of a part of a certificate: relations, steps from equalities to values, and proofs.

use super::Part;
use super::program::Recorder;
use crate::{Combination, Condition, Point};
use serde::Serialize;
use symbolic::{Hypotheses, Node, Sym};

/// A relation between two entries of a program, given by their indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Relation {
    /// `=`, `!=`, `>`, `>=`, or `rate`: the time derivative of the left side is the right side.
    pub is: &'static str,
    /// The entry of the left side; `right` is that of the right side.
    pub left: usize,
    pub right: usize,
}

/// A consequence of equalities; `by` contains their indices in the list `given`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "step", rename_all = "snake_case")]
pub enum Step {
    /// The solution of equalities that are linear in these letters.
    Solve { letters: Vec<usize>, values: Vec<usize>, by: Vec<usize> },
    /// The equality expresses this power of a letter by terms with lower powers of the letter.
    Rewrite { letter: usize, power: u32, by: usize },
}

/// The proof that the conclusions of a part hold, or that a conclusion fails.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "by", rename_all = "snake_case")]
pub enum PartProof {
    /// The difference of the sides of each conclusion vanishes after the steps.
    Identity,
    /// A linear combination of the premises for each conclusion.
    Combination { combinations: Vec<Combined> },
    /// All terms of the numerator, and all terms of the denominator, have one sign where these letters are positive.
    Signs { positive: Vec<usize> },
    /// The signs of squares and of expressions that are positive by a premise show each conclusion in its written form, without
    /// the steps.
    WrittenSigns,
    /// Proof by contradiction: a sum of products of premises and of the negated conclusion vanishes identically, although at least one product is
    /// positive and none is negative.
    Products { products: Vec<Product> },
    /// The premises and the one conclusion contain a single unknown, a letter or an angle; real roots of polynomials show the conclusion.
    RealRoots,
    /// An exact point at which all premises hold and a conclusion fails.
    Counterexample { point: Vec<(usize, usize)> },
    /// An exact point at which all premises and conclusions hold.
    Example { point: Vec<(usize, usize)> },
    /// At this point of the other letters no value of the unknown except zero satisfies the conclusions.
    NoRoot { unknown: usize, point: Vec<(usize, usize)> },
    /// This divisor of a conclusion vanishes identically after the steps.
    Undefined { divisor: usize },
    /// A steady motion is stable in the first approximation if and only if an expression is positive.
    Stability(Box<Stability>),
    /// A steady motion is stable where an expression is positive, since the energy has a minimum there, and unstable where the expression is negative.
    Minimum(Box<Minimum>),
    /// After the steps all sides are numbers, and interval enclosures of them show every conclusion.
    Enclosure,
    /// After the steps all sides are numbers, and interval enclosures of them show that a conclusion fails.
    Excluded,
}

/// A proof about linear stability: the equations about a steady motion, their characteristic polynomial, the theorem on its roots, the printed condition.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Stability {
    /// The citation of the theorem.
    pub theorem: &'static str,
    /// Expressions that vanish along every motion, one for each coordinate.
    pub equations: Vec<usize>,
    /// The entries of the coordinates, of their rates (`speeds`) and of their second rates (`accelerations`), all in one order.
    pub coordinates: Vec<usize>,
    pub speeds: Vec<usize>,
    pub accelerations: Vec<usize>,
    /// The indices in `coordinates` of those that are constant; the others have constant speeds.
    pub resting: Vec<usize>,
    /// The letter of the characteristic polynomial, whose roots are the eigenvalues.
    pub root: usize,
    /// `scale` times the determinant is the polynomial with `coefficients`, by increasing powers, times `root` to the power `neutral`.
    pub scale: usize,
    pub coefficients: Vec<usize>,
    pub neutral: u32,
    /// The expression that the printed condition states to be positive.
    pub printed: usize,
    /// The ratio of the theorem's condition, reduced by the signs of its terms, to the printed condition; with it the relation of `given` (by its
    /// index) and the even power of it by which the ratio was divided, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<(usize, Option<(usize, i32)>)>,
    /// A point at which the printed condition and the theorem disagree.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point: Option<Vec<(usize, usize)>>,
}

/// A proof by the minimum of the potential energy at an equilibrium, M q'' + K q = 0 with symmetric matrices: the equations, and the proofs of the
/// signs of both quadratic forms.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Minimum {
    /// The citation of the theorem.
    pub theorem: &'static str,
    /// Expressions that vanish along every motion, one for each coordinate.
    pub equations: Vec<usize>,
    /// The entries of the coordinates, of their rates (`speeds`) and of their second rates (`accelerations`), all in one order.
    pub coordinates: Vec<usize>,
    pub speeds: Vec<usize>,
    pub accelerations: Vec<usize>,
    /// The expression that the printed condition states to be positive.
    pub printed: usize,
    /// The leading principal minors of M (`inertia`) and of K (`leading`).
    pub inertia: Vec<usize>,
    pub leading: Vec<usize>,
    /// All principal minors of K; bit i of the index of a minor, counted from 1, states whether it contains row i.
    pub principal: Vec<usize>,
    /// Proofs that the minors of M are positive, that the leading minors of K are positive where `printed` is positive, and that `printed` is not
    /// negative where no principal minor of K is negative.
    pub implied: Vec<Part>,
}

/// A combination of premises. For a conclusion f = 0: m f = Σ c_k g_k, with equalities g_k = 0 of `given`, cofactors c_k, and the product m of
/// expressions that differ from zero. For a conclusion f ≠ 0: d f = m + Σ c_k g_k, with the factor d.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Combined {
    /// The indices in `given` of the relations whose expressions are the factors of m.
    pub multiplier: Vec<usize>,
    /// Pairs (index of g_k in `given`, entry of c_k in the program).
    pub cofactors: Vec<(usize, usize)>,
    /// The entry of d; `None` for a conclusion f = 0.
    pub factor: Option<usize>,
}

/// A product of a positive number and factors that are not negative.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Product {
    /// The entry of the positive number.
    pub number: usize,
    /// Factors that are differences of the sides of relations, by their indices in `given`; the index after the last one is the negated
    /// conclusion. The difference of a relation `!=` occurs twice, as a square.
    pub of: Vec<usize>,
    /// Entries that are square roots.
    pub roots: Vec<usize>,
    /// Entries whose squares are factors.
    pub squares: Vec<usize>,
}

/// Translates conditions into relations between entries of a program, which it records.
#[derive(Default)]
pub struct Relations {
    pub recorder: Recorder,
}

impl Relations {
    /// The relation that a condition states.
    pub fn of(&mut self, condition: Condition) -> Relation {
        let (is, left, right) = match condition {
            Condition::Zero(e) => ("=", e, Sym::ZERO),
            Condition::Equal(a, b) => ("=", a, b),
            Condition::NonZero(e) => ("!=", e, Sym::ZERO),
            Condition::Positive(e) => (">", e, Sym::ZERO),
            Condition::NotNegative(e) => (">=", e, Sym::ZERO),
        };
        Relation { is, left: self.recorder.place(left), right: self.recorder.place(right) }
    }

    /// The relations that several conditions state.
    pub fn all(&mut self, conditions: &[Condition]) -> Vec<Relation> {
        conditions.iter().map(|condition| self.of(*condition)).collect()
    }

    /// Adds the equalities of hypotheses to `given`, and the steps that they allow to `steps`.
    pub fn rules(&mut self, hypotheses: &Hypotheses, given: &mut Vec<Relation>, steps: &mut Vec<Step>) {
        let mut known: Vec<(Sym, Sym)> = Vec::new();
        for &(left, right) in hypotheses.statements() {
            let by = given.len();
            given.push(self.of(Condition::Equal(left, right)));
            match power(left) {
                Some((letter, 1)) => {
                    let value = right.substitute(&known);
                    known.push((letter, value));
                    let (letters, values) = (vec![self.recorder.place(letter)], vec![self.recorder.place(value)]);
                    steps.push(Step::Solve { letters, values, by: vec![by] });
                }
                Some((letter, power)) => {
                    steps.push(Step::Rewrite { letter: self.recorder.place(letter), power, by });
                }
                None => {}
            }
        }
    }

    /// A combination with its expressions replaced by entries of the program.
    pub fn combined(&mut self, combination: &Combination) -> Combined {
        let cofactors = &combination.cofactors;
        Combined {
            multiplier: combination.multiplier.clone(),
            cofactors: cofactors.iter().map(|&(place, cofactor)| (place, self.recorder.place(cofactor))).collect(),
            factor: combination.factor.map(|factor| self.recorder.place(factor)),
        }
    }

    /// Pairs (entry of a letter, entry of its value) of a point, for those of its names that occur in the expressions.
    pub fn named_point(&mut self, point: &Point, expressions: &[Sym]) -> Vec<(usize, usize)> {
        let leaves: Vec<(String, Sym)> =
            Sym::ascending(expressions).into_iter().filter(|e| e.node().is_leaf()).map(|e| (name(e), e)).collect();
        let mut values = Vec::new();
        for (known, value) in point.values() {
            if let Some((_, leaf)) = leaves.iter().find(|(name, _)| name == known) {
                values.push((self.recorder.place(*leaf), self.recorder.place(Sym::constant(*value))));
            }
        }
        values
    }

    /// Pairs (entry, entry of its value) for letters, sines, cosines and functions; a checker computes square roots itself.
    pub fn point(&mut self, point: &[(Sym, Sym)]) -> Vec<(usize, usize)> {
        let is_value =
            |leaf: Sym| matches!(leaf.node(), Node::Symbol(_) | Node::Cos(_) | Node::Sin(_) | Node::Function(..));
        let kept = point.iter().filter(|(leaf, _)| is_value(*leaf));
        kept.map(|&(leaf, value)| (self.recorder.place(leaf), self.recorder.place(value))).collect()
    }
}

/// The letter, and its power, that an equality with this left side replaces; of a sum of squares the last one.
fn power(left: Sym) -> Option<(Sym, u32)> {
    match left.node() {
        Node::Symbol(_) => Some((left, 1)),
        Node::Power(letter, power) if letter.symbol_name().is_some() => Some((letter, power)),
        Node::Sum(_, last) => power(last).filter(|(_, power)| *power > 1),
        _ => None,
    }
}

/// The name that a point uses for a letter, a cosine or sine of an angle, or a function.
fn name(leaf: Sym) -> String {
    match leaf.node() {
        Node::Cos(angle) if angle.symbol_name().is_some() => format!("cos {angle}"),
        Node::Sin(angle) if angle.symbol_name().is_some() => format!("sin {angle}"),
        _ => leaf.to_string(),
    }
}
