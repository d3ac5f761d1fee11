//! Lemmas on functions of positions and time: displacements between points, angles of frames, potentials.

use super::Equations;
use super::directions::TestDirections;
use symbolic::Sym;

/// The properties of such a function c, from second derivatives that are symmetric up to the bracket of the directions: dc'/du = dc/dq, dc''/du' = dc/dq,
/// and X_k c' = (X_k c)'.
pub(super) fn of_places() -> Equations {
    let mut any = TestDirections::any();
    let slopes: [Sym; 3] = std::array::from_fn(|k| Sym::symbol(&format!("c by {}", k + 1)));
    // along all other directions and the time, which commute with the three directions
    let others = Sym::symbol("c by others");
    let second = |j: usize, k: usize| Sym::symbol(&format!("c by {} and {}", j.min(k) + 1, j.max(k) + 1));
    let bracket = Sym::symbol("e");
    // X_j X_k c
    let twice = |j: usize, k: usize| match (j + 1) % 3 == k {
        true if j > k => second(j, k) + bracket * slopes[(k + 1) % 3],
        false if j > k => second(j, k) - bracket * slopes[3 - j - k],
        _ => second(j, k),
    };
    let beside = |k: usize| Sym::symbol(&format!("c by others and {}", k + 1));
    let c = Sym::symbol("c");
    let along = |of: &dyn Fn(usize) -> Sym| (0..3).fold(Sym::ZERO, |sum, j| sum + any.speeds[j] * of(j));
    let rate = along(&|j| slopes[j]) + others;
    let slope_rates: [Sym; 3] = std::array::from_fn(|k| along(&|j| twice(j, k)) + beside(k));
    let rate_of_others = along(&beside) + Sym::symbol("c by others and others");
    any.changes(c, rate, slopes);
    for (k, slope) in slopes.into_iter().enumerate() {
        any.changes(slope, slope_rates[k], std::array::from_fn(|j| twice(j, k)));
    }
    any.changes(others, rate_of_others, std::array::from_fn(beside));
    let by_rates = (0..3).flat_map(|k| {
        [(any.by_speed(any.rate(c), k), slopes[k]), (any.by_acceleration(any.rate(any.rate(c)), k), slopes[k])]
    });
    by_rates.chain(any.commute(c)).collect()
}
