//! Sums of quantities and products, c + L y + W m, by columns of eight rows.
//!
//! Each group of eight rows has its own lists of columns: those with something in them. What a column is multiplied by is one
//! number in all places of a register. Few registers of such numbers are permuted; of many the lists would be short and many, so
//! these are written to one place and read from there. What is written is waited for, but a column more costs less.

use super::law::Sums;
use crate::recurrence::fused::Fused;
use crate::recurrence::pick::Pick;
use crate::recurrence::stored::{Stored, Wide};

/// So many groups of quantities and of products stay in registers, each with lists of its own.
const SOURCES: usize = 5;

/// So many there is room for where they are written.
const GROUPS: usize = 8;

/// Four columns, and the numbers they are multiplied by: as many sums run side by side.
#[derive(Clone, Debug)]
#[repr(align(64))]
struct Four<S: Fused> {
    columns: [Wide<S>; 4],
    by: [usize; 4],
}

/// Of B groups of eight quantities and G of products.
#[derive(Clone, Debug)]
pub(super) struct WideSums<S: Fused, const B: usize, const G: usize> {
    constants: [Wide<S>; B],
    /// By the quantity itself: all decays are one product.
    own: [Wide<S>; B],
    lists: [[Vec<Four<S>>; SOURCES]; B],
    /// The numbers of one order, where they do not stay in registers.
    written: Written<S>,
}

#[derive(Clone, Debug)]
#[repr(align(64))]
struct Written<S: Fused>([S::Stored; GROUPS]);

/// A term off the diagonal: of a row in a group, the place of what it is multiplied by, the coefficient's number.
struct Term {
    row: usize,
    source: usize,
    by: usize,
    number: u32,
}

impl<S: Fused, const B: usize, const G: usize> WideSums<S, B, G> {
    /// A finer field has twice as many numbers to permute.
    const IN_REGISTERS: bool = !S::FINER && B <= 2;

    /// Room for the coefficients.
    pub fn new(sums: &Sums) -> Self {
        const { assert!(B + G <= GROUPS && (B > 2 || B + G <= SOURCES)) };
        let list = |group: usize, source: usize| -> Vec<Four<S>> {
            let own = terms::<S, B, G>(sums).filter(|term| term.row / 8 == group && term.source == source);
            let mut by: Vec<usize> = own.map(|term| term.by).collect();
            by.sort_unstable();
            by.dedup();
            // the columns that fill up the last four are zero
            let four = |by: &[usize]| Four {
                columns: [Wide::zero(); 4],
                by: std::array::from_fn(|place| by.get(place).copied().unwrap_or(by[0])),
            };
            by.chunks(4).map(four).collect()
        };
        WideSums {
            constants: [Wide::zero(); B],
            own: [Wide::zero(); B],
            lists: std::array::from_fn(|group| std::array::from_fn(|source| list(group, source))),
            written: Written([S::Stored::of([S::zero(); 8]); GROUPS]),
        }
    }

    /// Takes the values of the coefficients.
    pub fn set(&mut self, sums: &Sums, value: impl Fn(u32) -> S) {
        for &(row, number) in &sums.constants {
            self.constants[row / 8].0.set(row % 8, value(number));
        }
        for &(row, _, number) in sums.linear.iter().filter(|(row, column, _)| row == column) {
            self.own[row / 8].0.set(row % 8, value(number));
        }
        for Term { row, source, by, number } in terms::<S, B, G>(sums) {
            let fours = self.lists[row / 8][source].iter_mut();
            let mut places = fours.flat_map(|four| four.by.iter().zip(&mut four.columns));
            if let Some((_, column)) = places.find(|(own, _)| **own == by) {
                column.0.set(row % 8, value(number));
            }
        }
    }

    /// c, of order 0 alone.
    #[inline(always)]
    pub fn constants<P: Pick<S>>(&self, pick: P) -> [P::Eight; B] {
        let mut constants = [pick.all(S::zero()); B];
        for (constant, own) in constants.iter_mut().zip(&self.constants) {
            *constant = pick.load(&own.0);
        }
        constants
    }

    /// start + L y + W m
    #[inline(always)]
    pub fn of<P: Pick<S>>(
        &mut self,
        pick: P,
        start: &[P::Eight; B],
        y: &[P::Eight; B],
        m: &[P::Eight; G],
    ) -> [P::Eight; B] {
        if !Self::IN_REGISTERS {
            for (written, eight) in self.written.0.iter_mut().zip(y.iter().chain(m)) {
                *written = pick.store(*eight);
            }
        }
        let nothing = pick.all(S::zero());
        let mut all = *start;
        for group in 0..B {
            let mut sums = [pick.product(y[group], pick.load(&self.own[group].0)), start[group], nothing, nothing];
            if Self::IN_REGISTERS {
                let (by_quantities, by_products) = self.lists[group].split_at(B);
                for (list, &eight) in by_quantities.iter().zip(y) {
                    add(pick, &mut sums, list, |by| pick.spread(eight, by));
                }
                for (list, &eight) in by_products.iter().zip(m) {
                    add(pick, &mut sums, list, |by| pick.spread(eight, by));
                }
            } else {
                add(pick, &mut sums, &self.lists[group][0], |by| pick.one_of(&self.written.0, by));
            }
            all[group] = pick.plus(pick.plus(sums[0], sums[1]), pick.plus(sums[2], sums[3]));
        }
        all
    }
}

/// Adds the columns of a list, each times its number.
#[inline(always)]
fn add<S: Fused, P: Pick<S>>(pick: P, sums: &mut [P::Eight; 4], list: &[Four<S>], spread: impl Fn(usize) -> P::Eight) {
    for four in list {
        for (sum, (column, &by)) in sums.iter_mut().zip(four.columns.iter().zip(&four.by)) {
            *sum = pick.plus_product(*sum, pick.load(&column.0), spread(by));
        }
    }
}

fn terms<S: Fused, const B: usize, const G: usize>(sums: &Sums) -> impl Iterator<Item = Term> {
    let linear = sums.linear.iter().filter(|(row, column, _)| row != column).copied();
    let quadratic = sums.quadratic.iter().map(|&(row, product, number)| (row, 8 * B + product, number));
    linear.chain(quadratic).map(|(row, place, number)| {
        let (source, by) = if WideSums::<S, B, G>::IN_REGISTERS { (place / 8, place % 8) } else { (0, place) };
        Term { row, source, by, number }
    })
}
