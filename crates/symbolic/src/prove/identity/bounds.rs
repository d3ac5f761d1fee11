//! Bounds of degrees and coefficients, operation by operation.

use super::program::{Part, Program};
use crate::graph::Node;
use dashu_int::UBig;
use dashu_int::ops::{BitTest, UnsignedAbs};
use field::Rational;
use rustc_hash::FxHashSet;

/// Bounds of the numerator over the common denominator, in the random numbers.
pub(super) struct Bounds {
    pub degree: f64,
    /// The logarithm of the sum of the sizes of its coefficients.
    pub bits: f64,
    /// Differences of two arguments that are not the same; `None` where no two may be taken for one.
    pub mistaken: Option<Bounded>,
}

/// Bounds of any of so many pairs.
pub(super) struct Bounded {
    pub degree: f64,
    pub bits: f64,
    pub pairs: f64,
}

/// A quotient of polynomials in symbols, cosines and sines, with integer coefficients.
#[derive(Clone, Copy)]
struct Quotient {
    above: Polynomial,
    below: Polynomial,
}

#[derive(Clone, Copy)]
struct Polynomial {
    degree: f64,
    bits: f64,
}

impl Polynomial {
    fn times(self, other: Self) -> Self {
        Polynomial { degree: self.degree + other.degree, bits: self.bits + other.bits }
    }

    fn plus(self, other: Self) -> Self {
        Polynomial { degree: self.degree.max(other.degree), bits: self.bits.max(other.bits) + 1.0 }
    }

    fn power(self, n: u32) -> Self {
        Polynomial { degree: self.degree * f64::from(n), bits: self.bits * f64::from(n) }
    }
}

pub(super) fn bounds(program: &Program) -> Bounds {
    let mut known: Vec<Quotient> = Vec::with_capacity(program.parts.len());
    let (mut angles, mut arguments) = (FxHashSet::default(), FxHashSet::default());
    let constant = |bits: f64| Polynomial { degree: 0.0, bits };
    let generator = Quotient { above: Polynomial { degree: 1.0, bits: 0.0 }, below: constant(0.0) };
    for &Part { is, node, arguments: [a, b] } in &program.parts {
        let of = |place: usize| known[place];
        match node {
            Node::Elementary(..) => arguments.extend([a, b]),
            Node::Root(_) | Node::Function(..) => arguments.extend([a]),
            _ => {}
        }
        let value = match node {
            Node::Constant(_) => {
                let bits = |n: &UBig| constant(n.bit_len() as f64);
                let big = is.as_constant().and_then(Rational::to_big);
                let sizes = big.map(|big| (bits(&big.numerator().unsigned_abs()), bits(big.denominator())));
                let (above, below) = sizes.unwrap_or((constant(f64::INFINITY), constant(0.0)));
                Quotient { above, below }
            }
            Node::Symbol(_) | Node::Elementary(..) | Node::Function(..) => generator,
            // no larger than its square
            Node::Root(_) => {
                let Quotient { above, below } = of(a);
                Quotient { above: above.times(generator.above), below }
            }
            Node::Cos(_) | Node::Sin(_) => {
                angles.insert(a);
                generator
            }
            Node::Sum(..) | Node::Difference(..) => {
                let (a, b) = (of(a), of(b));
                Quotient { above: a.above.times(b.below).plus(b.above.times(a.below)), below: a.below.times(b.below) }
            }
            Node::Product(..) => {
                Quotient { above: of(a).above.times(of(b).above), below: of(a).below.times(of(b).below) }
            }
            Node::Quotient(..) => {
                Quotient { above: of(a).above.times(of(b).below), below: of(a).below.times(of(b).above) }
            }
            Node::Negation(_) => of(a),
            Node::Power(_, n) => Quotient { above: of(a).above.power(n), below: of(a).below.power(n) },
        };
        known.push(value);
    }
    let all = || program.results.iter().map(|&place| known[place]);
    let degree = all().map(|each| each.above.degree.max(each.below.degree)).fold(1.0, f64::max);
    let bits = all().map(|each| each.above.bits.max(each.below.bits)).fold(1.0, f64::max);
    // a cosine is (1 - t^2)/(1 + t^2): each angle brings its denominator to a power of at most the degree
    let by_angles = |degree: f64, bits: f64| {
        let angles = angles.len() as f64 + 1.0;
        (2.0 * degree * angles, bits + degree * angles)
    };
    arguments.extend(&angles);
    let most = |size: fn(Polynomial) -> f64| {
        let sizes = arguments.iter().map(|&argument| known[argument]);
        sizes.map(|each| size(each.above).max(size(each.below))).fold(1.0, f64::max)
    };
    let pairs = arguments.len() as f64 * (arguments.len() as f64 - 1.0) / 2.0;
    // one argument over its denominator less another
    let (of_pair, bits_of_pair) = by_angles(2.0 * most(|part| part.degree), 2.0 * most(|part| part.bits) + 1.0);
    let mistaken = (pairs > 0.0).then_some(Bounded { degree: of_pair, bits: bits_of_pair, pairs });
    let (degree, bits) = by_angles(degree, bits);
    Bounds { degree, bits, mistaken }
}
