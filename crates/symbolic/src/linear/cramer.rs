//! Symbolic solution of linear systems by Cramer's rule.

use crate::{Decision, Hypotheses, Sym, decide, differs_from_zero};
use algebra::linear::{LARGEST, minors};
use std::fmt;

/// The reason why a linear system was not solved.
#[derive(Clone, Debug, PartialEq)]
pub enum Unsolved {
    /// The determinant vanishes identically.
    Singular,
    /// The matrix is not square, does not match the right side, or is larger than [`LARGEST`].
    Shape { rows: usize, columns: usize, right: usize },
    /// It was not decided whether the determinant vanishes; the text gives the reason.
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

/// The solution x = numerators / determinant of a linear system.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The numerator of each unknown.
    pub numerators: Vec<Sym>,
    /// The determinant of the matrix.
    pub determinant: Sym,
}

impl Solution {
    /// Returns the values of the unknowns.
    pub fn values(&self) -> Vec<Sym> {
        self.numerators.iter().map(|&numerator| numerator / self.determinant).collect()
    }
}

/// Solves matrix * x = right by Cramer's rule, for a square matrix of at most [`LARGEST`] rows.
///
/// # Errors
/// [`Unsolved`] if the shapes do not match, or if the determinant vanishes under the hypotheses or cannot be decided.
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
        // no exact point shows that exponentials do not vanish
        Decision::GaveUp(_) if hypotheses.is_none() && differs_from_zero(determinant) => {}
        undecided => return Err(Unsolved::Undecided(undecided.to_string())),
    }
    // The minor without column i has the right side as its last column; size - 1 - i exchanges move it to position i.
    let numerator = |i: usize| {
        let minor = minors[all & !(1 << i)];
        if (size - 1 - i).is_multiple_of(2) { minor } else { -minor }
    };
    Ok(Solution { numerators: (0..size).map(numerator).collect(), determinant })
}
