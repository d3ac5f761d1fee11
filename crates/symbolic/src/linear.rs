//! Exact linear algebra over expressions: determinants and linear systems of the size of a body's equations.
//!
//! Minors are expanded row by row, each formed once and shared: (n + 1) 2^n products and no division but the last. On
//! expressions that beats elimination, whose exact divisions a graph cannot carry out, and it needs no pivots, so the
//! same expressions serve for all values.

use crate::{Decision, Hypotheses, Sym, decide};
use field::Scalar;
use std::fmt;

/// Above this many unknowns the number of minors is out of hand.
pub const LARGEST: usize = 14;

/// Why a linear system was not solved.
#[derive(Clone, Debug, PartialEq)]
pub enum Unsolved {
    /// The determinant vanishes identically.
    Singular,
    /// The matrix and the right side do not fit together, or are larger than [`LARGEST`].
    Shape { rows: usize, columns: usize, right: usize },
    /// Whether the determinant vanishes was not decided, for this reason.
    Undecided(String),
}

impl fmt::Display for Unsolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unsolved::Singular => write!(f, "the determinant vanishes identically"),
            Unsolved::Shape { rows, columns, right } => {
                write!(f, "a {rows} x {columns} matrix with {right} right sides; wanted square, at most {LARGEST}")
            }
            Unsolved::Undecided(reason) => write!(f, "whether the determinant vanishes is undecided: {reason}"),
        }
    }
}

impl std::error::Error for Unsolved {}

/// x = numerators / determinant.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    pub numerators: Vec<Sym>,
    pub determinant: Sym,
}

impl Solution {
    /// The unknowns.
    pub fn values(&self) -> Vec<Sym> {
        self.numerators.iter().map(|&numerator| numerator / self.determinant).collect()
    }
}

/// The determinant of a square matrix given by its rows; `None` for another shape or above [`LARGEST`].
pub fn determinant<S: Scalar, Row: AsRef<[S]>>(rows: &[Row]) -> Option<S> {
    let size = rows.len();
    let square = size <= LARGEST && rows.iter().all(|row| row.as_ref().len() == size);
    square.then(|| minors(size, |row, column| rows[row].as_ref()[column], size)[(1 << size) - 1])
}

/// The solution of matrix * x = right by Cramer's rule.
///
/// # Errors
/// [`Unsolved`] where the shapes do not fit or the determinant vanishes under the hypotheses.
pub fn solve<Row: AsRef<[Sym]>>(matrix: &[Row], right: &[Sym], hypotheses: &Hypotheses) -> Result<Solution, Unsolved> {
    let size = matrix.len();
    if let Some(columns) = matrix.iter().map(|row| row.as_ref().len()).find(|&columns| columns != size) {
        return Err(Unsolved::Shape { rows: size, columns, right: right.len() });
    }
    if right.len() != size || size > LARGEST {
        return Err(Unsolved::Shape { rows: size, columns: size, right: right.len() });
    }
    let entry = |row: usize, column: usize| matrix[row].as_ref().get(column).copied().unwrap_or(right[row]);
    let minors = minors(size, entry, size + 1);
    let all = (1 << (size + 1)) - 1;
    let determinant = minors[all & !(1 << size)];
    match decide(determinant, hypotheses) {
        Decision::Zero(_) => return Err(Unsolved::Singular),
        Decision::NonZero(_) => {}
        undecided => return Err(Unsolved::Undecided(undecided.to_string())),
    }
    // The minor without column i has the right side last; moving it to place i takes size - 1 - i exchanges.
    let numerator = |i: usize| {
        let minor = minors[all & !(1 << i)];
        if (size - 1 - i).is_multiple_of(2) { minor } else { -minor }
    };
    Ok(Solution { numerators: (0..size).map(numerator).collect(), determinant })
}

/// For every set of columns, as bits, the minor of these columns and as many last rows.
fn minors<S: Scalar>(rows: usize, entry: impl Fn(usize, usize) -> S, columns: usize) -> Vec<S> {
    let mut minors = vec![S::one(); 1 << columns];
    for set in 1usize..1 << columns {
        let size = set.count_ones() as usize;
        if size > rows {
            continue;
        }
        // Expansion by the first of these rows, with alternating signs.
        let mut sum = S::zero();
        for (place, column) in (0..columns).filter(|column| set >> column & 1 == 1).enumerate() {
            let factor = entry(rows - size, column);
            if !factor.is_zero() {
                let term = factor * minors[set & !(1 << column)];
                if place.is_multiple_of(2) { sum += term } else { sum -= term }
            }
        }
        minors[set] = sum;
    }
    minors
}
