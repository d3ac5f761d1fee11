//! Gathering of numbers from several columns into one group: the factors of products.
//!
//! Gathering would dominate the cost of an order: loading eight numbers one by one costs as much as all sums. Where the
//! processor can permute registers, two registers hold sixteen columns, and a permutation is one instruction.

use super::fused::Fused;
use super::order::add;
use super::stored::Stored;

/// The numbers of one order, by column.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Columns<S, const N: usize>(pub [S; N]);

/// A selection of W columns, in two representations.
#[derive(Clone, Debug)]
pub(crate) struct Selection<const W: usize> {
    columns: [u16; W],
    #[cfg(target_arch = "x86_64")]
    pub(super) by_blocks: super::permuting::ByBlocks,
}

impl<const W: usize> Selection<W> {
    pub fn new(columns: [u16; W]) -> Self {
        Selection {
            columns,
            #[cfg(target_arch = "x86_64")]
            by_blocks: super::permuting::ByBlocks::new(&columns),
        }
    }
}

/// An implementation of gathering and of adding products.
///
/// Functions on eight numbers use loops: a closure is compiled for a generic processor before it is inlined, and a long
/// one would call each instruction.
pub(crate) trait Pick<S: Fused>: Copy {
    /// Whether a product and a sum are rounded once.
    const FUSED: bool;

    fn pick<const W: usize, const N: usize>(self, from: &Columns<S, N>, selection: &Selection<W>) -> [S; W];

    /// Eight numbers in one register, if there is such a register.
    type Eight: Copy;

    fn load(self, from: &S::Stored) -> Self::Eight;

    fn store(self, eight: Self::Eight) -> S::Stored;

    /// A number in all places.
    fn all(self, number: S) -> Self::Eight;

    /// sum + a b.
    fn plus_product(self, sum: Self::Eight, a: Self::Eight, b: Self::Eight) -> Self::Eight;
}

/// Gathers numbers one by one.
#[derive(Clone, Copy)]
pub(crate) struct OneByOne<const FUSED: bool>;

impl<S: Fused, const FUSED: bool> Pick<S> for OneByOne<FUSED> {
    const FUSED: bool = FUSED;
    type Eight = [S; 8];

    #[inline(always)]
    fn pick<const W: usize, const N: usize>(self, from: &Columns<S, N>, selection: &Selection<W>) -> [S; W] {
        let mut picked = [S::zero(); W];
        for (lane, column) in picked.iter_mut().zip(&selection.columns) {
            *lane = from.0[usize::from(*column) % N];
        }
        picked
    }

    #[inline(always)]
    fn load(self, from: &S::Stored) -> [S; 8] {
        std::array::from_fn(|lane| from.lane(lane))
    }

    #[inline(always)]
    fn store(self, eight: [S; 8]) -> S::Stored {
        S::Stored::of(eight)
    }

    #[inline(always)]
    fn all(self, number: S) -> [S; 8] {
        [number; 8]
    }

    #[inline(always)]
    fn plus_product(self, sum: [S; 8], a: [S; 8], b: [S; 8]) -> [S; 8] {
        add::<Self, S, 8>(sum, a, b)
    }
}
