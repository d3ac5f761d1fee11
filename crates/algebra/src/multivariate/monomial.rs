//! Monomials with packed exponents, eight to a machine word.

use super::Limit;

/// The exponents of the generators: seven bits each with a guard bit above; the first generator is in the highest byte
/// of the first word. Comparison of words compares exponents lexicographically, addition of words multiplies monomials,
/// and an exponent above 127 sets its guard bit.
pub type Monomial<const W: usize> = [u64; W];

/// The number of generators per word.
pub const PER_WORD: usize = 8;

const GUARDS: u64 = 0x8080_8080_8080_8080;

/// The monomial 1.
pub const fn unit<const W: usize>() -> Monomial<W> {
    [0; W]
}

#[inline]
fn shift(generator: usize) -> u32 {
    8 * (PER_WORD - 1 - generator % PER_WORD) as u32
}

/// The power of one generator.
///
/// # Errors
/// [`Limit::Degree`] for an exponent above 127.
pub fn power<const W: usize>(generator: usize, exponent: u32) -> Result<Monomial<W>, Limit> {
    if exponent > 127 {
        return Err(Limit::Degree);
    }
    let mut monomial = unit();
    monomial[generator / PER_WORD] = u64::from(exponent) << shift(generator);
    Ok(monomial)
}

#[inline]
pub fn exponent<const W: usize>(monomial: &Monomial<W>, generator: usize) -> u32 {
    ((monomial[generator / PER_WORD] >> shift(generator)) & 0x7f) as u32
}

#[inline]
pub fn product<const W: usize>(a: &Monomial<W>, b: &Monomial<W>) -> Result<Monomial<W>, Limit> {
    let mut sum = *a;
    let mut guards = 0;
    for (word, other) in sum.iter_mut().zip(b) {
        *word += other;
        guards |= *word;
    }
    if guards & GUARDS == 0 { Ok(sum) } else { Err(Limit::Degree) }
}

/// The quotient a / b; `None` where an exponent of b exceeds that of a.
#[inline]
pub fn quotient<const W: usize>(a: &Monomial<W>, b: &Monomial<W>) -> Option<Monomial<W>> {
    let mut difference = *a;
    let mut guards = GUARDS;
    for (word, other) in difference.iter_mut().zip(b) {
        // each guard bit lends to its own exponent, and is cleared by a borrow
        let lent = (*word | GUARDS) - other;
        guards &= lent;
        *word = lent & !GUARDS;
    }
    (guards == GUARDS).then_some(difference)
}

/// The smaller (or, with `largest`, the larger) exponent of each generator.
pub fn extremes<const W: usize>(a: &Monomial<W>, b: &Monomial<W>, largest: bool) -> Monomial<W> {
    let mut result = *a;
    for (word, &other) in result.iter_mut().zip(b) {
        // 0xff in the bytes where word >= other
        let at_least = ((((*word | GUARDS) - other) & GUARDS) >> 7) * 0xff;
        let (high, low) = ((*word & at_least) | (other & !at_least), (other & at_least) | (*word & !at_least));
        *word = if largest { high } else { low };
    }
    result
}

/// The generators with nonzero exponents.
pub fn support<const W: usize>(monomial: &Monomial<W>) -> impl Iterator<Item = (usize, u32)> + '_ {
    monomial.iter().enumerate().flat_map(|(place, &word)| {
        let mut rest = word;
        std::iter::from_fn(move || {
            if rest == 0 {
                return None;
            }
            let byte = rest.leading_zeros() / 8;
            let bits = 56 - 8 * byte;
            let exponent = (rest >> bits) as u32;
            rest &= !(0xff << bits);
            Some((place * PER_WORD + byte as usize, exponent))
        })
    })
}
