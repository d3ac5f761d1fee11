//! LU factorisation of sparse matrices, with rank.

use super::magnitude::{Kind, Magnitude};
use super::order::{Order, Step};
use super::pattern::Pattern;
use std::fmt;
use std::sync::Arc;

/// Pivots below this relative size are rounding.
const RANK: f64 = 1e-11;

/// The largest multiple of a scaled pivot row in the elimination order of the pattern. If it is exceeded, pivots are
/// chosen by size.
const MOST_TIMES: f64 = 1e3;

/// The reason why equations have no solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotSolved {
    /// The unknown with this index is undetermined.
    Undetermined(usize),
    /// An entry is NaN.
    NotANumber,
}

impl fmt::Display for NotSolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotSolved::Undetermined(unknown) => write!(f, "nothing determines unknown {}", unknown + 1),
            NotSolved::NotANumber => write!(f, "an entry of the equations has no value"),
        }
    }
}

impl std::error::Error for NotSolved {}

/// The factorisation of a matrix with a given pattern, and its buffers: factoring and solving do not allocate.
#[derive(Clone, Debug)]
pub struct Factors<S> {
    determined: usize,
    places: Vec<(usize, usize)>,
    order: Arc<Order>,
    /// The matrix row by row, in elimination order: multipliers below the diagonal, the upper factor elsewhere.
    matrix: Vec<S>,
    /// The scale factors of rows and columns, in elimination order: powers of two near the inverse square root of the
    /// largest entry. For a symmetric matrix rows and columns have equal factors.
    scales: [Vec<f64>; 2],
    way: Way,
    /// The rows and the columns in elimination order, where pivots were chosen by size.
    by_size: [Vec<usize>; 2],
    /// Buffer for reordered numbers.
    moved: Vec<S>,
}

/// The choice of pivots in the last factorisation.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    InOrder,
    /// By size, with the rank of the matrix.
    BySize {
        rank: usize,
    },
    Failed,
}

impl<S: Magnitude> Factors<S> {
    /// Buffers for matrices with a pattern.
    pub fn new(pattern: &Pattern) -> Self {
        let size = pattern.size();
        Factors {
            determined: pattern.determined(),
            places: pattern.places().to_vec(),
            order: Arc::clone(pattern.order()),
            matrix: vec![S::zero(); size * size],
            scales: [vec![1.0; size], vec![1.0; size]],
            way: Way::Failed,
            by_size: [vec![0; size], vec![0; size]],
            moved: vec![S::zero(); size],
        }
    }

    /// Factorises the matrix with the given entries, in the order of the pattern.
    ///
    /// # Errors
    /// [`NotSolved`] where an unknown that must be determined is not, or an entry is NaN.
    #[inline(always)]
    pub fn factor(&mut self, entries: &[S]) -> Result<(), NotSolved> {
        self.load(entries);
        self.way = Way::Failed;
        if self.in_order() {
            self.way = Way::InOrder;
            return Ok(());
        }
        self.factor_by_size(entries)
    }

    #[inline(always)]
    fn load(&mut self, entries: &[S]) {
        let size = self.moved.len();
        self.matrix.fill(S::zero());
        self.scales.iter_mut().for_each(|scales| scales.fill(0.0));
        for (&(row, column), &entry) in self.places.iter().zip(entries) {
            let (row, column) = (self.order.row_places[row], self.order.column_places[column]);
            self.matrix[row * size + column] = entry;
            let magnitude = entry.magnitude();
            for (scales, place) in self.scales.iter_mut().zip([row, column]) {
                scales[place] = if magnitude > scales[place] { magnitude } else { scales[place] };
            }
        }
        for scale in self.scales.iter_mut().flatten() {
            *scale = measure(*scale);
        }
    }

    /// Eliminates in the order of the pattern. Returns whether all pivots are large enough.
    #[inline(always)]
    fn in_order(&mut self) -> bool {
        let size = self.moved.len();
        let is_exact = S::KIND == Kind::Exact;
        let least = if is_exact { 0.0 } else { RANK };
        let Factors { matrix, order, scales: [of_rows, of_columns], .. } = self;
        for (k, Step { below, across }) in order.steps.iter().enumerate() {
            let (above, rest) = matrix.split_at_mut((k + 1) * size);
            let pivots = &above[k * size..];
            let pivot = pivots[k];
            let is_enough = pivot.magnitude() * (of_rows[k] * of_columns[k]) > least;
            if !is_enough {
                return false;
            }
            let most = if is_exact { f64::INFINITY } else { MOST_TIMES * of_rows[k] };
            for &row in below {
                let scale = of_rows[row];
                let row = &mut rest[(row - k - 1) * size..][..size];
                let times = row[k] / pivot;
                let is_stable = times.magnitude() * scale <= most;
                if !is_stable {
                    return false;
                }
                row[k] = times;
                for &(from, to) in across {
                    for (entry, &above) in row[from..to].iter_mut().zip(&pivots[from..to]) {
                        *entry = entry.less_product(times, above);
                    }
                }
            }
        }
        true
    }

    /// Factorises with the largest remaining entry as the next pivot.
    #[inline(never)]
    fn factor_by_size(&mut self, entries: &[S]) -> Result<(), NotSolved> {
        self.load(entries);
        let size = self.moved.len();
        let Factors { matrix, scales: [of_rows, of_columns], by_size: [rows, columns], order, .. } = self;
        rows.copy_from_slice(&order.rows);
        columns.copy_from_slice(&order.columns);
        let (mut rank, mut first) = (size, 0.0);
        for k in 0..size {
            let (mut row, mut column, mut largest) = (k, k, -1.0);
            for i in k..size {
                for j in k..size {
                    let entry = matrix[i * size + j].magnitude() * (of_rows[i] * of_columns[j]);
                    if entry.is_nan() {
                        return Err(NotSolved::NotANumber);
                    }
                    if entry > largest {
                        (row, column, largest) = (i, j, entry);
                    }
                }
            }
            if k == 0 {
                first = largest;
            }
            let least = if S::KIND == Kind::Rounded { RANK * first } else { 0.0 };
            if largest <= least {
                // the free unknowns, and the consistency of the equations, might differ among the enclosed matrices
                if S::KIND == Kind::Enclosed {
                    return Err(NotSolved::Undetermined(columns[k]));
                }
                rank = k;
                break;
            }
            for j in 0..size {
                matrix.swap(k * size + j, row * size + j);
            }
            for i in 0..size {
                matrix.swap(i * size + k, i * size + column);
            }
            rows.swap(k, row);
            columns.swap(k, column);
            of_rows.swap(k, row);
            of_columns.swap(k, column);
            let (above, below) = matrix.split_at_mut((k + 1) * size);
            let pivots = &above[k * size..];
            for row in below.chunks_exact_mut(size) {
                if row[k].is_zero() {
                    continue;
                }
                let times = row[k] / pivots[k];
                row[k] = times;
                for (entry, &above) in row[k + 1..].iter_mut().zip(&pivots[k + 1..]) {
                    *entry = entry.less_product(times, above);
                }
            }
        }
        // only unknowns that need not be determined may be free
        if let Some(&free) = columns[rank..].iter().find(|column| **column < self.determined) {
            return Err(NotSolved::Undetermined(free));
        }
        self.way = Way::BySize { rank };
        Ok(())
    }

    /// Replaces the right-hand side by the solution with the last factorisation; without one it is unchanged.
    #[inline(always)]
    pub fn solve(&mut self, right: &mut [S]) {
        let size = self.moved.len();
        match self.way {
            Way::InOrder => {
                let Factors { matrix, moved, order, .. } = self;
                for (place, &row) in moved.iter_mut().zip(&order.rows) {
                    *place = right[row];
                }
                for (k, step) in order.steps.iter().enumerate() {
                    let known = moved[k];
                    for &row in &step.below {
                        moved[row] = moved[row].less_product(matrix[row * size + k], known);
                    }
                }
                for (k, step) in order.steps.iter().enumerate().rev() {
                    let row = &matrix[k * size..][..size];
                    let mut rest = moved[k];
                    for &(from, to) in &step.across {
                        for (&entry, &known) in row[from..to].iter().zip(&moved[from..to]) {
                            rest = rest.less_product(entry, known);
                        }
                    }
                    moved[k] = rest / row[k];
                }
                for (&value, &column) in moved.iter().zip(&order.columns) {
                    right[column] = value;
                }
            }
            Way::BySize { rank } => self.solve_by_size(right, rank),
            Way::Failed => {}
        }
    }

    #[inline(never)]
    fn solve_by_size(&mut self, right: &mut [S], rank: usize) {
        let size = self.moved.len();
        let Factors { matrix, moved, by_size: [rows, columns], .. } = self;
        for (place, &row) in moved.iter_mut().zip(&*rows) {
            *place = right[row];
        }
        for k in 0..rank {
            let (above, below) = moved.split_at_mut(k + 1);
            for (row, rest) in below.iter_mut().enumerate() {
                *rest = rest.less_product(matrix[(k + 1 + row) * size + k], above[k]);
            }
        }
        // free unknowns are zero
        moved[rank..].fill(S::zero());
        for k in (0..rank).rev() {
            let row = &matrix[k * size..][..size];
            let rest = (k + 1..rank).fold(moved[k], |rest, j| rest.less_product(row[j], moved[j]));
            moved[k] = rest / row[k];
        }
        for (&value, &column) in moved.iter().zip(&*columns) {
            right[column] = value;
        }
    }
}

/// The inverse square root of a size, rounded to a power of two by its exponent: a logarithm would cost as much as a
/// small elimination.
#[inline(always)]
fn measure(largest: f64) -> f64 {
    const BIAS: i64 = 1023;
    let exponent = (largest.to_bits() >> 52) as i64 - BIAS;
    let half = (exponent + 1).div_euclid(2);
    if largest > 0.0 && largest < f64::INFINITY { f64::from_bits(((BIAS - half) as u64) << 52) } else { 1.0 }
}

#[cfg(test)]
mod tests;
