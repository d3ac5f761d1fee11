//! Linear equations over Taylor series with error bounds, and the unknown symbols of a mode by them.

use super::super::jet::Jet;
use super::Expansions;
use num_traits::{One, Zero};

/// A pivot counts as zero if it is below this multiple of its error bound.
const PIVOT: f64 = 64.0;

impl Expansions {
    /// The values of unknown symbols for which their rows have given right sides; `right` returns the right side of a row and of its
    /// rate. The second result are the residuals of hidden constraints.
    pub(super) fn solved_for<const N: usize>(
        &self,
        (values, tied): (&[Jet<N>], &[Option<[Jet<N>; 2]>]),
        unknown: &[usize],
        right: impl Fn(usize) -> [Jet<N>; 2],
    ) -> Option<(Vec<Jet<N>>, Vec<Jet<N>>)> {
        let slopes = self.slopes_by(values, tied, unknown, unknown);
        if self.algebraic == 0 {
            let right = (0..unknown.len()).map(|row| right(row)[0]).collect();
            return Some((solved(slopes, right)?, Vec::new()));
        }
        let rates: Vec<usize> = unknown.iter().map(|letter| self.letters() + letter).collect();
        let of_rates = self.slopes_by(values, tied, &rates, unknown);
        let row = |(place, (slopes, of_rate)): (usize, (Vec<Jet<N>>, Vec<Jet<N>>))| {
            let [right, right_of_rate] = right(place);
            Row { slopes, right, rate: self.is_value(unknown[place]).then_some((of_rate, right_of_rate)) }
        };
        with_hidden(&slopes.into_iter().zip(of_rates).enumerate().map(row).collect::<Vec<_>>())
    }
}

/// Solves linear equations by Gaussian elimination with partial pivoting; `None` if a pivot is zero up to rounding.
pub(in super::super) fn solved<const N: usize>(
    mut rows: Vec<Vec<Jet<N>>>,
    mut right: Vec<Jet<N>>,
) -> Option<Vec<Jet<N>>> {
    let n = right.len();
    for pivot in 0..n {
        let size = |row: usize| rows[row][pivot].terms[0].abs();
        let row = (pivot..n).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
        let largest = rows[row][pivot];
        // zero or NaN
        if largest.sign_of(0, PIVOT).abs() != 1.0 {
            return None;
        }
        rows.swap(pivot, row);
        right.swap(pivot, row);
        for below in pivot + 1..n {
            let factor = rows[below][pivot] / rows[pivot][pivot];
            let (upper, lower) = rows.split_at_mut(below);
            for (entry, &above) in lower[0].iter_mut().zip(&upper[pivot]).skip(pivot + 1) {
                *entry -= factor * above;
            }
            let part = factor * right[pivot];
            right[below] -= part;
        }
    }
    for row in (0..n).rev() {
        let known = (row + 1..n).fold(right[row], |rest, column| rest - rows[row][column] * right[column]);
        right[row] = known / rows[row][row];
    }
    Some(right)
}

/// An equation: slopes times unknowns = right side. `rate` is the equation for its time derivative, given if the value of the equation
/// contains the unknowns.
pub(in super::super) struct Row<const N: usize> {
    pub slopes: Vec<Jet<N>>,
    pub right: Jet<N>,
    pub rate: Option<(Vec<Jet<N>>, Jet<N>)>,
}

/// A row during elimination.
struct Reduced<const N: usize> {
    slopes: Vec<Jet<N>>,
    right: Jet<N>,
    /// The factors of the original equations of which the row is a combination; `None` for a rate.
    sum: Option<Vec<Jet<N>>>,
}

/// Solves equations with hidden constraints: a combination of equations without unknowns is replaced by its rate. Returns the unknowns
/// and the residuals of the hidden constraints; `None` if the unknowns are not determined.
pub(in super::super) fn with_hidden<const N: usize>(rows: &[Row<N>]) -> Option<(Vec<Jet<N>>, Vec<Jet<N>>)> {
    let n = rows.len();
    let unit = |own: usize| (0..n).map(|other| if own == other { Jet::one() } else { Jet::zero() }).collect();
    let own = |(place, row): (usize, &Row<N>)| Reduced {
        slopes: row.slopes.clone(),
        right: row.right,
        sum: Some(unit(place)),
    };
    let mut all: Vec<Reduced<N>> = rows.iter().enumerate().map(own).collect();
    let (mut pivots, mut hidden): (Vec<(usize, usize)>, Vec<Jet<N>>) = (Vec::new(), Vec::new());
    while pivots.len() < n {
        let open: Vec<usize> = (0..n).filter(|row| pivots.iter().all(|(own, _)| own != row)).collect();
        let free = (0..n).filter(|column| pivots.iter().all(|(_, own)| own != column));
        let entries = free.flat_map(|column| open.iter().map(move |&row| (row, column)));
        let size = |&(row, column): &(usize, usize)| all[row].slopes[column].terms[0].abs();
        let counts = |&(row, column): &(usize, usize)| all[row].slopes[column].sign_of(0, PIVOT).abs() == 1.0;
        let largest = entries.filter(counts).max_by(|a, b| size(a).total_cmp(&size(b)));
        if let Some(pivot) = largest {
            pivots.push(pivot);
            open.into_iter().filter(|&row| row != pivot.0).for_each(|row| reduce(&mut all, row, pivot));
            continue;
        }
        for row in open {
            let sum = all[row].sum.take()?;
            hidden.push(all[row].right);
            let mut rate = Reduced { slopes: vec![Jet::zero(); n], right: Jet::zero(), sum: None };
            for (factor, own) in sum.iter().zip(rows).filter(|(factor, _)| factor.sign_of(0, PIVOT) != 0.0) {
                let (slopes, right) = own.rate.as_ref()?;
                rate.slopes.iter_mut().zip(slopes).for_each(|(entry, slope)| *entry += *factor * *slope);
                rate.right += *factor * *right;
            }
            all[row] = rate;
            pivots.iter().for_each(|&pivot| reduce(&mut all, row, pivot));
        }
    }
    let mut values = vec![Jet::zero(); n];
    for &(row, column) in pivots.iter().rev() {
        let others = all[row].slopes.iter().zip(&values).enumerate().filter(|(place, _)| *place != column);
        let rest = others.fold(all[row].right, |rest, (_, (slope, value))| rest - *slope * *value);
        values[column] = rest / all[row].slopes[column];
    }
    Some((values, hidden))
}

/// Eliminates the unknown of a pivot from one other row.
fn reduce<const N: usize>(all: &mut [Reduced<N>], row: usize, (pivot, column): (usize, usize)) {
    if all[row].slopes[column].terms.iter().all(|term| *term == 0.0) {
        return;
    }
    let Ok([own, above]) = all.get_disjoint_mut([row, pivot]) else { return };
    let factor = own.slopes[column] / above.slopes[column];
    own.slopes.iter_mut().zip(&above.slopes).for_each(|(entry, above)| *entry -= factor * *above);
    own.slopes[column] = Jet::zero();
    own.right -= factor * above.right;
    if let (Some(own), Some(above)) = (&mut own.sum, &above.sum) {
        own.iter_mut().zip(above).for_each(|(part, above)| *part -= factor * *above);
    }
}
