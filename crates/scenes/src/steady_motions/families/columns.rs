//! The choice of the dependent unknowns of a family, by Gaussian elimination with complete pivoting.

/// A choice of `rows` columns that form a regular square matrix, in ascending order. Columns from `divided` on are chosen first. `None` if
/// the rows are dependent.
pub(super) fn chosen(
    [rows, columns]: [usize; 2],
    entry: impl Fn(usize, usize) -> f64,
    divided: usize,
) -> Option<Vec<usize>> {
    let mut left: Vec<Vec<f64>> =
        (0..rows).map(|row| (0..columns).map(|column| entry(row, column)).collect()).collect();
    for row in &mut left {
        let size = row.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
        row.iter_mut().filter(|_| size > 0.0).for_each(|entry| *entry /= size);
    }
    let (mut taken, mut used): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    for step in 0..rows {
        let bounded = columns - divided;
        let is_open = |column: &usize| !taken.contains(column) && (step >= bounded || *column >= divided);
        let open: Vec<usize> = (0..columns).filter(is_open).collect();
        let weight = |row: usize, column: usize| left[row][column].abs();
        let (row, column) = (0..rows)
            .filter(|row| !used.contains(row))
            .flat_map(|row| open.iter().map(move |&column| (row, column)))
            .max_by(|a, b| weight(a.0, a.1).total_cmp(&weight(b.0, b.1)))?;
        let pivot = left[row][column];
        if pivot.is_nan() || pivot.abs() <= 1e-12 {
            return None;
        }
        let own = left[row].clone();
        for other in (0..rows).filter(|other| *other != row && !used.contains(other)) {
            let factor = left[other][column] / pivot;
            left[other].iter_mut().zip(&own).for_each(|(entry, own)| *entry -= factor * own);
        }
        taken.push(column);
        used.push(row);
    }
    taken.sort_unstable();
    Some(taken)
}
