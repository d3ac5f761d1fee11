//! Gathering of numbers by permutations of registers of eight `f64`, on processors with these instructions (AVX-512).

mod doubled;

use super::pick::{Columns, Pick, Selection};
use super::small::{Permute, Shuffle};
use std::arch::x86_64::__m512d;

/// A selection of columns, as permutations of blocks of eight.
#[derive(Clone, Debug)]
pub(super) struct ByBlocks {
    first: Permutation,
    more: Vec<Permutation>,
}

/// The numbers from two blocks of eight columns.
#[derive(Clone, Copy, Debug)]
struct Permutation {
    blocks: [u16; 2],
    /// For each place of the group a number from 0 to 15.
    of: [u64; 8],
    /// The places that these blocks fill, as a bit set.
    filled: u8,
}

impl ByBlocks {
    pub fn new(columns: &[u16]) -> Self {
        let mut blocks: Vec<u16> = columns.iter().map(|column| column / 8).collect();
        blocks.sort_unstable();
        blocks.dedup();
        let permutation = |pair: &[u16]| {
            let blocks = [pair[0], pair.get(1).copied().unwrap_or(pair[0])];
            let mut permutation = Permutation { blocks, of: [0; 8], filled: 0 };
            for (place, column) in columns.iter().enumerate().take(8) {
                if let Some(which) = blocks.iter().position(|block| *block == column / 8) {
                    permutation.of[place] = u64::from(column % 8) + 8 * which as u64;
                    permutation.filled |= 1 << place;
                }
            }
            permutation
        };
        let mut pairs = blocks.chunks(2).map(permutation);
        let nothing = Permutation { blocks: [0; 2], of: [0; 8], filled: 0 };
        ByBlocks { first: pairs.next().unwrap_or(nothing), more: pairs.collect() }
    }
}

/// The implementation by permutations.
#[derive(Clone, Copy)]
pub(super) struct Permuting(pub pulp::x86::V4);

impl Pick<f64> for Permuting {
    const FUSED: bool = true;
    type Eight = __m512d;

    #[inline(always)]
    fn pick<const W: usize, const N: usize>(self, from: &Columns<f64, N>, selection: &Selection<W>) -> [f64; W] {
        let mut picked = permuted(self.0, from, &selection.by_blocks.first);
        for permutation in &selection.by_blocks.more {
            let taken = permuted(self.0, from, permutation);
            picked = self.0.avx512f._mm512_mask_blend_pd(permutation.filled, picked, taken);
        }
        let eight: [f64; 8] = pulp::cast(picked);
        let mut lanes = [0.0; W];
        for (lane, number) in lanes.iter_mut().zip(eight) {
            *lane = number;
        }
        lanes
    }

    #[inline(always)]
    fn load(self, from: &[f64; 8]) -> __m512d {
        pulp::cast(*from)
    }

    #[inline(always)]
    fn store(self, eight: __m512d) -> [f64; 8] {
        pulp::cast(eight)
    }

    #[inline(always)]
    fn all(self, number: f64) -> __m512d {
        pulp::cast([number; 8])
    }

    #[inline(always)]
    fn plus_product(self, sum: __m512d, a: __m512d, b: __m512d) -> __m512d {
        self.0.avx512f._mm512_fmadd_pd(a, b, sum)
    }
}

impl Permute<f64> for Permuting {
    #[inline(always)]
    fn shuffle(self, [low, high]: [__m512d; 2], shuffle: &Shuffle) -> __m512d {
        self.0.avx512f._mm512_permutex2var_pd(low, pulp::cast(shuffle.0), high)
    }

    /// A load from memory would have to wait for the store of the eight numbers.
    #[inline(always)]
    fn spread(self, from: __m512d, number: usize) -> __m512d {
        self.0.avx512f._mm512_permutexvar_pd(pulp::cast([number as u64; 8]), from)
    }

    #[inline(always)]
    fn blend(self, bits: u8, a: __m512d, b: __m512d) -> __m512d {
        self.0.avx512f._mm512_mask_blend_pd(bits, a, b)
    }

    #[inline(always)]
    fn plus(self, a: __m512d, b: __m512d) -> __m512d {
        self.0.avx512f._mm512_add_pd(a, b)
    }

    #[inline(always)]
    fn product(self, a: __m512d, b: __m512d) -> __m512d {
        self.0.avx512f._mm512_mul_pd(a, b)
    }
}

#[inline(always)]
fn permuted<const N: usize>(simd: pulp::x86::V4, from: &Columns<f64, N>, permutation: &Permutation) -> __m512d {
    let [low, high] = permutation.blocks;
    let (low, high) = (eight(from, low), eight(from, high));
    simd.avx512f._mm512_permutex2var_pd(pulp::cast(low), pulp::cast(permutation.of), pulp::cast(high))
}

#[inline(always)]
fn eight<const N: usize>(from: &Columns<f64, N>, block: u16) -> [f64; 8] {
    let first = usize::from(block) * 8 % N;
    let mut eight = [0.0; 8];
    eight.copy_from_slice(&from.0[first..first + 8]);
    eight
}
