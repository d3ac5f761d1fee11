//! Reactions and margins of a regime as quotients of polynomials in b and W, by Cramer's rule.
//!
//! Over symbolic expressions the margin of a condition is a numerator divided by the determinant of the regime, whose
//! signs decide. No pivot has to be chosen, so that the rule applies over any scalar type.

use super::dry::Pairs;
use super::{Dry, Form, Mode, equations};
use field::Scalar;

/// The solution of the equations of a regime: the reactions are `numerators / determinant`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cramer<S, const K: usize> {
    /// The determinant of the equations. If it is zero the regime is singular: see [`super::reactions`].
    pub determinant: S,
    pub numerators: Pairs<S, K>,
}

impl<S: Scalar, const K: usize> Cramer<S, K> {
    /// Computes numerators and determinant of a regime.
    pub fn of(dry: &Dry<S, K>, regime: &[Mode; K]) -> Self {
        let rows = equations(dry, regime);
        let size = 2 * K;
        let row = |r: usize| &rows[r / 2][r % 2];
        let determinant_of_all = determinant(size, &|r, c| row(r).row[c / 2][c % 2]);
        let numerator = |column: usize| {
            determinant(size, &|r, c| if c == column { -row(r).constant } else { row(r).row[c / 2][c % 2] })
        };
        let numerators = std::array::from_fn(|k| std::array::from_fn(|i| numerator(2 * k + i)));
        Cramer { determinant: determinant_of_all, numerators }
    }

    /// The reactions lambda.
    pub fn reactions(&self) -> Pairs<S, K> {
        self.numerators.map(|pair| pair.map(|numerator| numerator / self.determinant))
    }

    /// The determinant times the value of a form at the solution.
    pub fn numerator(&self, form: &Form<S, K>) -> S {
        let terms = form.row.as_flattened().iter().zip(self.numerators.as_flattened());
        terms.fold(form.constant * self.determinant, |sum, (a, x)| sum + *a * *x)
    }

    /// The value of a form at the solution.
    pub fn value(&self, form: &Form<S, K>) -> S {
        self.numerator(form) / self.determinant
    }
}

/// Laplace expansion along the rows, without the products of entries that are the constant zero. For small sizes only.
fn determinant<S: Scalar>(size: usize, entry: &impl Fn(usize, usize) -> S) -> S {
    expand(0, size, 0, entry)
}

/// The minor of the rows from `row` on, without the columns in the bit set `used`.
fn expand<S: Scalar>(row: usize, size: usize, used: u32, entry: &impl Fn(usize, usize) -> S) -> S {
    if row == size {
        return S::one();
    }
    let mut sum = S::zero();
    let mut even = true;
    for column in (0..size).filter(|column| used & 1 << column == 0) {
        let factor = entry(row, column);
        if !factor.is_zero() {
            let term = factor * expand(row + 1, size, used | 1 << column, entry);
            sum = if even { sum + term } else { sum - term };
        }
        even = !even;
    }
    sum
}
