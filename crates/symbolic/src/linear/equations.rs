//! Linear equations that are solved numerically at each evaluation:
//!
//!   A(x) z = b(x) .
//!
//! The cost of symbolic elimination grows with the third power of the number of unknowns, without a choice of pivots. Here only the entries
//! are expressions. They are evaluated, and A is factorised numerically ([`algebra::linear::Factors`]).

use crate::Sym;
use algebra::linear::Pattern;

/// Linear equations A z = b whose entries are expressions.
#[derive(Clone, Debug)]
pub struct Solve {
    /// The symbols of the unknowns z, of length n.
    pub unknowns: Vec<Sym>,
    /// The positions (row, column) of the entries of A, n x n.
    pub pattern: Pattern,
    /// The entries of A, in the order of the pattern.
    pub entries: Vec<Sym>,
    /// The right side b, of length n.
    pub right: Vec<Sym>,
}

impl Solve {
    /// Creates equations whose first `determined` unknowns must have unique values. The other unknowns, such as multipliers of redundant
    /// constraints, are set to zero if the equations do not determine them.
    ///
    /// `entry(row, column)` gives the entries of A; entries that are the constant zero are omitted.
    pub fn new(unknowns: Vec<Sym>, determined: usize, entry: impl Fn(usize, usize) -> Sym, right: Vec<Sym>) -> Self {
        let size = unknowns.len();
        let places = (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
        let (places, entries): (Vec<_>, Vec<_>) =
            places.map(|(row, column)| ((row, column), entry(row, column))).filter(|(_, is)| *is != Sym::ZERO).unzip();
        Solve { unknowns, pattern: Pattern::new(size, determined, places), entries, right }
    }

    /// Returns the entries of A in the order of the pattern, then b.
    pub fn expressions(&self) -> Vec<Sym> {
        [&self.entries[..], &self.right].concat()
    }
}
