//! The Pareto front of cost and error.

/// The indices of the points (cost, error) on the Pareto front, by ascending cost. A point dominates another if it is
/// not worse in either coordinate and better in one; of equal points the first one is kept. NaN and negative errors are
/// never on the front.
pub fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let known = |&at: &usize| points[at].0.is_finite() && points[at].1.is_finite() && points[at].1 >= 0.0;
    let mut order: Vec<usize> = (0..points.len()).filter(known).collect();
    // stable sort: equal points keep their order
    order.sort_by(|&a, &b| points[a].0.total_cmp(&points[b].0).then(points[a].1.total_cmp(&points[b].1)));
    let mut least = f64::INFINITY;
    order.retain(|&at| {
        let better = points[at].1 < least;
        least = least.min(points[at].1);
        better
    });
    order
}

/// The cost of each point (cost, error) divided by the smallest cost of a point with at most the same error; 1 on the
/// front.
pub fn excess(points: &[(f64, f64)]) -> Vec<f64> {
    let front = front(points);
    let least = |error: f64| front.iter().find(|&&at| points[at].1 <= error).map_or(f64::NAN, |&at| points[at].0);
    points.iter().map(|(cost, error)| cost / least(*error)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_holds_what_nothing_beats() {
        let points = [(3.0, 1e-6), (1.0, 1e-2), (2.0, 1e-1), (4.0, 1e-6), (5.0, 1e-9)];
        assert_eq!(front(&points), [1, 0, 4]);
        assert_eq!(excess(&points), [1.0, 1.0, 2.0, 4.0 / 3.0, 1.0]);
    }

    #[test]
    fn of_equal_points_the_first_stays_and_no_number_is_on_it() {
        assert_eq!(front(&[(1.0, f64::NAN), (2.0, 0.5), (2.0, 0.5), (f64::INFINITY, 0.0), (2.0, 0.25)]), [4]);
        assert_eq!(front(&[(2.0, 0.5), (2.0, 0.5)]), [0]);
        assert_eq!(front(&[]), [0_usize; 0]);
    }

    /// Comparison with the definition of dominance, over all triples of a small grid.
    #[test]
    fn the_front_is_what_its_definition_says() {
        let grid: Vec<(f64, f64)> = (0..9).map(|i| (f64::from(i % 3), f64::from(i / 3))).collect();
        for a in &grid {
            for b in &grid {
                for c in &grid {
                    let points = [*a, *b, *c];
                    let dominated =
                        |p: &(f64, f64)| points.iter().any(|q| q.0 <= p.0 && q.1 <= p.1 && (q.0 < p.0 || q.1 < p.1));
                    let found = front(&points);
                    for (at, point) in points.iter().enumerate() {
                        let first = points[..at].iter().all(|before| before != point);
                        assert_eq!(found.contains(&at), !dominated(point) && first, "{points:?}");
                    }
                }
            }
        }
    }
}
