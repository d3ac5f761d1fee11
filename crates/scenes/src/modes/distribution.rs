//! The distribution of friction among contacts that have more reactions than the motion determines.
//!
//! The motion does not depend on the friction T_l of leaning contacts; the friction of the others is T_f = T_0 + Z T_l, where T_0 belongs
//! to T_l = 0. Outputs show the distribution with the least sum of |T|^2/(mu N), which weights each contact by its friction bound: the
//! feet of a pushed table reach their bounds together. With a multiplier m for each T_f, this minimum is
//!
//!   T_f = D_f m,    T_l = -D_l Z' m,    (D_f + Z D_l Z') m = T_0,    D = mu N.
//!
//! A contact without pressure takes no friction.

use field::Scalar;

/// The number of iterations: normal reactions, and thus the bounds mu N, depend on the distribution.
pub(super) const ROUNDS: usize = 3;

/// The minimiser T_l, from `alone` = T_0, `columns` of Z, and the bounds mu N for each component of T_f and of T_l. `solved` solves
/// linear equations. `None` if these are singular.
pub(super) fn balancing<S: Scalar>(
    alone: &[S],
    columns: &[Vec<S>],
    [bounds, bounds_leaning]: [&[S]; 2],
    solved: impl FnOnce(Vec<Vec<S>>, Vec<S>) -> Option<Vec<S>>,
) -> Option<Vec<S>> {
    let entry = |row: usize, other: usize| {
        let own = if row == other { bounds[row] } else { S::zero() };
        let leaning = columns.iter().zip(bounds_leaning);
        leaning.fold(own, |sum, (column, bound)| sum + column[row] * *bound * column[other])
    };
    let rows = (0..alone.len()).map(|row| (0..alone.len()).map(|other| entry(row, other)).collect()).collect();
    let multipliers = solved(rows, alone.to_vec())?;
    let of = |(column, bound): (&Vec<S>, &S)| {
        column.iter().zip(&multipliers).fold(S::zero(), |sum, (part, multiplier)| sum - *part * *multiplier) * *bound
    };
    Some(columns.iter().zip(bounds_leaning).map(of).collect())
}

#[cfg(test)]
mod tests {
    use super::balancing;

    fn shared(bounds: [f64; 2]) -> f64 {
        let solved = |rows: Vec<Vec<f64>>, right: Vec<f64>| Some(vec![right[0] / rows[0][0]]);
        balancing(&[6.0], &[vec![-1.0]], [&bounds[..1], &bounds[1..]], solved).expect("one that presses")[0]
    }

    /// Two feet in line can exchange any force. A load is shared in the ratio of their bounds.
    #[test]
    fn feet_share_a_force_by_their_bounds() {
        assert!((shared([2.0, 4.0]) - 4.0).abs() < 1e-15);
    }

    #[test]
    fn a_foot_without_pressure_takes_no_friction() {
        assert_eq!([shared([0.0, 4.0]), shared([2.0, 0.0])], [6.0, 0.0]);
    }
}
