//! Right-hand sides of few quantities, as sums of these and of products of two of them.

/// A right-hand side of few quantities. Moving quantities are the states, time, circle points, and the sums of
/// these that are factors: a sum has the rates of its parts, and no order waits for it. After them come the solved
/// quantities.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Law {
    pub moving: usize,
    /// The number of moving quantities that are sums, the last ones.
    pub sums: usize,
    pub solved: Vec<Solved>,
    /// The factors of each product.
    pub products: Vec<[usize; 2]>,
    pub rates: Sums,
    /// The first coefficients of the sums that move, from the other moving quantities.
    pub starts: Sums,
    /// The number of coefficients.
    pub coefficients: usize,
}

/// Rows, each a constant, multiples of quantities, and multiples of products; coefficients by their number.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Sums {
    /// row, coefficient
    pub constants: Vec<(usize, u32)>,
    /// row, quantity, coefficient
    pub linear: Vec<(usize, usize, u32)>,
    /// row, product, coefficient
    pub quadratic: Vec<(usize, usize, u32)>,
}

/// A quantity without a rate, by quantities before it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Solved {
    /// constant + sum c x + sum c a b; coefficients by number, quantities and products with theirs.
    Sum { constant: Option<u32>, linear: Vec<(usize, u32)>, products: Vec<(usize, u32)> },
    /// q of = above, or one, which is a product with its number.
    Quotient { above: Option<usize>, of: usize, product: usize },
    /// r r = of, not negative.
    Root { of: usize, product: usize },
}

impl Law {
    /// The sums among the moving quantities, the last of these.
    pub fn sums(&self) -> impl Iterator<Item = usize> {
        self.moving - self.sums..self.moving
    }

    /// The number of quantities.
    pub fn quantities(&self) -> usize {
        self.moving + self.solved.len()
    }
}
