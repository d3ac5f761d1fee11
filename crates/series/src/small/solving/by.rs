//! The moving quantities and products that each solved quantity depends on.

use crate::small::law::{Law, Solved};

/// A set of indices, as bits.
pub(in crate::small) type Set = u32;

/// For each solved quantity the set of moving quantities, and the set of products, on which it depends.
pub(in crate::small) fn solved_by(law: &Law) -> Vec<(Set, Set)> {
    let mut by: Vec<(Set, Set)> = Vec::new();
    for solved in &law.solved {
        let quantity = |of: usize| of.checked_sub(law.moving).map_or((1 << of, 0), |number| by[number]);
        let own = match solved {
            Solved::Sum { linear, products, .. } => {
                let factors = products.iter().flat_map(|&(product, _)| law.products[product]).map(quantity);
                let products = products.iter().map(|&(product, _)| (0, 1 << product));
                linear.iter().map(|&(of, _)| quantity(of)).chain(factors).chain(products).collect()
            }
            Solved::Quotient { above, of, product } => {
                above.iter().chain([of]).map(|&part| quantity(part)).chain([(0, 1 << product)]).collect()
            }
            Solved::Root { of, product } => vec![quantity(*of), (0, 1 << product)],
        };
        let own: Vec<(Set, Set)> = own;
        by.push(own.into_iter().fold((0, 0), |(a, b), (moving, products)| (a | moving, b | products)));
    }
    by
}

/// The indices in a set.
pub(in crate::small) fn members(set: Set) -> impl Iterator<Item = usize> {
    (0..Set::BITS as usize).filter(move |member| set >> member & 1 == 1)
}
