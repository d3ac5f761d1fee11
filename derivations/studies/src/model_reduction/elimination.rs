//! Exact linear algebra: a basis of rows, the coordinates of all rows in it, and the factorisation K D K^T.

use field::{Rational, Scalar};
use std::cmp::Ordering;

/// The indices of the first rows that form a basis of all rows.
pub fn pivots(rows: &[Vec<Rational>]) -> Vec<usize> {
    let zero = Rational::int(0);
    // reduced basis rows, each with its pivot column
    let mut reduced: Vec<(usize, Vec<Rational>)> = Vec::new();
    let mut found = Vec::new();
    for (place, row) in rows.iter().enumerate() {
        let mut rest = row.clone();
        for (lead, known) in &reduced {
            let factor = rest[*lead] / known[*lead];
            rest.iter_mut().zip(known).for_each(|(x, y)| *x -= factor * *y);
        }
        if let Some(lead) = rest.iter().position(|x| *x != zero) {
            reduced.push((lead, rest));
            found.push(place);
        }
    }
    found
}

/// The matrix B with row_k = sum_j B_kj row_(pivot j).
pub fn shares(rows: &[Vec<Rational>], pivots: &[usize]) -> Vec<Vec<Rational>> {
    let m = pivots.len();
    // the normal equations have a unique solution, since the pivot rows are independent
    let product = |a: &[Rational], b: &[Rational]| a.iter().zip(b).fold(Rational::int(0), |sum, (x, y)| sum + *x * *y);
    let gram: Vec<Vec<Rational>> =
        pivots.iter().map(|&i| pivots.iter().map(|&j| product(&rows[i], &rows[j])).collect()).collect();
    let (k, d) = factored(&gram);
    let inverse = inverse_of_unit(&k);
    let solved = |row: &Vec<Rational>| {
        let right: Vec<Rational> = pivots.iter().map(|&i| product(&rows[i], row)).collect();
        let middle: Vec<Rational> = (0..m).map(|i| product(&inverse[i], &right) / d[i]).collect();
        (0..m).map(|j| (0..m).fold(Rational::int(0), |sum, i| sum + inverse[i][j] * middle[i])).collect()
    };
    rows.iter().map(solved).collect()
}

/// The factors of a positive definite matrix K D K^T: K unit lower triangular, D diagonal.
pub fn factored(matrix: &[Vec<Rational>]) -> (Vec<Vec<Rational>>, Vec<Rational>) {
    let n = matrix.len();
    let (zero, one) = (Rational::int(0), Rational::int(1));
    let mut k = vec![vec![zero; n]; n];
    let mut d = vec![zero; n];
    for j in 0..n {
        d[j] = matrix[j][j] - (0..j).fold(zero, |sum, p| sum + k[j][p] * k[j][p] * d[p]);
        k[j][j] = one;
        for i in j + 1..n {
            let known = (0..j).fold(zero, |sum, p| sum + k[i][p] * k[j][p] * d[p]);
            k[i][j] = (matrix[i][j] - known) / d[j];
        }
    }
    (k, d)
}

/// The inverse of a unit lower triangular matrix.
pub fn inverse_of_unit(k: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    let n = k.len();
    let zero = Rational::int(0);
    let mut inverse: Vec<Vec<Rational>> = Vec::new();
    for (i, row) in k.iter().enumerate() {
        let entry = |j: usize| match i.cmp(&j) {
            Ordering::Less => zero,
            Ordering::Equal => Rational::int(1),
            Ordering::Greater => -(j..i).fold(zero, |sum, p| sum + row[p] * inverse[p][j]),
        };
        let row = (0..n).map(entry).collect();
        inverse.push(row);
    }
    inverse
}
