//! Products of powers of generators, eight exponents to a machine word.

use super::Limit;

/// The exponents, seven bits each and a guard bit above them: the first generator in the highest byte of the first
/// word. Comparing words compares exponents lexicographically, adding words multiplies monomials, and an exponent
/// above 127 shows in its guard bit.
pub type Monomial<const W: usize> = [u64; W];

/// Generators per word.
pub const PER_WORD: usize = 8;

const GUARDS: u64 = 0x8080_8080_8080_8080;

/// The monomial without generators.
pub const fn unit<const W: usize>() -> Monomial<W> {
    [0; W]
}

#[inline]
fn shift(generator: usize) -> u32 {
    8 * (PER_WORD - 1 - generator % PER_WORD) as u32
}

/// The power of one generator.
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

/// a / b where every exponent of b is at most that of a.
#[inline]
pub fn quotient<const W: usize>(a: &Monomial<W>, b: &Monomial<W>) -> Option<Monomial<W>> {
    let mut difference = *a;
    let mut guards = GUARDS;
    for (word, other) in difference.iter_mut().zip(b) {
        // The guard bit lends to its own exponent alone, and is cleared by a borrow.
        let lent = (*word | GUARDS) - other;
        guards &= lent;
        *word = lent & !GUARDS;
    }
    (guards == GUARDS).then_some(difference)
}

/// Exponent by exponent the smaller (or the larger) of two.
pub fn extremes<const W: usize>(a: &Monomial<W>, b: &Monomial<W>, largest: bool) -> Monomial<W> {
    let mut result = *a;
    for (word, &other) in result.iter_mut().zip(b) {
        // All ones in the fields where word >= other.
        let at_least = ((((*word | GUARDS) - other) & GUARDS) >> 7) * 0xff;
        let (high, low) = ((*word & at_least) | (other & !at_least), (other & at_least) | (*word & !at_least));
        *word = if largest { high } else { low };
    }
    result
}

/// The generators that occur, with their exponents.
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
