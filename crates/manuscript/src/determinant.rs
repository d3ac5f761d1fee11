//! Determinants of expressions.

use symbolic::Sym;

/// The determinant of a square matrix, by expansion along the first row; 1 for an empty matrix.
pub(crate) fn determinant(matrix: &[Vec<Sym>]) -> Sym {
    let [first, rest @ ..] = matrix else { return Sym::ONE };
    let mut sum = Sym::ZERO;
    for (j, &entry) in first.iter().enumerate().filter(|(_, entry)| **entry != Sym::ZERO) {
        let minor: Vec<Vec<Sym>> = rest
            .iter()
            .map(|row| row.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, value)| *value).collect())
            .collect();
        let term = entry * determinant(&minor);
        sum = if j % 2 == 0 { sum + term } else { sum - term };
    }
    sum
}
