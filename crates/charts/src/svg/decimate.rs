//! Thinning of long series of points that keeps all extremes.

/// At most four points for each of `columns` equal intervals of the first coordinate: the first, the lowest, the highest and the last,
/// in their order. Series of at most `4 * columns` points are returned unchanged. All numbers must be finite.
pub(crate) fn decimate(points: &[(f64, f64)], columns: usize) -> Vec<(f64, f64)> {
    if points.len() <= 4 * columns {
        return points.to_vec();
    }
    let (low, high) = points.iter().fold((f64::MAX, f64::MIN), |(low, high), p| (low.min(p.0), high.max(p.0)));
    let scale = if high > low { columns as f64 / (high - low) } else { 0.0 };
    let column = |point: &(f64, f64)| (((point.0 - low) * scale) as usize).min(columns.saturating_sub(1));
    points.chunk_by(|a, b| column(a) == column(b)).flat_map(corners).collect()
}

/// The first, lowest, highest and last of the points, in their order, without repetition.
fn corners(chunk: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let by_height = |a: &usize, b: &usize| chunk[*a].1.total_cmp(&chunk[*b].1);
    let lowest = (0..chunk.len()).min_by(by_height);
    let highest = (0..chunk.len()).max_by(by_height);
    let mut kept: Vec<usize> = [Some(0), lowest, highest, chunk.len().checked_sub(1)].into_iter().flatten().collect();
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|position| chunk[position]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimation_keeps_the_extremes() {
        let mut points: Vec<_> = (0..100_000).map(|i| (f64::from(i), (f64::from(i) * 0.01).sin())).collect();
        points[31_415].1 = 9.0;
        points[77_777].1 = -9.0;
        let kept = decimate(&points, 300);
        assert!(kept.len() <= 1200, "{}", kept.len());
        for extreme in [points[0], points[31_415], points[77_777], points[99_999]] {
            assert!(kept.contains(&extreme), "{extreme:?}");
        }
        assert!(kept.is_sorted_by(|a, b| a.0 < b.0));
    }

    #[test]
    fn short_data_stay_as_they_are() {
        let points = [(0.0, 1.0), (0.0, 2.0)];
        assert_eq!(decimate(&points, 10), points);
        assert_eq!(decimate(&[], 10), []);
    }

    #[test]
    fn many_points_at_one_instant_leave_their_extremes() {
        let points: Vec<_> = (0..1000).map(|i| (1.0, f64::from(i % 7))).collect();
        assert_eq!(decimate(&points, 10), [(1.0, 0.0), (1.0, 6.0), (1.0, 5.0)]);
    }
}
