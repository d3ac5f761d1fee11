//! Lemma on multipliers: they cancel along the admissible directions of constraints.

use super::Equations;
use symbolic::Sym;

/// Maggi's equations equal the equations after elimination of the multipliers. With the rows J = [D F] of dependent and independent speeds,
///
///   C = [ -D^-1 F ; 1 ] ,    C^T R = R_F - F^T D^-T R_D .
///
/// The left side is Maggi's for the residual R = J^T lambda; the right side is R_F - F^T lambda with D^T lambda = R_D. Both are equal because the inverse of the transpose
/// is the transpose of the inverse, for any number of rows. The lemma is proved for two rows.
pub(super) fn eliminated() -> Equations {
    let named = |name: &str| -> [[Sym; 2]; 2] {
        std::array::from_fn(|row| {
            std::array::from_fn(|column| Sym::symbol(&format!("{name} {}{}", row + 1, column + 1)))
        })
    };
    let ([[a, b], [c, d]], free) = (named("D"), named("F"));
    let [first, second, third, fourth] = ["1", "2", "3", "4"].map(|place| Sym::symbol(&format!("R {place}")));
    let determinant = a * d - b * c;
    // lambda from D^T lambda = R_D by Cramer's rule
    let lambda = [(first * d - second * c) / determinant, (second * a - first * b) / determinant];
    let along = |column: usize| {
        let (f, g) = (free[0][column], free[1][column]);
        // -D^-1 F
        let slopes = [-(f * d - g * b) / determinant, -(g * a - f * c) / determinant];
        let own = [third, fourth][column];
        (own + first * slopes[0] + second * slopes[1], own - f * lambda[0] - g * lambda[1])
    };
    vec![along(0), along(1)]
}
