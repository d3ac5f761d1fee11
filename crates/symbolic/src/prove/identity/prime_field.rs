//! Prime fields between 2^60 and 2^61, and random numbers in them.

use dashu_int::UBig;
use dashu_int::ops::UnsignedAbs;
use field::Rational;

/// The field of integers modulo a prime.
pub(super) struct Field(pub u64);

impl Field {
    pub fn plus(&self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.0 { sum - self.0 } else { sum }
    }

    pub fn minus(&self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.0 - b }
    }

    pub fn times(&self, a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(self.0)) as u64
    }

    pub fn power(&self, base: u64, mut exponent: u64) -> u64 {
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

    /// Returns a square root modulo a prime p with p = 3 (mod 4); `None` if the number is not a square.
    pub fn root(&self, a: u64) -> Option<u64> {
        let root = self.power(a, self.0.div_ceil(4));
        (self.times(root, root) == a).then_some(root)
    }

    pub fn inverse(&self, a: u64) -> Option<u64> {
        (a != 0).then(|| self.power(a, self.0 - 2))
    }

    /// Returns whether a square matrix is regular.
    pub fn has_full_rank(&self, mut rows: Vec<Vec<u64>>) -> bool {
        for at in 0..rows.len() {
            let Some(pivot) = (at..rows.len()).find(|&row| rows[row][at] != 0) else { return false };
            rows.swap(at, pivot);
            let Some(inverse) = self.inverse(rows[at][at]) else { return false };
            let (above, below) = rows.split_at_mut(at + 1);
            for row in below {
                let factor = self.times(row[at], inverse);
                for (entry, &pivot) in row.iter_mut().zip(&above[at]) {
                    *entry = self.minus(*entry, self.times(factor, pivot));
                }
            }
        }
        true
    }

    /// Returns a rational number modulo the prime; `None` if its denominator is divisible by the prime.
    pub fn reduced(&self, value: Rational) -> Option<u64> {
        let (numerator, denominator) = value.to_big()?.into_parts();
        let modulo = |n: UBig| n % self.0;
        let quotient = self.times(modulo(numerator.unsigned_abs()), self.inverse(modulo(denominator))?);
        Some(if value.sign() == Some(-1) { self.minus(0, quotient) } else { quotient })
    }
}

/// Tests whether an odd number below 2^64 is prime, by the Miller-Rabin test with bases that are proved sufficient in this range.
pub(super) fn is_prime(n: u64) -> bool {
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

/// Pseudorandom numbers with a fixed seed (splitmix64), hence equal in every run.
pub(super) struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    pub fn below(&mut self, prime: u64) -> u64 {
        loop {
            let drawn = self.next() >> 3;
            if drawn < prime {
                return drawn;
            }
        }
    }

    /// Returns a random prime between 2^60 and 2^61; with `for_roots` one with p = 3 (mod 4), as about half of all primes.
    pub fn prime(&mut self, for_roots: bool) -> u64 {
        loop {
            let drawn = (1 << 60) | (self.next() >> 4) | if for_roots { 3 } else { 1 };
            if is_prime(drawn) {
                return drawn;
            }
        }
    }
}
