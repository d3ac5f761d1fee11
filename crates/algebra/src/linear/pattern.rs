//! The sparsity pattern of a square matrix.

use super::order::Order;
use std::sync::Arc;

/// The positions of the entries of a square matrix, and its elimination order.
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern {
    size: usize,
    /// The number of unknowns, the first ones, that must be determined.
    determined: usize,
    places: Vec<(usize, usize)>,
    order: Arc<Order>,
}

impl Pattern {
    /// The pattern of a matrix with `size` rows and columns and entries at the given (row, column), each once.
    pub fn new(size: usize, determined: usize, places: Vec<(usize, usize)>) -> Self {
        let order = Arc::new(Order::of(size, &places));
        Pattern { size, determined, places, order }
    }

    /// The number of unknowns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The number of unknowns, the first ones, that must be determined. The others may be free, and are then zero.
    pub fn determined(&self) -> usize {
        self.determined
    }

    /// The row and the column of each entry.
    pub fn places(&self) -> &[(usize, usize)] {
        &self.places
    }

    /// The number of multiplications of an elimination in the order of the pattern.
    pub fn work(&self) -> usize {
        self.order.work()
    }

    pub(super) fn order(&self) -> &Arc<Order> {
        &self.order
    }
}
