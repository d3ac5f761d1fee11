//! The inertia of a quadratic form.

use super::characteristic;
use algebra::real::Ordered;

/// The inertia of a quadratic form (Sylvester): the numbers of positive, zero and negative squares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inertia {
    pub positive: usize,
    pub zero: usize,
    pub negative: usize,
}

impl Inertia {
    /// The inertia of a symmetric matrix. Since all its eigenvalues are real, the number of positive ones is the number
    /// of sign changes in its characteristic polynomial (Descartes). `None` where a sign cannot be determined.
    pub fn of<R: Ordered>(matrix: &[Vec<R>], one: &R) -> Option<Self> {
        let coefficients = characteristic(matrix, one);
        let signs: Vec<i32> = coefficients.iter().map(R::sign).collect::<Option<_>>()?;
        let zero = signs.iter().rev().take_while(|sign| **sign == 0).count();
        let seen: Vec<i32> = signs.into_iter().filter(|sign| *sign != 0).collect();
        let positive = seen.windows(2).filter(|pair| pair[0] != pair[1]).count();
        Some(Inertia { positive, zero, negative: matrix.len() - zero - positive })
    }

    /// The inertia of the form on the subspace where the linear forms `constraints`, which must be independent, vanish.
    /// The matrix bordered by them has as many additional positive and negative squares as there are constraints.
    pub fn on_subspace<R: Ordered>(matrix: &[Vec<R>], constraints: &[Vec<R>], one: &R) -> Option<Self> {
        let border = constraints.len();
        let zero = one.integer(0);
        let mut bordered: Vec<Vec<R>> = constraints
            .iter()
            .map(|constraint| std::iter::repeat_n(zero.clone(), border).chain(constraint.iter().cloned()).collect())
            .collect();
        for (place, row) in matrix.iter().enumerate() {
            let across = constraints.iter().map(|constraint| constraint[place].clone());
            bordered.push(across.chain(row.iter().cloned()).collect());
        }
        let all = Inertia::of(&bordered, one)?;
        Some(Inertia {
            positive: all.positive.checked_sub(border)?,
            zero: all.zero,
            negative: all.negative.checked_sub(border)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::{Rational, Scalar};

    fn rows<const N: usize, const M: usize>(entries: [[i64; M]; N]) -> Vec<Vec<Rational>> {
        entries.iter().map(|row| row.map(Rational::int).to_vec()).collect()
    }

    #[test]
    fn squares_of_each_sign_are_counted() {
        let one = Rational::int(1);
        let form = rows([[2, 1, 0, 0], [1, 2, 0, 0], [0, 0, -3, 0], [0, 0, 0, 0]]);
        assert_eq!(Inertia::of(&form, &one), Some(Inertia { positive: 2, zero: 1, negative: 1 }));
    }

    #[test]
    fn a_constraint_can_take_the_negative_square_away() {
        let one = Rational::int(1);
        // x^2 - y^2 + z^2 on y = 0, on y = 2 x, on x = y
        let form = rows([[1, 0, 0], [0, -1, 0], [0, 0, 1]]);
        let on = |constraint: [i64; 3]| Inertia::on_subspace(&form, &rows([constraint]), &one).unwrap();
        assert_eq!(on([0, 1, 0]), Inertia { positive: 2, zero: 0, negative: 0 });
        assert_eq!(on([2, -1, 0]), Inertia { positive: 1, zero: 0, negative: 1 });
        assert_eq!(on([1, -1, 0]), Inertia { positive: 1, zero: 1, negative: 0 });
    }
}
