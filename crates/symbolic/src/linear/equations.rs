//! Linear equations that are solved in numbers at each evaluation:
//!
//!   A(x) z = b(x) .
//!
//! A symbolic elimination grows with the third power of the unknowns, and its pivots cannot be chosen. Here only the entries
//! are expressions; they are evaluated, and A is factored as numbers ([`algebra::linear::Factors`]).

use crate::Sym;
use algebra::linear::Pattern;

/// Linear equations over expressions.
#[derive(Clone, Debug)]
pub struct Solve {
    /// The symbols of the unknowns z.
    pub unknowns: Vec<Sym>,
    /// The pattern of A, by row and column.
    pub pattern: Pattern,
    /// The entries, in the order of the pattern.
    pub entries: Vec<Sym>,
    /// b.
    pub right: Vec<Sym>,
}

impl Solve {
    /// Equations whose first unknowns must be determined; the others, such as multipliers of constraints that follow from
    /// others, are zero where the equations leave them free.
    ///
    /// `entry` gives the entry in a row and a column; those that are the constant zero are left out.
    pub fn new(unknowns: Vec<Sym>, determined: usize, entry: impl Fn(usize, usize) -> Sym, right: Vec<Sym>) -> Self {
        let size = unknowns.len();
        let places = (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
        let (places, entries): (Vec<_>, Vec<_>) =
            places.map(|(row, column)| ((row, column), entry(row, column))).filter(|(_, is)| *is != Sym::ZERO).unzip();
        Solve { unknowns, pattern: Pattern::new(size, determined, places), entries, right }
    }

    /// All expressions: the entries, then b.
    pub fn expressions(&self) -> Vec<Sym> {
        [&self.entries[..], &self.right].concat()
    }
}
