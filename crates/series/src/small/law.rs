//! Right-hand sides with few quantities, as sums of these and of products of two of them.

/// A right-hand side with few quantities. Moving quantities have a rate: the states, time, circle points, and sums of
/// these that are factors, whose rates are sums of rates. The solved quantities follow.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Law {
    pub moving: usize,
    /// The number of moving quantities that are sums; they are the last ones.
    pub sums: usize,
    pub solved: Vec<Solved>,
    /// The factors of each product.
    pub products: Vec<[usize; 2]>,
    pub rates: Sums,
    /// The initial values of the moving sums, from the other moving quantities.
    pub starts: Sums,
    /// The number of coefficients.
    pub coefficients: usize,
}

/// Rows, each with a constant, multiples of quantities and multiples of products; coefficients by index.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Sums {
    /// The constants, as (row, coefficient).
    pub constants: Vec<(usize, u32)>,
    /// The linear terms, as (row, quantity, coefficient).
    pub linear: Vec<(usize, usize, u32)>,
    /// The quadratic terms, as (row, product, coefficient).
    pub quadratic: Vec<(usize, usize, u32)>,
}

/// A quantity without a rate, computed from preceding quantities.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Solved {
    /// The sum constant + sum c x + sum c a b, as indices: (quantity, coefficient) and (product, coefficient).
    Sum { constant: Option<u32>, linear: Vec<(usize, u32)>, products: Vec<(usize, u32)> },
    /// The quotient q with q of = above, or 1 for `None`; q of is a product with its own index.
    Quotient { above: Option<usize>, of: usize, product: usize },
    /// The nonnegative root r with r r = of.
    Root { of: usize, product: usize },
}

impl Law {
    /// The indices of the moving sums.
    pub fn sums(&self) -> impl Iterator<Item = usize> {
        self.moving - self.sums..self.moving
    }

    /// The number of quantities.
    pub fn quantities(&self) -> usize {
        self.moving + self.solved.len()
    }
}
