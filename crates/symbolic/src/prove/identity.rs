//! Identity testing: an expression that vanishes at random points of random prime fields vanishes, but for a small probability of
//! error that is computed (Schwartz 1980; Zippel 1979).
//!
//! Symbols take random values, each angle a random point of the circle by the tangent of its half. Functions take random values of
//! their own, as if they were independent of their arguments: what vanishes even then vanishes for the true ones. A root takes
//! both roots of its argument at the point, and the expression must vanish for all of them; a point where one has none in the field is
//! drawn again. If it does not vanish then some symmetric function of its conjugates does not either, with twice the degree for each
//! root, and twice the chance where all roots exist. Where there are more than four, roots are taken as functions. So the expression is a quotient
//! of polynomials in random numbers, of a degree d and with coefficients of so many bits b, both bounded operation by operation. One
//! that is not zero is zero in a random field of the set with a probability of at most (b/60)/2^54, since it has no more than b/60
//! such primes as divisors; where it is not, it vanishes at a random point with one of at most d/2^60. No product is expanded: the
//! cost is one operation for each node and point.

use crate::Sym;
use crate::graph::Node;
use dashu_int::UBig;
use dashu_int::ops::{BitTest, UnsignedAbs};
use field::Rational;
use rustc_hash::FxHashMap;

/// Primes lie between 2^60 and 2^61: more than 2^54 of them (their density is one in 42).
const BITS: f64 = 60.0;
const PRIMES: f64 = 54.0;

/// The error that is allowed, as a power of two.
const ALLOWED: f64 = -100.0;

/// Points beyond which the degree is too high to be tested.
const MOST_POINTS: usize = 64;

/// Roots that are taken in the field, at most.
const MOST_ROOTS: usize = 4;

/// Points in vain, at which a denominator vanishes, or for each root four times as many where it is none of the field, after which it is taken to vanish everywhere.
const MOST_IN_VAIN: usize = 16;

/// The result of a test at random points.
#[derive(Clone, Debug, PartialEq)]
pub enum Identity {
    /// The expression vanishes at every point: it is zero, but for a probability of error of at most 2^`error`.
    Identified { degree: f64, points: usize, error: f64 },
    /// The expression does not vanish where angles are independent of each other.
    NotZero,
    /// It was not tested, for this reason.
    Untested(&'static str),
}

/// Tests whether expressions vanish, all at the same points.
pub fn identified(expressions: &[Sym]) -> Identity {
    let nodes = Sym::ascending(expressions);
    let roots = nodes.iter().filter(|each| matches!(each.node(), Node::Root(_))).count();
    let taken = if roots <= MOST_ROOTS { roots } else { 0 };
    let is_opaque = |each: &Sym| match each.node() {
        Node::Elementary(..) | Node::Function(..) => true,
        Node::Root(_) => taken == 0,
        _ => false,
    };
    let opaque = nodes.iter().any(is_opaque);
    if nodes.contains(&Sym::UNDEFINED) {
        return Identity::Untested("a denominator is the constant zero");
    }
    let Bounds { degree, bits } = bounds(&nodes, expressions);
    let each = ((degree.log2() - BITS).exp2() + (bits / BITS) * (-PRIMES).exp2()).log2();
    // conjugates, and the points at which all roots are in the field
    let each = each + 2.0 * taken as f64 + if taken > 0 { 1.0 } else { 0.0 };
    let points = if each < 0.0 { (ALLOWED / each).ceil() } else { f64::INFINITY };
    if !(1.0..=MOST_POINTS as f64).contains(&points) {
        return Identity::Untested("the degree is too high for these fields");
    }
    let points = points as usize;
    let (mut random, mut in_vain, mut done) = (Random(0x9e37_79b9_7f4a_7c15), 0, 0);
    // for each choice of signs of the roots
    let mut vanishes = vec![true; 1 << taken];
    while done < points && vanishes.contains(&true) {
        let field = Field(random.prime(taken > 0));
        let drawn = random.0;
        let of_signs = |signs: u32| {
            let mut random = Random(drawn);
            let values = values(&nodes, &field, &mut random, (taken > 0).then_some(signs))?;
            Some((expressions.iter().all(|each| values[each] == 0), random.0))
        };
        let all: Option<Vec<(bool, u64)>> = (0..1 << taken).map(of_signs).collect();
        match all {
            None if in_vain == MOST_IN_VAIN << (2 * taken) => {
                return Identity::Untested("a denominator vanishes at every point that was tried");
            }
            None => {
                in_vain += 1;
                random.next();
            }
            Some(all) => {
                done += 1;
                vanishes.iter_mut().zip(&all).for_each(|(vanishes, (here, _))| *vanishes &= here);
                random.0 = all[0].1;
                if taken == 0 && !vanishes[0] {
                    break;
                }
            }
        }
    }
    match (vanishes.iter().all(|all| *all), vanishes.contains(&true), opaque) {
        (true, ..) => Identity::Identified { degree, points, error: each * points as f64 },
        (false, true, _) => Identity::Untested("it vanishes for some signs of its roots alone"),
        (false, false, true) => Identity::Untested("it does not vanish for functions that are independent"),
        (false, false, false) => Identity::NotZero,
    }
}

/// Bounds of the numerator over the common denominator, in the random numbers.
struct Bounds {
    degree: f64,
    /// The logarithm of the sum of the sizes of its coefficients.
    bits: f64,
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

fn bounds(nodes: &[Sym], expressions: &[Sym]) -> Bounds {
    let mut known: FxHashMap<Sym, Quotient> = FxHashMap::default();
    let mut angles = rustc_hash::FxHashSet::default();
    let constant = |bits: f64| Polynomial { degree: 0.0, bits };
    let generator = Quotient { above: Polynomial { degree: 1.0, bits: 0.0 }, below: constant(0.0) };
    for &each in nodes {
        let of = |a: &Sym| known[a];
        let value = match each.node() {
            Node::Constant(_) => {
                let bits = |n: &UBig| constant(n.bit_len() as f64);
                let big = each.as_constant().and_then(Rational::to_big);
                let sizes = big.map(|big| (bits(&big.numerator().unsigned_abs()), bits(big.denominator())));
                let (above, below) = sizes.unwrap_or((constant(f64::INFINITY), constant(0.0)));
                Quotient { above, below }
            }
            Node::Symbol(_) | Node::Elementary(..) | Node::Function(..) => generator,
            // no larger than its square
            Node::Root(a) => {
                let Quotient { above, below } = of(&a);
                Quotient { above: above.times(generator.above), below }
            }
            Node::Cos(a) | Node::Sin(a) => {
                angles.insert(a);
                generator
            }
            Node::Sum(a, b) | Node::Difference(a, b) => {
                let (a, b) = (of(&a), of(&b));
                Quotient { above: a.above.times(b.below).plus(b.above.times(a.below)), below: a.below.times(b.below) }
            }
            Node::Product(a, b) => {
                Quotient { above: of(&a).above.times(of(&b).above), below: of(&a).below.times(of(&b).below) }
            }
            Node::Quotient(a, b) => {
                Quotient { above: of(&a).above.times(of(&b).below), below: of(&a).below.times(of(&b).above) }
            }
            Node::Negation(a) => of(&a),
            Node::Power(a, n) => Quotient { above: of(&a).above.power(n), below: of(&a).below.power(n) },
        };
        known.insert(each, value);
    }
    let all = || expressions.iter().map(|each| known[each]);
    let degree = all().map(|each| each.above.degree.max(each.below.degree)).fold(1.0, f64::max);
    let bits = all().map(|each| each.above.bits.max(each.below.bits)).fold(1.0, f64::max);
    // a cosine is (1 - t^2)/(1 + t^2): each angle brings its denominator to a power of at most the degree
    let angles = angles.len() as f64 + 1.0;
    Bounds { degree: 2.0 * degree * angles, bits: bits + degree * angles }
}

/// The values at a random point; none where a denominator vanishes. Roots have these signs, one bit each, or are taken as functions.
fn values(nodes: &[Sym], field: &Field, random: &mut Random, signs: Option<u32>) -> Option<FxHashMap<Sym, u64>> {
    let mut roots = 0;
    let mut values: FxHashMap<Sym, u64> = FxHashMap::default();
    let mut circle: FxHashMap<Sym, (u64, u64)> = FxHashMap::default();
    for &each in nodes {
        let mut point = |angle: Sym, random: &mut Random| -> Option<(u64, u64)> {
            if let Some(&known) = circle.get(&angle) {
                return Some(known);
            }
            let t = random.below(field.0);
            let square = field.times(t, t);
            let inverse = field.inverse(field.plus(1, square))?;
            let found = (field.times(field.minus(1, square), inverse), field.times(field.plus(t, t), inverse));
            circle.insert(angle, found);
            Some(found)
        };
        let of = |a: &Sym| values[a];
        let value = match each.node() {
            Node::Constant(_) => field.reduced(each.as_constant()?)?,
            Node::Root(a) if signs.is_some() => {
                let root = field.root(of(&a))?;
                let is_other = signs.is_some_and(|signs| signs >> roots & 1 == 1);
                roots += 1;
                if is_other { field.minus(0, root) } else { root }
            }
            Node::Symbol(_) | Node::Root(_) | Node::Elementary(..) | Node::Function(..) => random.below(field.0),
            Node::Sum(a, b) => field.plus(of(&a), of(&b)),
            Node::Difference(a, b) => field.minus(of(&a), of(&b)),
            Node::Product(a, b) => field.times(of(&a), of(&b)),
            Node::Quotient(a, b) => field.times(of(&a), field.inverse(of(&b))?),
            Node::Negation(a) => field.minus(0, of(&a)),
            Node::Power(a, n) => field.power(of(&a), n.into()),
            Node::Cos(a) => point(a, random)?.0,
            Node::Sin(a) => point(a, random)?.1,
        };
        values.insert(each, value);
    }
    Some(values)
}

/// The field of a prime.
struct Field(u64);

impl Field {
    fn plus(&self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.0 { sum - self.0 } else { sum }
    }

    fn minus(&self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.0 - b }
    }

    fn times(&self, a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(self.0)) as u64
    }

    fn power(&self, base: u64, mut exponent: u64) -> u64 {
        let (mut product, mut square) = (1, base);
        while exponent > 0 {
            if exponent & 1 == 1 {
                product = self.times(product, square);
            }
            square = self.times(square, square);
            exponent >>= 1;
        }
        product
    }

    /// A root in a field whose prime is 3 beyond a multiple of 4; none of what has none.
    fn root(&self, a: u64) -> Option<u64> {
        let root = self.power(a, self.0.div_ceil(4));
        (self.times(root, root) == a).then_some(root)
    }

    fn inverse(&self, a: u64) -> Option<u64> {
        (a != 0).then(|| self.power(a, self.0 - 2))
    }

    /// A rational number; none where its denominator is zero in the field.
    fn reduced(&self, value: Rational) -> Option<u64> {
        let (numerator, denominator) = value.to_big()?.into_parts();
        let modulo = |n: UBig| n % self.0;
        let quotient = self.times(modulo(numerator.unsigned_abs()), self.inverse(modulo(denominator))?);
        Some(if value.sign() == Some(-1) { self.minus(0, quotient) } else { quotient })
    }
}

/// Whether an odd number below 2^64 is prime: Miller and Rabin's test by bases that are known to suffice there.
fn is_prime(n: u64) -> bool {
    let bases = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    let (field, twos) = (Field(n), (n - 1).trailing_zeros());
    bases.iter().all(|&base| {
        let mut power = field.power(base, (n - 1) >> twos);
        power == 1
            || (0..twos).any(|_| {
                let met = power == n - 1;
                power = field.times(power, power);
                met
            })
    })
}

/// Numbers that are drawn the same way each time (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, prime: u64) -> u64 {
        loop {
            let drawn = self.next() >> 3;
            if drawn < prime {
                return drawn;
            }
        }
    }

    /// Between 2^60 and 2^61; where roots are taken, 3 beyond a multiple of 4, as every second one is.
    fn prime(&mut self, for_roots: bool) -> u64 {
        loop {
            let drawn = (1 << 60) | (self.next() >> 4) | if for_roots { 3 } else { 1 };
            if is_prime(drawn) {
                return drawn;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbols;
    use field::{Analytic, Elementary, Scalar};

    #[test]
    fn identities_are_seen_without_being_expanded() {
        let [x, y] = symbols(["x", "y"]);
        let (a, b) = (x.circle(), y.circle());
        let sum = (a.cos * b.cos - a.sin * b.sin) - (x + y).circle().cos;
        let tower = (0..20).fold(x + y, |power, _| power * power) - (0..20).fold(y + x, |power, _| power * power);
        let quotient = x / y - Sym::int(1) - (x - y) / y;
        for zero in [a.cos * a.cos + a.sin * a.sin - Sym::int(1), sum, quotient] {
            let Identity::Identified { error, .. } = identified(&[zero]) else { panic!("{zero}") };
            assert!(error <= ALLOWED, "{error}");
        }
        assert!(matches!(identified(&[tower]), Identity::Identified { .. }), "{:?}", identified(&[tower]));
        assert_eq!(identified(&[a.cos * a.cos + a.sin * a.sin - Sym::ratio(1_000_001, 1_000_000)]), Identity::NotZero);
    }

    #[test]
    fn a_number_that_one_prime_divides_is_not_taken_for_zero() {
        let [x] = symbols(["x"]);
        let prime = Random(0x9e37_79b9_7f4a_7c15).prime(false);
        assert_eq!(identified(&[x * Sym::int(prime as i64)]), Identity::NotZero);
        assert!(is_prime((1 << 61) - 1) && !is_prime((1 << 61) + 1) && is_prime(101) && !is_prime(3 * 5 * 17));
    }

    #[test]
    fn roots_are_those_of_their_squares() {
        let [x, y] = symbols(["x", "y"]);
        let length = (x * x + y * y).sqrt();
        let unit = x / length * (x / length) + y / length * (y / length) - Sym::ONE;
        assert!(matches!(identified(&[unit, length * length - x * x - y * y]), Identity::Identified { .. }));
        assert_eq!(identified(&[length - x - y]), Identity::NotZero);
        // a root of a square has one of two signs
        assert!(matches!(identified(&[(x * x).sqrt() - x]), Identity::Untested(_)));
        assert_eq!(identified(&[(x * x).sqrt() - y]), Identity::NotZero);
    }

    #[test]
    fn what_has_no_value_in_the_field_is_not_tested() {
        let [x] = symbols(["x"]);
        let many: Vec<Sym> = (1..6).map(|k| (x + Sym::int(k)).sqrt()).collect();
        assert_eq!(identified(&many[..3]), Identity::NotZero);
        assert!(matches!(identified(&many), Identity::Untested(_)));
        let twice = x.elementary(Elementary::Exp, x) - (x + x).elementary(Elementary::Exp, x).sqrt();
        assert!(matches!(identified(&[twice]), Identity::Untested(_)));
        let opaque = (x.sqrt() + Sym::ONE) * (x.sqrt() - Sym::ONE) - x.sqrt() * x.sqrt() + Sym::ONE;
        assert!(matches!(identified(&[opaque]), Identity::Identified { .. }));
        assert!(matches!(identified(&[Sym::ONE / (x - x)]), Identity::Untested(_)));
        let zero = (x + Sym::ONE) * (x - Sym::ONE) - x * x + Sym::ONE;
        assert!(matches!(identified(&[Sym::ONE / zero]), Identity::Untested(_)));
        let towering = (0..80).fold(x, |power, _| power * power);
        assert!(matches!(identified(&[towering]), Identity::Untested(_)));
    }
}
