//! The distribution of friction among contacts that hold a body with more reactions than its motion determines.
//!
//! Reactions R + Z y give one motion for all y, where the columns of Z are reactions that balance among themselves. Shown, and kept within the
//! cones of friction, are those with the least sum of |T|^2/(mu N): feet of a table that is pushed come to their bounds together.

use field::Scalar;

/// Normal reactions change with the distribution, and the bounds with them: it is found so many times.
pub(super) const ROUNDS: usize = 3;

/// y of the least sum, from T of one choice, the columns of Z along T, and 1/(mu N) of each component.
pub(super) fn balancing<S: Scalar>(
    friction: &[S],
    columns: &[Vec<S>],
    per_bound: &[S],
    solved: impl FnOnce(Vec<Vec<S>>, Vec<S>) -> Option<Vec<S>>,
) -> Option<Vec<S>> {
    let product =
        |a: &[S], b: &[S]| a.iter().zip(b).zip(per_bound).fold(S::zero(), |sum, ((a, b), per)| sum + *a * *b * *per);
    let rows = columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect();
    let right = columns.iter().map(|column| -product(column, friction)).collect();
    solved(rows, right)
}

#[cfg(test)]
mod tests {
    use super::balancing;

    /// Two feet in a line: what one pulls the other may push. The force is shared as the bounds are.
    #[test]
    fn feet_share_a_force_by_their_bounds() {
        let solved = |rows: Vec<Vec<f64>>, right: Vec<f64>| Some(vec![right[0] / rows[0][0]]);
        let y = balancing(&[6.0, 0.0], &[vec![-1.0, 1.0]], &[1.0 / 2.0, 1.0 / 4.0], solved).unwrap();
        assert!((y[0] - 4.0).abs() < 1e-15);
    }
}
