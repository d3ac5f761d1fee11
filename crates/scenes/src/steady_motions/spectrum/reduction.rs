//! Reduction of the linear equations at a steady motion to independent variations without cyclic coordinates, over exact or enclosed numbers.

use crate::linearisation::AllSlopes;
use algebra::real::{Ball, Ordered};
use field::Rational;

/// A number type with division and signs, for eliminations.
pub(super) trait Pivot: Ordered {
    /// A measure of the size, for the choice of pivots; zero if the number may be zero.
    fn weight(&self) -> f64;
}

impl Pivot for Ball {
    fn weight(&self) -> f64 {
        if self.sign().is_some_and(|sign| sign != 0) { self.least().max(f64::MIN_POSITIVE) } else { 0.0 }
    }
}

impl Pivot for Rational {
    fn weight(&self) -> f64 {
        match Rational::sign(*self) {
            Some(0) | None => 0.0,
            Some(_) => self.to_f64().abs().clamp(f64::MIN_POSITIVE, f64::MAX),
        }
    }
}

/// A matrix as a list of rows.
pub(super) type Matrix<R> = Vec<Vec<R>>;

/// The part of each coordinate and speed in the equations.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// The number of position constraints, which come before constraints of speeds.
    pub positions: usize,
    /// Indices of speeds that constraints of speeds determine.
    pub determined: Vec<usize>,
    /// Indices of cyclic coordinates.
    pub cyclic: Vec<usize>,
}

/// The linear equations x' = A x; x has the independent displacements without cyclic ones, then the independent speeds.
#[derive(Clone, Debug)]
pub(super) struct Reduced<R> {
    pub matrix: Matrix<R>,
    /// The number of displacements in x.
    pub displacements: usize,
    /// All speeds in terms of the independent ones.
    pub by_speeds: Matrix<R>,
}

impl<R: Pivot> Reduced<R> {
    /// The reduced equations; `None` if a matrix is, or may be, singular.
    pub fn of(at: &AllSlopes<R>, layout: &Layout, one: &R) -> Option<Self> {
        let (n, m) = (at.motion.values.len(), at.rate.values.len());
        let zero = one.integer(0);
        let negative = |value: &R| zero.minus(value);
        let held: Matrix<R> = at.acceleration.by_accelerations[..layout.positions].to_vec();
        let first = dependent(held, &layout.determined)?;
        let fixed: Vec<usize> = first.iter().chain(&layout.determined).copied().collect();
        if fixed.len() != m {
            return None;
        }
        let free: Vec<usize> = (0..n).filter(|k| !first.contains(k) && !layout.cyclic.contains(k)).collect();
        let free_speeds: Vec<usize> = (0..n).filter(|k| !fixed.contains(k)).collect();
        let size = free.len() + free_speeds.len();

        // all displacements and all speeds in terms of x
        let unit = |k: usize, among: &[usize], shift: usize| -> Vec<R> {
            (0..size).map(|column| one.integer(i64::from(among.get(column.wrapping_sub(shift)) == Some(&k)))).collect()
        };
        let mut moved: Matrix<R> = (0..n).map(|k| unit(k, &free, 0)).collect();
        let mut speeds: Matrix<R> = (0..n).map(|k| unit(k, &free_speeds, free.len())).collect();
        let rows = &at.acceleration.by_accelerations;
        settle(&rows[..layout.positions], &first, &mut moved, |_, _| zero.clone())?;
        let carried = times(&at.rate.by_coordinates, &moved, &zero);
        settle(rows, &fixed, &mut speeds, |row, column| carried[row][column].clone())?;

        // accelerations and multipliers in terms of x
        let by_state = |coordinates: &[Vec<R>], by_speeds: &[Vec<R>]| -> Matrix<R> {
            let (a, b) = (times(coordinates, &moved, &zero), times(by_speeds, &speeds, &zero));
            let sum = |(a, b): (&Vec<R>, &Vec<R>)| a.iter().zip(b).map(|(a, b)| negative(&a.plus(b))).collect();
            a.iter().zip(&b).map(sum).collect()
        };
        let right = [
            by_state(&at.motion.by_coordinates, &at.motion.by_speeds),
            by_state(&at.acceleration.by_coordinates, &at.acceleration.by_speeds),
        ]
        .concat();
        let accelerations = solved(whole(at, &zero), right)?;
        let rows = free.iter().map(|&k| speeds[k].clone());
        let matrix = rows.chain(free_speeds.iter().map(|&k| accelerations[k].clone())).collect();
        let by_speeds = speeds.iter().map(|row| row[free.len()..].to_vec()).collect();
        Some(Reduced { matrix, displacements: free.len(), by_speeds })
    }
}

/// The matrix [M, -J^T; J, 0].
pub(super) fn whole<R: Pivot>(at: &AllSlopes<R>, zero: &R) -> Matrix<R> {
    let joined = |(a, b): (&Vec<R>, &Vec<R>)| [&a[..], b].concat();
    let mut all: Matrix<R> = at.motion.by_accelerations.iter().zip(&at.motion.by_multipliers).map(joined).collect();
    let m = at.acceleration.values.len();
    all.extend(at.acceleration.by_accelerations.iter().map(|row| [&row[..], &vec![zero.clone(); m]].concat()));
    all
}

/// Solves `rows` x + `more` = 0 for the components `fixed` of x and replaces these rows of `all`; `None` if they are not determined.
fn settle<R: Pivot>(
    rows: &[Vec<R>],
    fixed: &[usize],
    all: &mut Matrix<R>,
    more: impl Fn(usize, usize) -> R,
) -> Option<()> {
    let Some(any) = rows.first().and_then(|row| row.first()) else { return Some(()) };
    let zero = any.integer(0);
    fixed.iter().for_each(|&k| all[k].fill(zero.clone()));
    let right = times(rows, all, &zero);
    let entry = |(row, values): (usize, &Vec<R>)| -> Vec<R> {
        values.iter().enumerate().map(|(column, value)| zero.minus(&value.plus(&more(row, column)))).collect()
    };
    let right: Matrix<R> = right.iter().enumerate().map(entry).collect();
    let own = rows.iter().map(|row| fixed.iter().map(|&k| row[k].clone()).collect()).collect();
    let found = solved(own, right)?;
    fixed.iter().zip(found).for_each(|(&k, row)| all[k] = row);
    Some(())
}

/// The product of two matrices.
fn times<R: Pivot>(left: &[Vec<R>], right: &[Vec<R>], zero: &R) -> Matrix<R> {
    let wide = right.first().map_or(0, Vec::len);
    let entry = |row: &Vec<R>, column: usize| {
        row.iter().zip(right).fold(zero.clone(), |sum, (a, b)| sum.plus(&a.times(&b[column])))
    };
    left.iter().map(|row| (0..wide).map(|column| entry(row, column)).collect()).collect()
}

/// One column for each row, none in `but`, such that the rows are linearly independent on these columns; `None` if there is no such choice.
fn dependent<R: Pivot>(mut rows: Matrix<R>, but: &[usize]) -> Option<Vec<usize>> {
    let mut taken: Vec<usize> = Vec::new();
    for row in 0..rows.len() {
        let free = (0..rows[row].len()).filter(|k| !taken.contains(k) && !but.contains(k));
        let pivot = free.max_by(|&a, &b| rows[row][a].weight().total_cmp(&rows[row][b].weight()))?;
        if rows[row][pivot].weight() == 0.0 {
            return None;
        }
        let own = rows[row].clone();
        for below in &mut rows[row + 1..] {
            let factor = below[pivot].over(&own[pivot])?;
            below.iter_mut().zip(&own).for_each(|(entry, own)| *entry = entry.minus(&own.times(&factor)));
        }
        taken.push(pivot);
    }
    Some(taken)
}

/// The solution of linear equations with several right sides, by Gauss-Jordan elimination with scaled partial pivoting; `None` if a pivot
/// may be zero.
pub(super) fn solved<R: Pivot>(mut matrix: Matrix<R>, mut right: Matrix<R>) -> Option<Matrix<R>> {
    let n = matrix.len();
    let sizes: Vec<f64> = matrix.iter().map(|row| row.iter().map(Pivot::weight).fold(0.0, f64::max)).collect();
    let mut order: Vec<usize> = (0..n).collect();
    for column in 0..n {
        let weight = |row: usize| matrix[row][column].weight() / sizes[row].max(f64::MIN_POSITIVE);
        let best = (column..n).max_by(|&a, &b| weight(order[a]).total_cmp(&weight(order[b])))?;
        order.swap(column, best);
        let pivot = order[column];
        if matrix[pivot][column].weight() == 0.0 {
            return None;
        }
        let (own, of_right) = (matrix[pivot].clone(), right[pivot].clone());
        for &row in order.iter().filter(|row| **row != pivot) {
            let factor = matrix[row][column].over(&own[column])?;
            if factor.sign() == Some(0) {
                continue;
            }
            let less = |(entry, own): (&mut R, &R)| *entry = entry.minus(&own.times(&factor));
            matrix[row].iter_mut().zip(&own).skip(column).for_each(less);
            right[row].iter_mut().zip(&of_right).for_each(less);
        }
    }
    let mut all = vec![Vec::new(); n];
    for (column, &row) in order.iter().enumerate() {
        let pivot = &matrix[row][column];
        all[column] = right[row].iter().map(|value| value.over(pivot)).collect::<Option<_>>()?;
    }
    Some(all)
}

/// The indices of rows that are certainly linearly independent of all rows before them.
pub(super) fn independent<R: Pivot>(rows: &[Vec<R>]) -> Vec<usize> {
    let mut known: Vec<(usize, Vec<R>)> = Vec::new();
    let mut all = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        let mut left = row.clone();
        for (pivot, own) in &known {
            let Some(factor) = left[*pivot].over(&own[*pivot]) else { continue };
            left.iter_mut().zip(own).for_each(|(entry, own)| *entry = entry.minus(&own.times(&factor)));
        }
        let pivot = (0..left.len()).max_by(|&a, &b| left[a].weight().total_cmp(&left[b].weight()));
        if let Some(pivot) = pivot.filter(|&pivot| left[pivot].weight() > 0.0) {
            known.push((pivot, left));
            all.push(number);
        }
    }
    all
}
