//! The sparsity pattern of J and W.

use crate::small::law::Law;
use crate::small::solving::{Set, members};

/// The rows with possible entries, as bits, for each column of J and of W.
pub(super) struct Pattern {
    pub jacobian: Vec<Set>,
    pub gains: Vec<Set>,
}

impl Pattern {
    pub fn new(law: &Law, solved_by: &[(Set, Set)]) -> Self {
        let mut columns = vec![0; law.quantities()];
        law.rates.linear.iter().for_each(|&(row, column, _)| columns[column] |= 1 << row);
        (law.moving..law.quantities()).for_each(|quantity| columns[quantity] |= 1 << quantity);
        let mut weights = vec![0; law.products.len()];
        law.rates.quadratic.iter().for_each(|&(row, product, _)| weights[product] |= 1 << row);
        // a product contributes to the columns of both factors, a solved quantity to those of all quantities it depends
        // on
        for (factors, rows) in law.products.iter().zip(&weights) {
            factors.iter().for_each(|&factor| columns[factor] |= rows);
        }
        let (moving, solved) = columns.split_at(law.moving);
        let (mut jacobian, mut gains) = (moving.to_vec(), weights);
        for ((quantities, products), rows) in solved_by.iter().zip(solved) {
            members(*quantities).for_each(|quantity| jacobian[quantity] |= rows);
            members(*products).for_each(|product| gains[product] |= rows);
        }
        Pattern { jacobian, gains }
    }
}
