//! Elimination of the solved quantities from the derivatives of the rates, by substitution of their rows.

use super::matrix::Matrix;
use crate::fused::Fused;
use crate::small::law::Law;
use crate::small::permutation::Permute;
use crate::small::solving::{Row, Set};
use crate::small::wide::Wide;

/// The columns that change in the elimination.
#[derive(Clone, Debug)]
pub(super) struct Elimination {
    /// The number of columns of moving quantities.
    moving: usize,
    quantities: Vec<Put>,
    products: Vec<Put>,
}

/// A column, and the indices of the solved quantities that are substituted into it.
#[derive(Clone, Debug)]
struct Put {
    column: usize,
    solved: Vec<usize>,
}

impl Elimination {
    /// The elimination, from the sets of quantities and products that each solved quantity depends on.
    pub fn new(law: &Law, by: &[(Set, Set)]) -> Self {
        let puts = |sets: Vec<Set>, columns: usize| {
            let put = |column: usize| {
                let solved = (0..sets.len()).filter(|number| sets[*number] >> column & 1 == 1).collect();
                Put { column, solved }
            };
            (0..columns).map(put).filter(|put| !put.solved.is_empty()).collect()
        };
        Elimination {
            moving: law.moving,
            quantities: puts(by.iter().map(|(quantities, _)| *quantities).collect(), law.moving),
            products: puts(by.iter().map(|(_, products)| *products).collect(), law.products.len()),
        }
    }

    /// Eliminates in J, including the columns of the solved quantities, and in W.
    #[inline(always)]
    pub fn run<S: Fused, P: Permute<f64>, const B: usize, const G: usize>(
        &self,
        pick: P,
        rows: &[Row<S, B, G>],
        jacobian: &mut Matrix<B, B>,
        weights: &Matrix<B, G>,
        gains: &mut Matrix<B, G>,
    ) {
        // a solved quantity has the entry 1 in its own row and column: the rows need no further sum
        let (columns, solved) = jacobian.as_flattened_mut().split_at_mut(self.moving);
        for Put { column, solved: by } in &self.quantities {
            let times = |number: usize| rows[number].of_moving(*column).rounded();
            columns[*column] = plus(pick, columns[*column], by.iter().map(|&number| (times(number), &solved[number])));
        }
        let (gains, weights) = (gains.as_flattened_mut(), weights.as_flattened());
        for Put { column, solved: by } in &self.products {
            let times = |number: usize| rows[number].of_product(*column).rounded();
            gains[*column] = plus(pick, weights[*column], by.iter().map(|&number| (times(number), &solved[number])));
        }
        solved[..rows.len()].fill([Wide::zero(); B]);
    }
}

/// A column plus multiples of other columns.
#[inline(always)]
fn plus<'a, P: Permute<f64>, const B: usize>(
    pick: P,
    mut column: [Wide<f64>; B],
    others: impl Iterator<Item = (f64, &'a [Wide<f64>; B])>,
) -> [Wide<f64>; B] {
    for (times, other) in others {
        for group in 0..B {
            column[group] = column[group].plus(pick, &other[group], times);
        }
    }
    column
}
