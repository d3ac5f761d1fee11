//! Small matrices in registers of eight rows.

use crate::small::permutation::Permute;
use crate::small::solving::Set;
use crate::small::wide::Wide;

/// Columns in C groups of eight, each over B groups of rows.
pub(super) type Matrix<const B: usize, const C: usize> = [[[Wide<f64>; B]; 8]; C];

/// The nonzero columns in groups of four: a bit for each group that is nonzero in a group of rows, and for each that is
/// nonzero at all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fours<const B: usize> {
    pub groups: [u8; B],
    pub any: u8,
}

impl<const B: usize> Fours<B> {
    pub(super) fn new(columns: &[Set]) -> Self {
        let groups = std::array::from_fn(|group| {
            let counts = |four: &[Set]| four.iter().any(|rows| rows >> (8 * group) & 0xff != 0);
            columns.chunks(4).enumerate().fold(0, |bits, (number, four)| bits | u8::from(counts(four)) << number)
        });
        Fours { groups, any: groups.iter().fold(0, |any, group| any | group) }
    }
}

/// The product sum_c matrix_c x_c over the nonzero columns.
#[inline(always)]
pub(super) fn times<P: Permute<f64>, const B: usize, const C: usize>(
    pick: P,
    matrix: &Matrix<B, C>,
    x: &[P::Eight; C],
    fours: &Fours<B>,
) -> [P::Eight; B] {
    let mut sums = [[pick.all(0.0); B]; 4];
    // unrolled by hand: the compiler would not unroll loops, and would keep the sums in memory
    four::<P, B, C, 0>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 1>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 2>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 3>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 4>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 5>(pick, &mut sums, matrix, x, fours);
    let [mut a, b, c, d] = sums;
    for group in 0..B {
        a[group] = pick.plus(pick.plus(a[group], b[group]), pick.plus(c[group], d[group]));
    }
    a
}

/// Adds four columns where they are nonzero.
#[inline(always)]
fn four<P: Permute<f64>, const B: usize, const C: usize, const FOUR: usize>(
    pick: P,
    sums: &mut [[P::Eight; B]; 4],
    matrix: &Matrix<B, C>,
    x: &[P::Eight; C],
    fours: &Fours<B>,
) {
    if FOUR >= 2 * C || fours.any >> FOUR & 1 == 0 {
        return;
    }
    let (columns, x, first) = (&matrix[FOUR / 2 % C], x[FOUR / 2 % C], FOUR % 2 * 4);
    let mut spread = [x; 4];
    for (chain, spread) in spread.iter_mut().enumerate() {
        *spread = pick.spread(x, first + chain);
    }
    let four = &columns[first..first + 4];
    rows::<P, B, FOUR, 0>(pick, sums, four, &spread, fours);
    rows::<P, B, FOUR, 1>(pick, sums, four, &spread, fours);
    rows::<P, B, FOUR, 2>(pick, sums, four, &spread, fours);
}

/// Adds the rows of one group.
#[inline(always)]
fn rows<P: Permute<f64>, const B: usize, const FOUR: usize, const GROUP: usize>(
    pick: P,
    sums: &mut [[P::Eight; B]; 4],
    columns: &[[Wide<f64>; B]],
    x: &[P::Eight; 4],
    fours: &Fours<B>,
) {
    if GROUP < B && fours.groups[GROUP % B] >> FOUR & 1 == 1 {
        for ((sum, own), x) in sums.iter_mut().zip(columns).zip(x) {
            sum[GROUP % B] = pick.plus_product(sum[GROUP % B], pick.load(&own[GROUP % B].0), *x);
        }
    }
}
