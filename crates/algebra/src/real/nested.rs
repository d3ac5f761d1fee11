//! Real roots of polynomials whose coefficients are polynomials in another real root, without constructing the
//! extension field of both.
//!
//! Every sign needed is that of a polynomial at the first root, which is exact. The roots of the second polynomial are
//! counted by Sturm's theorem and separated by bisection.

use super::{Enclosure, Polynomial, Root};
use dashu_int::IBig;

/// A real root s of sum c_j(x) s^j at a root x: the only one between two multiples of 2^-scale, which are no roots.
#[derive(Clone, Debug)]
pub struct Nested {
    base: Root,
    /// The coefficients, the constant first, of a polynomial without repeated roots.
    polynomial: Vec<Polynomial>,
    low: IBig,
    high: IBig,
    scale: usize,
    /// The sign of the polynomial at the lower end.
    below: i32,
}

impl Nested {
    /// All distinct such roots in ascending order; `coefficients` begin with the constant. Empty for a polynomial that
    /// vanishes at x.
    pub fn roots(base: &Root, coefficients: &[Polynomial]) -> Vec<Self> {
        let Over { base, parts: polynomial } = Over::new(base, coefficients).square_free();
        let over = Over { base, parts: polynomial };
        let chain = over.sturm();
        let Some(size) = over.bound() else { return Vec::new() };
        let bound = IBig::ONE << size;
        let mut open = vec![(-bound.clone(), bound, 0)];
        let mut roots = Vec::new();
        while let Some((low, high, scale)) = open.pop() {
            match chain.changes(&low, scale).saturating_sub(chain.changes(&high, scale)) {
                0 => {}
                1 => roots.push(Nested {
                    base: base.clone(),
                    below: over.sign(&low, scale),
                    polynomial: over.parts.clone(),
                    low,
                    high,
                    scale,
                }),
                _ => {
                    let (low, middle, high, scale) = over.divided(&low, &high, scale);
                    open.push((middle.clone(), high, scale));
                    open.push((low, middle, scale));
                }
            }
        }
        roots
    }

    /// An enclosure of width at most 2^-bits.
    pub fn enclosure(&self, bits: usize) -> Enclosure {
        let over = Over { base: &self.base, parts: self.polynomial.clone() };
        let (mut low, mut high, mut scale) = (self.low.clone(), self.high.clone(), self.scale);
        while (&high - &low) << bits > IBig::ONE << scale {
            let (left, middle, right, finer) = over.divided(&low, &high, scale);
            let same = over.sign(&middle, finer) == self.below;
            (low, high, scale) = if same { (middle, right, finer) } else { (left, middle, finer) };
        }
        Enclosure::new(low, high, scale).finer(bits + 2)
    }

    /// The sign of another polynomial of this form at (x, s): -1, 0 or 1.
    pub fn sign_of(&self, other: &[Polynomial]) -> i32 {
        let (own, other) = (Over { base: &self.base, parts: self.polynomial.clone() }, Over::new(&self.base, other));
        if other.parts.is_empty() {
            return 0;
        }
        let common = own.gcd(&other);
        let shared = common.sign(&self.low, self.scale) * common.sign(&self.high, self.scale) < 0;
        if common.parts.len() > 1 && shared {
            return 0;
        }
        let mut bits = 64;
        loop {
            let (x, s) = (self.base.enclosure(bits), self.enclosure(bits));
            let zero = Enclosure::integer(IBig::ZERO, bits);
            let value = other.parts.iter().rev().fold(zero, |sum, c| &(&sum * &s) + &c.enclosure(&x, bits));
            if let Some(sign) = value.sign().filter(|sign| *sign != 0) {
                return sign;
            }
            bits *= 2;
        }
    }
}

/// A polynomial whose coefficients are polynomials at a root x; its leading coefficient does not vanish there.
struct Over<'a> {
    base: &'a Root,
    parts: Vec<Polynomial>,
}

/// Sturm's chain.
struct Chain<'a>(Vec<Over<'a>>);

impl<'a> Over<'a> {
    fn new(base: &'a Root, coefficients: &[Polynomial]) -> Self {
        let mut parts = coefficients.to_vec();
        while parts.last().is_some_and(|lead| base.sign_of(lead) == 0) {
            parts.pop();
        }
        Over { base, parts }
    }

    fn derivative(&self) -> Self {
        let terms = self.parts.iter().enumerate().skip(1);
        let parts = terms.map(|(power, c)| c * &Polynomial::from_integers([power as i64])).collect();
        Over { base: self.base, parts }
    }

    /// Quotient and remainder of a positive multiple.
    fn divided_by(&self, divisor: &Self) -> (Self, Self) {
        let Some((lead, lower)) = divisor.parts.split_last() else {
            return (Over { base: self.base, parts: Vec::new() }, Over { base: self.base, parts: self.parts.clone() });
        };
        let negative = self.base.sign_of(lead) < 0;
        let size = if negative { -lead } else { lead.clone() };
        let mut rest = self.parts.clone();
        let mut quotient = vec![Polynomial::default(); (self.parts.len() + 1).saturating_sub(divisor.parts.len())];
        while rest.len() >= divisor.parts.len() {
            let Some(top) = rest.pop() else { break };
            let at = rest.len() - lower.len();
            let top = if negative { -&top } else { top };
            quotient.iter_mut().for_each(|c| *c = &*c * &size);
            quotient[at] = &quotient[at] + &top;
            rest.iter_mut().for_each(|c| *c = &*c * &size);
            for (place, c) in lower.iter().enumerate() {
                rest[at + place] = &rest[at + place] - &(c * &top);
            }
        }
        (Over::new(self.base, &quotient), Over::new(self.base, &rest))
    }

    fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (Over { base: self.base, parts: self.parts.clone() }, Over::new(other.base, &other.parts));
        while !b.parts.is_empty() {
            let rest = a.divided_by(&b).1;
            (a, b) = (b, rest);
        }
        a
    }

    fn square_free(&self) -> Self {
        let repeated = self.gcd(&self.derivative());
        match repeated.parts.len() {
            0 | 1 => Over { base: self.base, parts: self.parts.clone() },
            _ => self.divided_by(&repeated).0,
        }
    }

    fn sturm(&self) -> Chain<'a> {
        let mut chain = vec![Over { base: self.base, parts: self.parts.clone() }];
        let mut next = self.derivative();
        while let Some(last) = chain.last().filter(|_| !next.parts.is_empty()) {
            let rest = last.divided_by(&next).1;
            chain.push(next);
            next = Over { base: self.base, parts: rest.parts.iter().map(|c| -c).collect() };
        }
        Chain(chain)
    }

    /// The sign at s = n / 2^scale.
    fn sign(&self, n: &IBig, scale: usize) -> i32 {
        let mut sum = Polynomial::default();
        for (steps, c) in self.parts.iter().rev().enumerate() {
            let by = |factor: IBig| Polynomial::from_integers([factor]);
            sum = &(&sum * &by(n.clone())) + &(c * &by(IBig::ONE << (steps * scale)));
        }
        self.base.sign_of(&sum)
    }

    /// An exponent k such that all roots are smaller than 2^k (Cauchy: 1 + max |c_j/c_n|); `None` without roots.
    fn bound(&self) -> Option<usize> {
        let (lead, lower) = self.parts.split_last().filter(|(_, lower)| !lower.is_empty())?;
        let mut bits = 64;
        loop {
            let x = self.base.enclosure(bits);
            let lead = lead.enclosure(&x, bits);
            let shares: Option<Vec<Enclosure>> = lower.iter().map(|c| c.enclosure(&x, bits).over(&lead)).collect();
            if let Some(shares) = shares {
                let most = shares.iter().flat_map(Enclosure::ends).map(f64::abs).fold(1.0, f64::max);
                return Some(most.log2().ceil() as usize + 2);
            }
            bits *= 2;
        }
    }

    /// An interval, a point within it that is close to the middle and no root, and the finer scale.
    fn divided(&self, low: &IBig, high: &IBig, scale: usize) -> (IBig, IBig, IBig, usize) {
        let mut finer = 1;
        loop {
            let (low, high) = (low << finer, high << finer);
            let middle = (&low + &high) / IBig::from(2);
            // the next candidates are on both sides of the middle
            for candidate in [middle.clone(), middle + IBig::ONE] {
                if candidate > low && candidate < high && self.sign(&candidate, scale + finer) != 0 {
                    return (low, candidate, high, scale + finer);
                }
            }
            finer += 1;
        }
    }
}

impl Chain<'_> {
    fn changes(&self, n: &IBig, scale: usize) -> usize {
        let signs: Vec<i32> = self.0.iter().map(|p| p.sign(n, scale)).filter(|sign| *sign != 0).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn poly(c: &[i64]) -> Polynomial {
        Polynomial::from_integers(c.iter().copied())
    }

    /// The root sqrt(2).
    fn base() -> Root {
        poly(&[-2, 0, 1]).real_roots().pop().unwrap()
    }

    #[test]
    fn roots_over_a_root_are_counted_and_found() {
        // s^2 - x: the fourth root of 2 and its opposite
        let roots = Nested::roots(&base(), &[poly(&[0, -1]), poly(&[]), poly(&[1])]);
        let values: Vec<f64> = roots.iter().map(|root| root.enclosure(80).to_f64()).collect();
        assert_eq!(values, [-(2f64.sqrt().sqrt()), 2f64.sqrt().sqrt()]);
        // s^2 + x: none
        assert!(Nested::roots(&base(), &[poly(&[0, 1]), poly(&[]), poly(&[1])]).is_empty());
    }

    #[test]
    fn repeated_and_rational_roots_and_leading_zeros_are_no_exception() {
        // (s - x)^2 (s - 1) with a leading coefficient x^2 - 2 that vanishes
        let parts = [poly(&[0, 0, -1]), poly(&[0, 2, 1]), poly(&[-1, -2]), poly(&[1]), poly(&[-2, 0, 1])];
        let roots = Nested::roots(&base(), &parts);
        assert_eq!(roots.len(), 2);
        assert_eq!(roots[0].enclosure(80).to_f64(), 1.0);
        assert_eq!(roots[1].enclosure(80).to_f64(), 2f64.sqrt());
        // x s - 2 vanishes at s = x, and is negative at 1
        let other = [poly(&[-2]), poly(&[0, 1])];
        assert_eq!([roots[0].sign_of(&other), roots[1].sign_of(&other)], [-1, 0]);
    }
}
