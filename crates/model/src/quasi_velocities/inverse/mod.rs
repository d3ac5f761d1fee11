//! Symbolic solution of A x = b, with divisors that vanish only where A is singular.
//!
//! Constant pivots are eliminated first, in any position. The rest is brought to block triangular form; each block determines its unknowns
//! from earlier ones: x = adj(B) b/det(B). The divisors are the determinants of the blocks; their product is det A up
//! to a constant factor. For a block that is too large for its minors, the divisors are the pivots of an elimination.

mod blocks;
mod cofactors;

use crate::equations::{generic_pivots, solved_in_short};
use symbolic::Sym;

/// The largest number of rows of a block that is solved by minors.
const MOST_ROWS: usize = 7;

/// The unknowns by rows, and their divisors.
pub(super) struct Solution {
    pub unknowns: Vec<Vec<Sym>>,
    /// The determinants of blocks that are not constant.
    pub divisors: Vec<Sym>,
}

/// Simplification of expressions, and recognition of nonzero constants.
pub(super) trait Reading {
    fn read(&mut self, expression: Sym) -> Sym;

    fn is_constant(&self, expression: Sym) -> bool;
}

/// (row, column) of a pivot.
type Pivot = (usize, usize);

/// Solves A x = b for every column of b. A must be square, and regular at a generic point.
pub(super) fn solved(matrix: Vec<Vec<Sym>>, right: Vec<Vec<Sym>>, reading: &mut impl Reading) -> Solution {
    let mut tables = Tables { matrix, right };
    let n = tables.matrix.len();
    let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..n).collect(), (0..n).collect());
    let mut constant: Vec<Pivot> = Vec::new();
    while let Some((row, column)) = tables.constant_pivot(&rows, &columns, reading) {
        rows.retain(|other| *other != row);
        columns.retain(|other| *other != column);
        for &below in &rows {
            tables.eliminate((row, column), below, reading);
        }
        constant.push((row, column));
    }
    let width = tables.right.first().map_or(0, Vec::len);
    let (mut unknowns, mut divisors) = (vec![Vec::new(); n], Vec::new());
    let mut known: Vec<usize> = Vec::new();
    for block in blocks::of(&tables.matrix, &rows, &columns) {
        let (own, places): (Vec<usize>, Vec<usize>) = block.into_iter().unzip();
        let left = own.iter().map(|&row| tables.remaining(row, &known, &unknowns, reading)).collect::<Vec<_>>();
        let square = own.iter().map(|&row| places.iter().map(|&column| tables.matrix[row][column]).collect());
        let square: Vec<Vec<Sym>> = square.collect();
        if square.len() > MOST_ROWS {
            let (order, found, pivots) = eliminated(square, left);
            order.into_iter().zip(found).for_each(|(place, found)| unknowns[places[place]] = found);
            divisors.extend(pivots.into_iter().filter(|pivot| !reading.is_constant(*pivot)));
        } else {
            let (adjugate, determinant) = cofactors::of(&square, reading);
            if !reading.is_constant(determinant) {
                divisors.push(determinant);
            }
            for (&column, cofactors) in places.iter().zip(&adjugate) {
                let sum = |at: usize| {
                    let terms = cofactors.iter().zip(&left);
                    terms.fold(Sym::ZERO, |sum, (&cofactor, left)| sum + cofactor * left[at])
                };
                unknowns[column] = (0..width).map(|at| reading.read(sum(at) / determinant)).collect();
            }
        }
        known.extend(places);
    }
    for (row, column) in constant.into_iter().rev() {
        let left = tables.remaining(row, &known, &unknowns, reading);
        let pivot = tables.matrix[row][column];
        unknowns[column] = left.into_iter().map(|left| reading.read(left / pivot)).collect();
        known.push(column);
    }
    Solution { unknowns, divisors }
}

/// Gaussian elimination with pivots that are generically nonzero. Returns the order of the unknowns, the unknowns, and the pivots.
fn eliminated(square: Vec<Vec<Sym>>, right: Vec<Vec<Sym>>) -> (Vec<usize>, Vec<Vec<Sym>>, Vec<Sym>) {
    let found = generic_pivots(&square, &(0..square.len()).collect::<Vec<_>>());
    let order: Vec<usize> = found.into_iter().map(|(_, column)| column).collect();
    let square = square.iter().map(|row| order.iter().map(|&column| row[column]).collect()).collect();
    let (unknowns, pivots) = solved_in_short(square, right);
    (order, unknowns, pivots)
}

struct Tables {
    matrix: Vec<Vec<Sym>>,
    right: Vec<Vec<Sym>>,
}

impl Tables {
    /// Returns the constant entry whose row and column have the fewest other nonzero entries.
    fn constant_pivot(&self, rows: &[usize], columns: &[usize], reading: &impl Reading) -> Option<Pivot> {
        let filled = |row: usize, column: usize| self.matrix[row][column] != Sym::ZERO;
        let fill = |&(row, column): &Pivot| {
            let beside = columns.iter().filter(|other| filled(row, **other)).count();
            let below = rows.iter().filter(|other| filled(**other, column)).count();
            (beside - 1) * (below - 1)
        };
        let all = rows.iter().flat_map(|&row| columns.iter().map(move |&column| (row, column)));
        let candidates = all.filter(|&(row, column)| reading.is_constant(self.matrix[row][column]));
        // numbers are preferred to parameters
        candidates.min_by_key(|place| (self.matrix[place.0][place.1].as_constant().is_none(), fill(place)))
    }

    fn eliminate(&mut self, (row, column): Pivot, below: usize, reading: &mut impl Reading) {
        let factor = reading.read(self.matrix[below][column] / self.matrix[row][column]);
        if factor == Sym::ZERO {
            return;
        }
        for table in [&mut self.matrix, &mut self.right] {
            let above = table[row].clone();
            for (entry, above) in table[below].iter_mut().zip(above) {
                if above != Sym::ZERO {
                    *entry = reading.read(*entry - factor * above);
                }
            }
        }
    }

    /// Returns the right side of a row minus the terms of known unknowns.
    fn remaining(&self, row: usize, known: &[usize], unknowns: &[Vec<Sym>], reading: &mut impl Reading) -> Vec<Sym> {
        let mut left = self.right[row].clone();
        for &column in known.iter().filter(|column| self.matrix[row][**column] != Sym::ZERO) {
            for (left, &unknown) in left.iter_mut().zip(&unknowns[column]) {
                *left -= self.matrix[row][column] * unknown;
            }
        }
        left.into_iter().map(|each| reading.read(each)).collect()
    }
}
