//! Multipliers drop out along the directions that constraints leave.

use super::Equations;
use symbolic::Sym;

/// Maggi's equations are those without multipliers. With the rows J = [D F] of dependent and free speeds
///
///   C = [ -D^-1 F ; 1 ] ,    C^T R = R_F - F^T D^-T R_D ,
///
/// on the left Maggi's for the residual R = J^T lambda, on the right R_F less F^T lambda where D^T lambda = R_D: the inverse of a transpose
/// is the transpose of the inverse, for any number of rows. It is shown for two.
pub(super) fn eliminated() -> Equations {
    let named = |name: &str| -> [[Sym; 2]; 2] {
        std::array::from_fn(|row| {
            std::array::from_fn(|column| Sym::symbol(&format!("{name} {}{}", row + 1, column + 1)))
        })
    };
    let ([[a, b], [c, d]], free) = (named("D"), named("F"));
    let [first, second, third, fourth] = ["1", "2", "3", "4"].map(|place| Sym::symbol(&format!("R {place}")));
    let determinant = a * d - b * c;
    // lambda by D^T lambda = R_D, by Cramer's rule
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
