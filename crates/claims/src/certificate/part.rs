//! The pieces of a part of a certificate: relations, steps from equalities to values, and proofs of the conclusions.

use super::Part;
use super::program::Recorder;
use crate::{Combination, Condition, Point};
use serde::Serialize;
use symbolic::{Hypotheses, Node, Sym};

/// A relation between two entries of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Relation {
    /// `=`, `!=`, `>` or `>=`; `rate` says that the rate of the left side is the right side.
    pub is: &'static str,
    pub left: usize,
    pub right: usize,
}

/// A consequence of equalities of the list `given`, by their places.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "step", rename_all = "snake_case")]
pub enum Step {
    /// The equalities are linear in the letters, and these are their values.
    Solve { letters: Vec<usize>, values: Vec<usize>, by: Vec<usize> },
    /// The equality is one between this power of a letter and terms with lower powers of it.
    Rewrite { letter: usize, power: u32, by: usize },
}

/// The proof of the conclusions of a part, or of their failure.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "by", rename_all = "snake_case")]
pub enum PartProof {
    /// The difference of the sides of each conclusion vanishes after the steps.
    Identity,
    /// One combination for each conclusion.
    Combination { combinations: Vec<Combined> },
    /// All terms above and below have one sign where these letters are positive.
    Signs { positive: Vec<usize> },
    /// The signs of squares and of expressions given as positive show each conclusion as it is written, without the
    /// steps.
    WrittenSigns,
    /// A sum of products of given relations and of the opposite of the one conclusion vanishes, although one of these products would be
    /// positive.
    Products { products: Vec<Product> },
    /// All that is given and the one conclusion hold one unknown, a letter or an angle: real roots of polynomials show the conclusion.
    RealRoots,
    /// At this point everything given holds and a conclusion does not.
    Counterexample { point: Vec<(usize, usize)> },
    /// At this point everything holds.
    Example { point: Vec<(usize, usize)> },
    /// At this point of the other letters no value of the unknown but zero satisfies the conclusions.
    NoRoot { unknown: usize, point: Vec<(usize, usize)> },
    /// This divisor of a conclusion vanishes identically after the steps.
    Undefined { divisor: usize },
    /// A steady motion is stable in the first approximation where, and only where, an expression is positive.
    Stability(Box<Stability>),
    /// A steady motion is stable where an expression is positive, since the energy has a minimum there, and unstable where it is negative.
    Minimum(Box<Minimum>),
    /// After the steps all sides are numbers, and enclosures of these show every conclusion.
    Enclosure,
    /// After the steps all sides are numbers, and enclosures of these show that a conclusion fails.
    Excluded,
}

/// The equations about a steady motion and their characteristic polynomial, the theorem on its roots, and the printed condition beside it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Stability {
    pub theorem: &'static str,
    /// Expressions that vanish along every motion, as many as coordinates.
    pub equations: Vec<usize>,
    pub coordinates: Vec<usize>,
    pub speeds: Vec<usize>,
    pub accelerations: Vec<usize>,
    /// The coordinates that are constant, by their places in the list; the others have constant speeds.
    pub resting: Vec<usize>,
    /// The letter of the roots.
    pub root: usize,
    /// The determinant times this is the polynomial with these coefficients by rising powers, times the root to the power `neutral`.
    pub scale: usize,
    pub coefficients: Vec<usize>,
    pub neutral: u32,
    /// The expression that is said to be positive.
    pub printed: usize,
    /// The ratio of the condition that the signs of terms leave open to the printed one, and the even power of a relation of `given`
    /// by which it was divided.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<(usize, Option<(usize, i32)>)>,
    /// A point at which the printed condition and the theorem differ.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point: Option<Vec<(usize, usize)>>,
}

/// The equations about a steady motion on which all coordinates rest, M q'' + K q = 0 with symmetric matrices, and the proofs of the signs of both
/// forms.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Minimum {
    pub theorem: &'static str,
    /// Expressions that vanish along every motion, as many as coordinates.
    pub equations: Vec<usize>,
    pub coordinates: Vec<usize>,
    pub speeds: Vec<usize>,
    pub accelerations: Vec<usize>,
    /// The expression that is said to be positive.
    pub printed: usize,
    /// Leading principal minors of M, and of K.
    pub inertia: Vec<usize>,
    pub leading: Vec<usize>,
    /// All principal minors of K, by the binary numbers of their rows.
    pub principal: Vec<usize>,
    /// Those of M are positive; those of K are where the printed expression is; that is not negative where no principal minor of K is.
    pub implied: Vec<Part>,
}

/// For a conclusion f = 0: m f is the sum of cofactors times equalities of `given`, where m is the product of relations that exclude
/// zero. For f != 0 the factor d: d f is m plus that sum.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Combined {
    /// Places in `given`.
    pub multiplier: Vec<usize>,
    /// Places in `given`, and entries of the program.
    pub cofactors: Vec<(usize, usize)>,
    pub factor: Option<usize>,
}

/// A positive number times factors that are not negative.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Product {
    /// The entry of the number.
    pub number: usize,
    /// Differences of relations of `given`, by their places; the place behind the last one is the opposite of the conclusion. A relation that
    /// excludes zero stands there twice.
    pub of: Vec<usize>,
    /// Entries that are roots.
    pub roots: Vec<usize>,
    /// Entries whose squares are factors.
    pub squares: Vec<usize>,
}

/// Relations with the program that they are about.
#[derive(Default)]
pub struct Relations {
    pub recorder: Recorder,
}

impl Relations {
    /// The relation of a condition.
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

    /// Relations of several conditions.
    pub fn all(&mut self, conditions: &[Condition]) -> Vec<Relation> {
        conditions.iter().map(|condition| self.of(*condition)).collect()
    }

    /// Adds the statements of hypotheses to the given relations, and the steps that they allow.
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

    /// A certificate of one conclusion.
    pub fn combined(&mut self, combination: &Combination) -> Combined {
        let cofactors = &combination.cofactors;
        Combined {
            multiplier: combination.multiplier.clone(),
            cofactors: cofactors.iter().map(|&(place, cofactor)| (place, self.recorder.place(cofactor))).collect(),
            factor: combination.factor.map(|factor| self.recorder.place(factor)),
        }
    }

    /// The values of a point, of those among its names that stand in the expressions.
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

    /// The values of a point by its letters, angles and functions; a checker computes roots itself.
    pub fn point(&mut self, point: &[(Sym, Sym)]) -> Vec<(usize, usize)> {
        let is_value =
            |leaf: Sym| matches!(leaf.node(), Node::Symbol(_) | Node::Cos(_) | Node::Sin(_) | Node::Function(..));
        let kept = point.iter().filter(|(leaf, _)| is_value(*leaf));
        kept.map(|&(leaf, value)| (self.recorder.place(leaf), self.recorder.place(value))).collect()
    }
}

/// The letter whose power is rewritten by a statement with this left side: the last one of a sum of squares.
fn power(left: Sym) -> Option<(Sym, u32)> {
    match left.node() {
        Node::Symbol(_) => Some((left, 1)),
        Node::Power(letter, power) if letter.symbol_name().is_some() => Some((letter, power)),
        Node::Sum(_, last) => power(last).filter(|(_, power)| *power > 1),
        _ => None,
    }
}

/// The name in points of a letter, an angle's coordinate or a function.
fn name(leaf: Sym) -> String {
    match leaf.node() {
        Node::Cos(angle) if angle.symbol_name().is_some() => format!("cos {angle}"),
        Node::Sin(angle) if angle.symbol_name().is_some() => format!("sin {angle}"),
        _ => leaf.to_string(),
    }
}
