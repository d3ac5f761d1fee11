//! Which rows a column can have something in, whatever the numbers are.

use crate::recurrence::small::law::{Law, Solved};

/// A bit for each row.
pub(super) type RowSet = u32;

/// The rows of the columns of the law's matrices: of what is known, and of what stands in them at a point.
pub(super) struct Pattern {
    pub linear: Vec<RowSet>,
    pub weights: Vec<RowSet>,
    pub jacobian: Vec<RowSet>,
    pub gains: Vec<RowSet>,
}

impl Pattern {
    pub fn new(law: &Law, solved_by: &[(RowSet, RowSet)]) -> Self {
        let mut linear = vec![0; law.quantities()];
        law.rates.linear.iter().for_each(|&(row, column, _)| linear[column] |= 1 << row);
        (law.moving..law.quantities()).for_each(|quantity| linear[quantity] |= 1 << quantity);
        let mut weights = vec![0; law.products.len()];
        law.rates.quadratic.iter().for_each(|&(row, product, _)| weights[product] |= 1 << row);
        // a product counts in the columns of both factors, what is solved for in those of all it is solved by
        let mut columns = linear.clone();
        for (factors, rows) in law.products.iter().zip(&weights) {
            factors.iter().for_each(|&factor| columns[factor] |= rows);
        }
        let (moving, solved) = columns.split_at(law.moving);
        let (mut jacobian, mut gains) = (moving.to_vec(), weights.clone());
        for ((quantities, products), rows) in solved_by.iter().zip(solved) {
            members(*quantities).for_each(|quantity| jacobian[quantity] |= rows);
            members(*products).for_each(|product| gains[product] |= rows);
        }
        Pattern { linear, weights, jacobian, gains }
    }
}

/// For all that is solved for: by what of all that moves, and by which products.
pub(super) fn solved_by(law: &Law) -> Vec<(RowSet, RowSet)> {
    let mut by: Vec<(RowSet, RowSet)> = Vec::new();
    for solved in &law.solved {
        let quantity = |of: usize| of.checked_sub(law.moving).map_or((1 << of, 0), |number| by[number]);
        let own = match solved {
            Solved::Sum { linear, products, .. } => {
                let factors = products.iter().flat_map(|&(product, _)| law.products[product]).map(quantity);
                let products = products.iter().map(|&(product, _)| (0, 1 << product));
                linear.iter().map(|&(of, _)| quantity(of)).chain(factors).chain(products).collect()
            }
            Solved::Reciprocal { of, product } | Solved::Root { of, product } => vec![quantity(*of), (0, 1 << product)],
        };
        let own: Vec<(RowSet, RowSet)> = own;
        by.push(own.into_iter().fold((0, 0), |(a, b), (moving, products)| (a | moving, b | products)));
    }
    by
}

/// Their numbers.
pub(super) fn members(set: RowSet) -> impl Iterator<Item = usize> {
    (0..RowSet::BITS as usize).filter(move |member| set >> member & 1 == 1)
}
