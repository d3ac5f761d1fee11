//! Directions in the space of coordinates without inertia, compatible with the constraints, as vectors of integers.

use crate::Trace;
use field::{Rational, Scalar as _};
use symbolic::{Sym, substitute_all};

/// Returns rows that vanish on the directions along which no law depends on the speeds: derivatives of the laws at three points with integer values; `None` if
/// a derivative is undefined there.
pub(super) fn speed_free(trace: &Trace<'_>, laws: &[Sym], open: &[usize]) -> Option<Vec<Vec<Rational>>> {
    let slopes: Vec<Vec<Sym>> =
        laws.iter().map(|law| open.iter().map(|&place| trace.by_speed(*law, place)).collect()).collect();
    let mut letters: Vec<Sym> = slopes.iter().flatten().flat_map(|slope| slope.symbols_of()).collect();
    letters.sort_by_key(|letter| letter.to_string());
    letters.dedup();
    let at = |point: i64| -> Option<Vec<Vec<Rational>>> {
        let values =
            letters.iter().zip(1_i64..).map(|(&letter, place)| (letter, Sym::int(3 + (7 * place * point) % 101)));
        let values: Vec<(Sym, Sym)> = values.collect();
        let row = |row: &Vec<Sym>| substitute_all(row, &values).into_iter().map(Sym::as_constant).collect();
        slopes.iter().map(row).collect()
    };
    Some([1, 5, 13].map(at).into_iter().collect::<Option<Vec<_>>>()?.concat())
}

/// Returns a basis of the null space of `rows`. Directions in the null space of `more` come first.
pub(super) fn basis(rows: &[Vec<Rational>], more: &Option<Vec<Vec<Rational>>>, columns: usize) -> Vec<Vec<Rational>> {
    let all = null_space(rows.to_vec(), columns);
    let first = more.as_ref().map(|more| null_space([rows, more].concat(), columns)).unwrap_or_default();
    let mut chosen: Vec<Vec<Rational>> = Vec::new();
    for direction in first.into_iter().chain(all) {
        chosen.push(direction);
        if columns - null_space(chosen.clone(), columns).len() < chosen.len() {
            chosen.pop();
        }
    }
    chosen
}

/// Returns a basis of the null space of `rows`, by Gauss-Jordan elimination.
fn null_space(mut rows: Vec<Vec<Rational>>, columns: usize) -> Vec<Vec<Rational>> {
    let is_zero = |value: Rational| value.sign() == Some(0);
    let mut pivots: Vec<usize> = Vec::new();
    for column in 0..columns {
        let done = pivots.len();
        let Some(found) = (done..rows.len()).find(|&row| !is_zero(rows[row][column])) else { continue };
        rows.swap(done, found);
        let pivot = rows[done][column];
        rows[done].iter_mut().for_each(|entry| *entry /= pivot);
        let own = rows[done].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(place, _)| *place != done) {
            let factor = row[column];
            row.iter_mut().zip(&own).for_each(|(entry, own)| *entry -= factor * *own);
        }
        pivots.push(column);
    }
    let free = (0..columns).filter(|column| !pivots.contains(column));
    free.map(|column| {
        let mut vector = vec![Rational::new(0, 1); columns];
        vector[column] = Rational::new(1, 1);
        for (row, &pivot) in pivots.iter().enumerate() {
            vector[pivot] = -rows[row][column];
        }
        vector
    })
    .collect()
}

/// Scales a direction to integers; `None` if they exceed 64 bits.
pub(super) fn whole(factors: &[Rational]) -> Option<Vec<i64>> {
    let denominator = |factor: &Rational| i64::try_from(factor.to_big()?.denominator().clone()).ok();
    let common = factors.iter().try_fold(1_i64, |common, factor| {
        let own = denominator(factor)?;
        if common % own == 0 { Some(common) } else { common.checked_mul(own) }
    })?;
    let scaled = |factor: &Rational| {
        let scaled = (*factor * Rational::new(common, 1)).to_big()?;
        i64::try_from(scaled.numerator().clone()).ok()
    };
    factors.iter().map(scaled).collect()
}
