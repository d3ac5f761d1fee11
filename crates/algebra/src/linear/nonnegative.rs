//! Exact nonnegative combinations of vectors.
//!
//! Phase one of the simplex method in rational numbers, with Bland's rule against cycling (R. G. Bland, Math. Oper.
//! Res. 2 (1977), 103-107).

use field::Rational;

/// The largest number of pivot steps.
const MOST_EXCHANGES: usize = 600;

/// The largest number of entries of the tableau.
const LARGEST_TABLE: usize = 200_000;

/// Factors λ with λ_j ≥ 0 and Σ λ_j columns_j = target. `None` where none exist, where lengths differ, or where the
/// limits of size and pivot steps are exceeded.
pub fn nonnegative_combination(columns: &[Vec<Rational>], target: &[Rational]) -> Option<Vec<Rational>> {
    let height = target.len();
    if columns.iter().any(|column| column.len() != height) || height.checked_mul(columns.len())? > LARGEST_TABLE {
        return None;
    }
    let kept = possible(columns, target);
    let zero = Rational::new(0, 1);
    // each row: its entries in the columns, then its target, made nonnegative
    let mut rows: Vec<Vec<Rational>> = (0..height)
        .map(|row| {
            let is_down = target[row].sign() == Some(-1);
            let entries = kept.iter().map(|&column| columns[column][row]).chain([target[row]]);
            entries.map(|entry| if is_down { -entry } else { entry }).collect()
        })
        .collect();
    // `None`: the basis variable of the row is artificial and must vanish
    let mut basis: Vec<Option<usize>> = vec![None; height];
    for _ in 0..MOST_EXCHANGES {
        let open: Vec<usize> = (0..height).filter(|&row| basis[row].is_none()).collect();
        let total = |place: usize| open.iter().fold(zero, |sum, &row| sum + rows[row][place]);
        if total(kept.len()) == zero {
            let mut found = vec![zero; columns.len()];
            for (row, &place) in basis.iter().enumerate() {
                if let Some(place) = place {
                    found[kept[place]] = rows[row][kept.len()];
                }
            }
            return Some(found);
        }
        let entering = (0..kept.len()).find(|&place| total(place).sign() == Some(1))?;
        exchange(&mut rows, &mut basis, entering)?;
    }
    None
}

/// The columns that may have a nonzero factor: a row with target zero and entries of one sign excludes all of its
/// columns.
fn possible(columns: &[Vec<Rational>], target: &[Rational]) -> Vec<usize> {
    let mut kept: Vec<usize> = (0..columns.len()).collect();
    loop {
        let signs = |row: usize| kept.iter().filter_map(move |&column| columns[column][row].sign());
        let has_one_sign = |row: usize| {
            let (up, down) = (signs(row).any(|sign| sign > 0), signs(row).any(|sign| sign < 0));
            up != down
        };
        let is_zero = |row: &usize| target[*row].sign() == Some(0);
        let excluding: Vec<usize> = (0..target.len()).filter(is_zero).filter(|&row| has_one_sign(row)).collect();
        if excluding.is_empty() {
            return kept;
        }
        kept.retain(|&column| excluding.iter().all(|&row| columns[column][row].sign() == Some(0)));
    }
}

/// Brings a column into the basis, in the row that bounds its factor first; `None` where no row bounds it.
fn exchange(rows: &mut [Vec<Rational>], basis: &mut [Option<usize>], entering: usize) -> Option<()> {
    let last = rows.first()?.len() - 1;
    let mut leaving: Option<(usize, Rational)> = None;
    for (row, entries) in rows.iter().enumerate().filter(|(_, entries)| entries[entering].sign() == Some(1)) {
        let bound = entries[last] / entries[entering];
        // of equal bounds an artificial variable leaves first, then the first column
        let is_first = |(known, least): &(usize, Rational)| match (bound - *least).sign() {
            Some(0) => basis[row] < basis[*known],
            sign => sign == Some(-1),
        };
        if leaving.as_ref().is_none_or(is_first) {
            leaving = Some((row, bound));
        }
    }
    let (row, _) = leaving?;
    let pivot = rows[row][entering];
    rows[row].iter_mut().for_each(|entry| *entry /= pivot);
    let own = rows[row].clone();
    for (place, entries) in rows.iter_mut().enumerate() {
        let factor = entries[entering];
        if place != row && factor.sign() != Some(0) {
            let zero = |entry: &Rational| entry.sign() == Some(0);
            entries.iter_mut().zip(&own).filter(|(_, own)| !zero(own)).for_each(|(entry, own)| *entry -= factor * *own);
        }
    }
    basis[row] = Some(entering);
    Some(())
}
