//! Images of polynomials modulo a prime, with all generators but one at fixed pseudo-random residues. Images inherit
//! divisibility: they quickly show that a division is not exact, or that two polynomials are coprime.

use super::{Coefficient, Poly, monomial};

/// The prime 2^61 - 1.
const PRIME: u64 = (1 << 61) - 1;

fn times(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    plus((product as u64) & PRIME, (product >> 61) as u64)
}

fn plus(a: u64, b: u64) -> u64 {
    let sum = a + b;
    if sum >= PRIME { sum - PRIME } else { sum }
}

fn minus(a: u64, b: u64) -> u64 {
    plus(a, PRIME - b)
}

fn inverse(a: u64) -> u64 {
    let (mut power, mut base, mut exponent) = (1, a, PRIME - 2);
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = times(power, base);
        }
        base = times(base, base);
        exponent >>= 1;
    }
    power
}

/// The fixed residue of a generator, by splitmix of its number.
fn residue(generator: usize) -> u64 {
    let mut z = (generator as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (z ^ (z >> 31)) % PRIME
}

/// The image as coefficients of ascending powers of the remaining generator; the last one is nonzero.
#[derive(Clone, Debug)]
pub(super) struct Image(Vec<u64>);

impl Image {
    pub fn of<C: Coefficient, const W: usize>(poly: &Poly<C, W>, generator: usize) -> Self {
        let highest = poly.degrees();
        let powers: Vec<Vec<u64>> = (0..W * monomial::PER_WORD)
            .map(|each| {
                let degree = monomial::exponent(&highest, each);
                let step = if degree > 0 { residue(each) } else { 0 };
                std::iter::successors(Some(1), |&power| Some(times(power, step))).take(degree as usize + 1).collect()
            })
            .collect();
        let mut coefficients = vec![0; monomial::exponent(&highest, generator) as usize + 1];
        for (m, c) in poly.terms() {
            let mut value = c.modulo(PRIME);
            for (each, exponent) in monomial::support(m) {
                if each != generator {
                    value = times(value, powers[each][exponent as usize]);
                }
            }
            let sum = &mut coefficients[monomial::exponent(m, generator) as usize];
            *sum = plus(*sum, value);
        }
        Image(coefficients).trimmed()
    }

    fn trimmed(mut self) -> Self {
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
        self
    }

    /// The degree; `None` for zero.
    pub fn degree(&self) -> Option<usize> {
        self.0.len().checked_sub(1)
    }

    /// The remainder modulo an image that is not zero.
    pub fn remainder(mut self, divisor: &Image) -> Image {
        let Some(lead) = divisor.0.last().map(|&lead| inverse(lead)) else {
            return self;
        };
        while self.0.len() >= divisor.0.len() {
            let Some(&top) = self.0.last() else { break };
            let factor = times(top, lead);
            let offset = self.0.len() - divisor.0.len();
            for (place, &coefficient) in divisor.0.iter().enumerate() {
                self.0[offset + place] = minus(self.0[offset + place], times(factor, coefficient));
            }
            self = self.trimmed();
        }
        self
    }

    /// The degree of the greatest common divisor.
    pub fn common_degree(self, other: Image) -> usize {
        let (mut a, mut b) = (self, other);
        while b.degree().is_some() {
            let remainder = a.remainder(&b);
            (a, b) = (b, remainder);
        }
        a.degree().unwrap_or(0)
    }
}
