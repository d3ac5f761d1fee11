//! Isolation of real roots by Descartes' rule of signs and bisection.
//!
//! The number of roots of q between 0 and 1 is at most the number of sign changes in the coefficients of (x+1)^n
//! q(1/(x+1)), and of equal parity. No change and one change are therefore exact; otherwise the interval is bisected.
//! For polynomials without repeated roots this terminates (Vincent's theorem).

use super::{Number, Polynomial, Root};
use dashu_int::IBig;
use dashu_int::ops::BitTest;
use std::sync::Arc;

/// The number of bisections after which repeated roots are removed.
const PATIENCE: usize = 96;

impl Polynomial {
    /// The distinct real roots in ascending order; empty for a constant or zero.
    pub fn real_roots(&self) -> Vec<Root> {
        let whole = self.primitive();
        whole.isolated(PATIENCE).unwrap_or_else(|| {
            let simple = whole.square_free();
            // its roots are simple, so that bisection terminates
            simple.isolated(usize::MAX).unwrap_or_default()
        })
    }

    /// The roots; `None` where the number of bisections exceeds `patience`.
    fn isolated(&self, patience: usize) -> Option<Vec<Root>> {
        let own = Arc::new(self.clone());
        let mut roots = Vec::new();
        let Some(degree) = self.degree().filter(|degree| *degree > 0) else { return Some(roots) };
        let zeros = self.coefficients().iter().take_while(|c| c.is_zero()).count();
        if zeros > 1 {
            return None;
        }
        let rest = Polynomial::new(self.coefficients()[zeros..].to_vec());
        let size = bound(&rest);
        for negative in [true, false] {
            // the unknown is 2^size x, or -2^size x, with x between 0 and 1
            let scaled = rest.map(|power, c| {
                let flip = negative && power % 2 == 1;
                let up = if size >= 0 { power * size as usize } else { (degree - power) * size.unsigned_abs() };
                let c = c.map(|part| part << up);
                if flip { -&c } else { c }
            });
            let mut found = Vec::new();
            halve(scaled.primitive(), DyadicInterval { at: IBig::ZERO, halvings: 0 }, patience, &mut found)?;
            if negative {
                found.reverse();
            } else if zeros == 1 {
                roots.push(Root::point(Arc::clone(&own), IBig::ZERO, 0));
            }
            for (DyadicInterval { at, halvings }, exact) in found {
                let at = match (negative, exact) {
                    (false, _) => at,
                    (true, true) => -at,
                    (true, false) => -at - IBig::ONE,
                };
                let scale = halvings as isize - size;
                roots.push(match exact {
                    true => Root::point(Arc::clone(&own), at, scale),
                    false => Root::between(Arc::clone(&own), at, scale),
                });
            }
        }
        Some(roots)
    }
}

/// The interval (at, at + 1) / 2^halvings, or its lower end.
struct DyadicInterval {
    at: IBig,
    halvings: usize,
}

/// Finds the roots of q in (0, 1), which represents the interval `place`, in ascending order.
fn halve(q: Polynomial, place: DyadicInterval, patience: usize, found: &mut Vec<(DyadicInterval, bool)>) -> Option<()> {
    let Some(degree) = q.degree() else { return Some(()) };
    let reversed = Polynomial::new(q.coefficients().iter().rev().cloned().collect());
    match changes(&shifted(&reversed)) {
        0 => return Some(()),
        1 => {
            found.push((place, false));
            return Some(());
        }
        _ if place.halvings >= patience => return None,
        _ => {}
    }
    let (at, halvings) = (place.at << 1, place.halvings + 1);
    let left = q.map(|power, c| c.map(|part| part << (degree - power))).primitive();
    let right = shifted(&left);
    let middle = right.coefficients().first().is_some_and(Number::is_zero);
    halve(left, DyadicInterval { at: at.clone(), halvings }, patience, found)?;
    let upper = at + IBig::ONE;
    let right = if middle {
        found.push((DyadicInterval { at: upper.clone(), halvings }, true));
        // a second zero there is a repeated root
        let rest = Polynomial::new(right.coefficients()[1..].to_vec());
        if rest.coefficients().first().is_some_and(Number::is_zero) {
            return None;
        }
        rest
    } else {
        right
    };
    halve(right, DyadicInterval { at: upper, halvings }, patience, found)
}

/// The coefficients of q(x + 1).
fn shifted(q: &Polynomial) -> Polynomial {
    let mut c = q.coefficients().to_vec();
    for i in 0..c.len() {
        for j in (i..c.len() - 1).rev() {
            c[j] = &c[j] + &c[j + 1];
        }
    }
    Polynomial::new(c)
}

fn changes(q: &Polynomial) -> usize {
    let signs: Vec<i32> = q.coefficients().iter().map(Number::sign).filter(|sign| *sign != 0).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// An exponent k such that every root is smaller than 2^k: 2 max |c_i / c_n|^(1/(n-i)) (Fujiwara), from bit lengths.
fn bound(q: &Polynomial) -> isize {
    let Some(degree) = q.degree() else { return 0 };
    // upper and lower bound of the magnitude of a coefficient, in bits
    let high = |c: &Number| log2(c).1;
    let low = log2(&q.lead()).0;
    let each = q.coefficients()[..degree].iter().enumerate().filter(|(_, c)| !c.is_zero());
    let of = |(power, c): (usize, &Number)| {
        let (excess, distance) = (high(c) - low, (degree - power) as isize);
        excess.div_euclid(distance) + 1
    };
    each.map(of).max().unwrap_or(0) + 1
}

/// Exponents of two that bound the magnitude of a nonzero number.
fn log2(c: &Number) -> (isize, isize) {
    if let Some(n) = c.as_integer() {
        let bits = n.bit_len() as isize;
        return (bits - 1, bits);
    }
    let mut fine = 64;
    loop {
        if let Some(bounds) = c.enclosure(fine).magnitude() {
            return bounds;
        }
        fine *= 2;
    }
}
