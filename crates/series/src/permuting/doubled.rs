//! Eight double-double numbers in two registers: their high parts and their low parts.
//!
//! A sum of products keeps its low part unnormalised; where sums are combined it is normalised. The error is of the
//! size of the 105th binary digit of the largest term.

use super::Permuting;
use crate::pick::{Columns, OneByOne, Pick, Selection};
use crate::small::{Permute, Shuffle};
use crate::stored::Parts;
use field::DoubleDouble;
use std::arch::x86_64::__m512d;

impl Pick<DoubleDouble> for Permuting {
    const FUSED: bool = true;
    type Eight = [__m512d; 2];

    #[inline(always)]
    fn pick<const W: usize, const N: usize>(
        self,
        from: &Columns<DoubleDouble, N>,
        selection: &Selection<W>,
    ) -> [DoubleDouble; W] {
        OneByOne::<true>.pick(from, selection)
    }

    #[inline(always)]
    fn load(self, from: &Parts) -> Self::Eight {
        [pulp::cast(from.first), pulp::cast(from.rest)]
    }

    #[inline(always)]
    fn store(self, [first, rest]: Self::Eight) -> Parts {
        Parts { first: pulp::cast(first), rest: pulp::cast(rest) }
    }

    #[inline(always)]
    fn all(self, number: DoubleDouble) -> Self::Eight {
        [pulp::cast([number.hi(); 8]), pulp::cast([number.lo(); 8])]
    }

    #[inline(always)]
    fn plus_product(self, [sum, so_far]: Self::Eight, a: Self::Eight, b: Self::Eight) -> Self::Eight {
        let [product, lost] = twice(self.0, a, b);
        let [sum, rounded] = two_sum(self.0, sum, product);
        let simd = self.0.avx512f;
        [sum, simd._mm512_add_pd(so_far, simd._mm512_add_pd(rounded, lost))]
    }
}

impl Permute<DoubleDouble> for Permuting {
    #[inline(always)]
    fn shuffle(self, [low, high]: [Self::Eight; 2], shuffle: &Shuffle) -> Self::Eight {
        let (simd, shuffle) = (self.0.avx512f, pulp::cast(shuffle.0));
        let first = simd._mm512_permutex2var_pd(low[0], shuffle, high[0]);
        [first, simd._mm512_permutex2var_pd(low[1], shuffle, high[1])]
    }

    #[inline(always)]
    fn spread(self, [first, rest]: Self::Eight, number: usize) -> Self::Eight {
        let (simd, number) = (self.0.avx512f, pulp::cast([number as u64; 8]));
        [simd._mm512_permutexvar_pd(number, first), simd._mm512_permutexvar_pd(number, rest)]
    }

    #[inline(always)]
    fn blend(self, bits: u8, a: Self::Eight, b: Self::Eight) -> Self::Eight {
        let simd = self.0.avx512f;
        [simd._mm512_mask_blend_pd(bits, a[0], b[0]), simd._mm512_mask_blend_pd(bits, a[1], b[1])]
    }

    #[inline(always)]
    fn plus(self, [a, a_rest]: Self::Eight, [b, b_rest]: Self::Eight) -> Self::Eight {
        let [sum, rounded] = two_sum(self.0, a, b);
        let simd = self.0.avx512f;
        two_sum(self.0, sum, simd._mm512_add_pd(rounded, simd._mm512_add_pd(a_rest, b_rest)))
    }

    #[inline(always)]
    fn product(self, a: Self::Eight, b: Self::Eight) -> Self::Eight {
        let [product, lost] = twice(self.0, a, b);
        two_sum(self.0, product, lost)
    }
}

/// The product a b and its rounding error.
#[inline(always)]
fn twice(simd: pulp::x86::V4, [a, a_rest]: [__m512d; 2], [b, b_rest]: [__m512d; 2]) -> [__m512d; 2] {
    let simd = simd.avx512f;
    let product = simd._mm512_mul_pd(a, b);
    let lost = simd._mm512_fmsub_pd(a, b, product);
    [product, simd._mm512_fmadd_pd(a_rest, b, simd._mm512_fmadd_pd(a, b_rest, lost))]
}

/// The sum a + b and its rounding error (Knuth).
#[inline(always)]
fn two_sum(simd: pulp::x86::V4, a: __m512d, b: __m512d) -> [__m512d; 2] {
    let simd = simd.avx512f;
    let sum = simd._mm512_add_pd(a, b);
    let of_b = simd._mm512_sub_pd(sum, a);
    let of_a = simd._mm512_sub_pd(sum, of_b);
    [sum, simd._mm512_add_pd(simd._mm512_sub_pd(a, of_a), simd._mm512_sub_pd(b, of_b))]
}
