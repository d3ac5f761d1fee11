//! The pattern of a square matrix.

use super::order::Order;
use std::sync::Arc;

/// The places of the entries of a square matrix, and the order in which it is eliminated.
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern {
    size: usize,
    /// The number of the first unknowns that must be determined.
    determined: usize,
    places: Vec<(usize, usize)>,
    order: Arc<Order>,
}

impl Pattern {
    /// The pattern of a matrix of so many rows and columns with entries at these places, each once.
    pub fn new(size: usize, determined: usize, places: Vec<(usize, usize)>) -> Self {
        let order = Arc::new(Order::of(size, &places));
        Pattern { size, determined, places, order }
    }

    /// The number of unknowns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The number of the first unknowns that must be determined; the others may be free, and are then zero.
    pub fn determined(&self) -> usize {
        self.determined
    }

    /// Row and column of each entry.
    pub fn places(&self) -> &[(usize, usize)] {
        &self.places
    }

    /// The multiplications of one elimination in the order of the pattern.
    pub fn work(&self) -> usize {
        self.order.work()
    }

    pub(super) fn order(&self) -> &Arc<Order> {
        &self.order
    }
}
