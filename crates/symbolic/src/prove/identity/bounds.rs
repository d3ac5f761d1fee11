//! Bounds of degrees and coefficients, computed operation by operation.

use super::denominators::{Denominator, Denominators};
use super::program::{Part, Program};
use crate::graph::Node;
use dashu_int::UBig;
use dashu_int::ops::{BitTest, UnsignedAbs};
use field::Rational;
use rustc_hash::{FxHashMap, FxHashSet};

/// Bounds of the numerator of an expression over its common denominator, as a polynomial in the random numbers of the test.
pub(super) struct Bounds {
    pub degree: f64,
    /// The binary logarithm of a bound for the sum of the absolute values of the coefficients.
    pub bits: f64,
    /// Bounds for the differences of distinct arguments of functions; `None` if there are fewer than two arguments, so that none can be confused.
    pub mistaken: Option<Bounded>,
}

/// Bounds that are valid for each of `pairs` differences.
pub(super) struct Bounded {
    pub degree: f64,
    pub bits: f64,
    pub pairs: f64,
}

/// A quotient of polynomials in symbols, cosines and sines, with integer coefficients.
#[derive(Clone, Copy)]
struct Quotient {
    above: Polynomial,
    below: Denominator,
}

#[derive(Clone, Copy)]
pub(super) struct Polynomial {
    pub degree: f64,
    pub bits: f64,
}

impl Polynomial {
    pub fn times(self, other: Self) -> Self {
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
    let (mut all, one) = Denominators::new();
    let generator = Quotient { above: Polynomial { degree: 1.0, bits: 0.0 }, below: one };
    // denominators of rational constants, and expressions used as divisors
    let mut numbers: FxHashMap<UBig, Denominator> = FxHashMap::default();
    let mut divisors: FxHashMap<usize, Denominator> = FxHashMap::default();
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
                match is.as_constant().and_then(Rational::to_big) {
                    Some(big) if big.denominator().is_one() => {
                        Quotient { above: bits(&big.numerator().unsigned_abs()), below: one }
                    }
                    Some(big) => {
                        let below = big.denominator();
                        let divisor = || all.divisor(bits(below));
                        let below = *numbers.entry(below.clone()).or_insert_with(divisor);
                        Quotient { above: bits(&big.numerator().unsigned_abs()), below }
                    }
                    None => Quotient { above: constant(f64::INFINITY), below: one },
                }
            }
            Node::Symbol(_) | Node::Elementary(..) | Node::Function(..) => generator,
            // a root has at most the degree and the coefficients of its square
            Node::Root(_) => {
                let Quotient { above, below } = of(a);
                Quotient { above: above.times(generator.above), below }
            }
            Node::Cos(_) | Node::Sin(_) => {
                angles.insert(a);
                generator
            }
            Node::Sum(..) | Node::Difference(..) => {
                let [a, b] = [of(a), of(b)];
                let mut brought = |each: Quotient, other: Quotient| {
                    let missing = all.excess(other.below, each.below);
                    each.above.times(all.bound(missing))
                };
                Quotient { above: brought(a, b).plus(brought(b, a)), below: all.multiple(a.below, b.below) }
            }
            Node::Product(..) => {
                let [a, b] = [of(a), of(b)];
                Quotient { above: a.above.times(b.above), below: all.product(a.below, b.below) }
            }
            Node::Quotient(..) => {
                let divisor = *divisors.entry(b).or_insert_with(|| all.divisor(known[b].above));
                let [a, b] = [of(a), of(b)];
                // common factors of the two denominators cancel
                let [above, below] = [all.excess(b.below, a.below), all.excess(a.below, b.below)];
                Quotient { above: a.above.times(all.bound(above)), below: all.product(below, divisor) }
            }
            Node::Negation(_) => of(a),
            Node::Power(_, n) => Quotient { above: of(a).above.power(n), below: all.power(of(a).below, n) },
        };
        known.push(value);
    }
    let sizes = |place: &usize| {
        let Quotient { above, below } = known[*place];
        [above, all.bound(below)]
    };
    let most = |places: &mut dyn Iterator<Item = &usize>, size: fn(Polynomial) -> f64| {
        places.flat_map(sizes).map(size).fold(1.0, f64::max)
    };
    let results = || program.results.iter();
    let (degree, bits) = (most(&mut results(), |part| part.degree), most(&mut results(), |part| part.bits));
    // cosines are (1 - t^2)/(1 + t^2) with random t: each angle contributes (1 + t^2) to a power of at most the degree
    let by_angles = |degree: f64, bits: f64| {
        let angles = angles.len() as f64 + 1.0;
        (2.0 * degree * angles, bits + degree * angles)
    };
    arguments.extend(&angles);
    let pairs = arguments.len() as f64 * (arguments.len() as f64 - 1.0) / 2.0;
    // the difference of two arguments, over their common denominator
    let (of_pair, bits_of_pair) = by_angles(
        2.0 * most(&mut arguments.iter(), |part| part.degree),
        2.0 * most(&mut arguments.iter(), |part| part.bits) + 1.0,
    );
    let mistaken = (pairs > 0.0).then_some(Bounded { degree: of_pair, bits: bits_of_pair, pairs });
    let (degree, bits) = by_angles(degree, bits);
    Bounds { degree, bits, mistaken }
}
