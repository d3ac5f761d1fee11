//! First coefficients of a series: states, time and circle points are given, moving sums are computed.

use super::law::Law;
use super::wide_sums::WideSums;
use crate::fused::Fused;
use crate::small::permutation::Permute;
use crate::stored::Stored;

/// The moving sums among B groups of eight quantities.
#[derive(Clone, Debug)]
pub(super) struct Starts<S: Fused, const B: usize> {
    sums: WideSums<S, B, 0>,
    /// The places of the sums, as bits.
    lanes: [u8; B],
}

impl<S: Fused, const B: usize> Starts<S, B> {
    pub fn new(law: &Law) -> Self {
        let mut lanes = [0; B];
        law.sums().for_each(|quantity| lanes[quantity / 8] |= 1 << (quantity % 8));
        Starts { sums: WideSums::new(&law.starts), lanes }
    }

    pub fn set(&mut self, law: &Law, value: impl Fn(u32) -> S) {
        self.sums.set(&law.starts, value);
    }

    /// y_0, from the given first coefficients in `rows`.
    #[inline(always)]
    pub fn begin<P: Permute<S>>(&mut self, pick: P, rows: &[[S; 8]]) -> [P::Eight; B] {
        let mut given = [pick.all(S::zero()); B];
        for (given, eight) in given.iter_mut().zip(rows) {
            *given = pick.load(&S::Stored::of(*eight));
        }
        if self.lanes == [0; B] {
            return given;
        }
        let mut begin = self.sums.of(pick, &self.sums.constants(pick), &given, &[]);
        for group in 0..B {
            begin[group] = pick.blend(self.lanes[group], given[group], begin[group]);
        }
        begin
    }
}
