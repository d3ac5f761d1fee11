//! Taking numbers from several columns into one group: the factors of the products.
//!
//! Of all that is done for one order this would take longest: loading eight numbers one by one costs as much as all sums.
//! Where the processor permutes whole registers, two of them hold sixteen columns, and a permutation is one instruction.

use field::Scalar;

/// The numbers of one order, by column.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(super) struct Columns<S, const N: usize>(pub [S; N]);

/// W columns to be taken, in two ways of writing.
#[derive(Clone, Debug)]
pub(super) struct Selection<const W: usize> {
    columns: [u16; W],
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    first: Permutation,
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    more: Vec<Permutation>,
}

/// What is taken from two blocks of eight columns.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
struct Permutation {
    blocks: [u16; 2],
    /// For each place of the group the number from 0 to 15.
    of: [u64; 8],
    /// The places that these blocks fill.
    filled: u8,
}

impl<const W: usize> Selection<W> {
    pub fn new(columns: [u16; W]) -> Self {
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
        Selection { columns, first: pairs.next().unwrap_or(nothing), more: pairs.collect() }
    }
}

/// A way of taking, and of adding products.
pub(super) trait Pick<S>: Copy {
    /// Whether a product and a sum are rounded once.
    const FUSED: bool;

    fn pick<const W: usize, const N: usize>(self, from: &Columns<S, N>, selection: &Selection<W>) -> [S; W];
}

/// One by one.
#[derive(Clone, Copy)]
pub(super) struct OneByOne<const FUSED: bool>;

impl<S: Scalar, const FUSED: bool> Pick<S> for OneByOne<FUSED> {
    const FUSED: bool = FUSED;

    #[inline(always)]
    fn pick<const W: usize, const N: usize>(self, from: &Columns<S, N>, selection: &Selection<W>) -> [S; W] {
        let mut picked = [S::zero(); W];
        for (lane, column) in picked.iter_mut().zip(&selection.columns) {
            *lane = from.0[usize::from(*column) % N];
        }
        picked
    }
}

/// By permutations of registers of eight.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
pub(super) struct Permuting(pub pulp::x86::V4);

#[cfg(target_arch = "x86_64")]
impl Pick<f64> for Permuting {
    const FUSED: bool = true;

    #[inline(always)]
    fn pick<const W: usize, const N: usize>(self, from: &Columns<f64, N>, selection: &Selection<W>) -> [f64; W] {
        let mut picked = permuted(self.0, from, &selection.first);
        for permutation in &selection.more {
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
}

#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn permuted<const N: usize>(
    simd: pulp::x86::V4,
    from: &Columns<f64, N>,
    permutation: &Permutation,
) -> std::arch::x86_64::__m512d {
    let [low, high] = permutation.blocks;
    let (low, high) = (eight(from, low), eight(from, high));
    simd.avx512f._mm512_permutex2var_pd(pulp::cast(low), pulp::cast(permutation.of), pulp::cast(high))
}

#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn eight<const N: usize>(from: &Columns<f64, N>, block: u16) -> [f64; 8] {
    let first = usize::from(block) * 8 % N;
    let mut eight = [0.0; 8];
    eight.copy_from_slice(&from.0[first..first + 8]);
    eight
}
