//! Sines, cosines and square roots, expressed through few independent generators so that identities between them are decidable.

use crate::Sym;
use crate::graph::Node;
use dashu_int::UBig;
use dashu_int::ops::UnsignedAbs;
use field::{Analytic, Circle, Elementary, Rational, Scalar};
use num_traits::{One, Zero};

/// The largest multiple of an angle whose sine and cosine are expanded by the addition theorems.
pub const HIGHEST_MULTIPLE: i64 = 32;

/// Radicands are factorised by trial division up to this number.
const HIGHEST_TRIAL: u64 = 1 << 16;

impl Analytic for Sym {
    /// Returns (cos, sin) of an angle in radians. For an integer combination of terms, the addition theorems give polynomials in the sines and
    /// cosines of the single terms. A term with a fraction, such as x/3, counts as a single term x/3.
    fn circle(self) -> Circle<Self> {
        circle_in_steps(self, |_, parts| parts)
    }

    /// Returns the non-negative square root. The root of a rational number becomes a rational multiple of roots of distinct primes, a canonical form:
    /// sqrt(1/2) = sqrt(2)/2. The root of a negative number is undefined.
    fn sqrt(self) -> Self {
        match self.as_constant() {
            Some(value) => root_of_rational(value),
            None => Sym::from_node(Node::Root(self)),
        }
    }

    /// Returns an elementary function of `self`; `other` is the second argument of atan2. Only exp(0) = 1, ln(1) = 0, tanh(0) = 0 and atan2(0, b) = 0
    /// for a positive number b are simplified.
    fn elementary(self, function: Elementary, other: Self) -> Self {
        let other = if function.arguments() == 1 { self } else { other };
        if self == Sym::UNDEFINED || other == Sym::UNDEFINED {
            return Sym::UNDEFINED;
        }
        let is_positive = |number: Sym| number.as_constant().and_then(Rational::sign) == Some(1);
        match function {
            Elementary::Exp if self == Sym::ZERO => Sym::ONE,
            Elementary::Ln if self == Sym::ONE => Sym::ZERO,
            Elementary::Tanh if self == Sym::ZERO => Sym::ZERO,
            Elementary::Atan2 if self == Sym::ZERO && is_positive(other) => Sym::ZERO,
            _ => Sym::from_node(Node::Elementary(function, self, other)),
        }
    }
}

/// Returns (cos, sin) of an angle. `parts(term, denominator)` is the number n of parts into which each term is divided: its sine and cosine are
/// expanded as polynomials in those of term/n. The usual n is the denominator of the term's coefficient.
pub(crate) fn circle_in_steps(angle: Sym, parts: impl Fn(Sym, i64) -> i64) -> Circle<Sym> {
    if angle == Sym::UNDEFINED {
        return Circle { cos: angle, sin: angle };
    }
    let points = linear_terms(angle).into_iter().map(|(term, coefficient)| multiple(term, coefficient, &parts));
    points.reduce(|before, next| before + next).unwrap_or_else(Circle::zero)
}

/// Splits an expression into a sum of distinct terms with rational coefficients, in the order of their appearance. A constant is a multiple of the term 1.
pub(crate) fn linear_terms(expression: Sym) -> Vec<(Sym, Rational)> {
    let mut terms: Vec<(Sym, Rational)> = Vec::new();
    let mut open = vec![(expression, Rational::one())];
    while let Some((next, factor)) = open.pop() {
        match next.node() {
            Node::Sum(a, b) => open.extend([(b, factor), (a, factor)]),
            Node::Difference(a, b) => open.extend([(b, -factor), (a, factor)]),
            Node::Negation(a) => open.push((a, -factor)),
            Node::Product(a, b) if a.as_constant().is_some() => open.push((b, times(a, factor))),
            Node::Product(a, b) if b.as_constant().is_some() => open.push((a, times(b, factor))),
            Node::Quotient(a, b) if b.as_constant().is_some() => open.push((a, factor / times(b, Rational::one()))),
            Node::Quotient(a, b) => {
                let ((above, numerator), (below, denominator)) = (scaled(a), scaled(b));
                let is_plain = numerator == a && denominator == b;
                collect(&mut terms, if is_plain { next } else { numerator / denominator }, factor * above / below);
            }
            Node::Constant(_) => collect(&mut terms, Sym::ONE, times(next, factor)),
            _ => collect(&mut terms, next, factor),
        }
    }
    terms.retain(|(_, coefficient)| !coefficient.is_zero());
    terms
}

/// Splits an expression into a rational factor and a rest whose first term has the coefficient 1: 2 s gives (2, s). Hence 2 s/R is a multiple of s/R.
fn scaled(expression: Sym) -> (Rational, Sym) {
    let terms = linear_terms(expression);
    match terms[..] {
        [(_, scale), ..] if scale != Rational::one() => {
            let own = terms.iter().map(|&(term, coefficient)| Sym::constant(coefficient / scale) * term);
            (scale, own.fold(Sym::ZERO, |sum, term| sum + term))
        }
        _ => (Rational::one(), expression),
    }
}

fn times(constant: Sym, factor: Rational) -> Rational {
    constant.as_constant().map_or(factor, |value| value * factor)
}

fn collect(terms: &mut Vec<(Sym, Rational)>, term: Sym, coefficient: Rational) {
    match terms.iter_mut().find(|(known, _)| *known == term) {
        Some((_, sum)) => *sum += coefficient,
        None => terms.push((term, coefficient)),
    }
}

/// Returns (cos, sin) of `coefficient * term`, expanded in those of term/n with n = `parts(term, denominator)`, or unexpanded if the multiple is too large.
fn multiple(term: Sym, coefficient: Rational, parts: impl Fn(Sym, i64) -> i64) -> Circle<Sym> {
    let counted = small_quotient(coefficient).filter(|_| term != Sym::ONE).and_then(|(times, denominator)| {
        let parts = parts(term, denominator);
        let times = times.checked_mul(parts / denominator)?;
        (parts % denominator == 0 && times.abs() <= HIGHEST_MULTIPLE).then_some((times, parts))
    });
    let (times, step) = match counted {
        Some((times, 1)) => (times, term),
        Some((times, parts)) => (times, term / Sym::int(parts)),
        None if coefficient.sign() == Some(-1) => (-1, Sym::constant(-coefficient) * term),
        None => (1, Sym::constant(coefficient) * term),
    };
    let single = Circle { cos: Sym::from_node(Node::Cos(step)), sin: Sym::from_node(Node::Sin(step)) };
    let around = (1..times.abs()).fold(single, |point, _| point + single);
    if times < 0 { -around } else { around }
}

/// Returns numerator and denominator if both are below 2^20 in magnitude.
pub(crate) fn small_quotient(value: Rational) -> Option<(i64, i64)> {
    let big = value.to_big()?;
    let small = |n: i64| (n.abs() < 1 << 20).then_some(n);
    Some((small(i64::try_from(big.numerator()).ok()?)?, small(i64::try_from(big.denominator()).ok()?)?))
}

/// Computes sqrt(n/d) = sqrt(n d)/d. The square part of n d is taken out of the root, and the rest is split into primes.
fn root_of_rational(value: Rational) -> Sym {
    let Some(big) = value.to_big().filter(|_| value.sign() != Some(-1)) else {
        return Sym::UNDEFINED;
    };
    if value.is_zero() {
        return Sym::ZERO;
    }
    let (numerator, denominator) = big.into_parts();
    let mut rest = numerator.unsigned_abs() * &denominator;
    let mut outside = UBig::ONE;
    let mut primes = Vec::new();
    let mut trial = 2u64;
    while trial <= HIGHEST_TRIAL && UBig::from(trial * trial) <= rest {
        let mut count = 0;
        while (&rest % trial).is_zero() {
            rest /= trial;
            count += 1;
        }
        outside *= UBig::from(trial).pow(count / 2);
        if count % 2 == 1 {
            primes.push(UBig::from(trial));
        }
        trial += if trial == 2 { 1 } else { 2 };
    }
    let root = dashu_int::ops::SquareRoot::sqrt(&rest);
    if &root * &root == rest {
        outside *= root;
    } else {
        primes.push(rest);
    }
    let (above, below) = dashu_ratio::RBig::from_parts(outside.into(), denominator).into_parts();
    let integer = |n: UBig| Sym::constant(Rational::from(dashu_ratio::RBig::from_parts(n.into(), UBig::ONE)));
    let roots = primes.into_iter().map(|prime| Sym::from_node(Node::Root(integer(prime))));
    let product = roots.fold(integer(above.unsigned_abs()), |product, root| product * root);
    product / integer(below)
}

/// Returns the least common multiple of two positive numbers; `None` if it is 2^20 or larger.
pub(crate) fn least_common_multiple(a: i64, b: i64) -> Option<i64> {
    let (mut divisor, mut rest) = (a, b);
    while rest != 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    (a / divisor).checked_mul(b).filter(|multiple| *multiple < 1 << 20)
}
