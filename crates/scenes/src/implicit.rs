//! Accelerations by a solve at each evaluation, with pivots: for systems whose elimination, written down, would be too long, and for
//! coordinates without inertia that constraints move.
//!
//!   [ M  J^T ] [   u'    ]   [ -h ]
//!   [ J   0  ] [ -lambda ] = [ -c ]
//!
//! The matrix is scaled symmetrically, and the largest entry of what is left is the next pivot. Where nothing is left but rounding,
//! the remaining unknowns are multipliers of constraints that others imply: they are zero.

use crate::compiled_system::{NotCompiled, values};
use derivations::taped::{Program, Running};
use field::{Analytic, DoubleDouble};
use integrators::{Directions, Ode, System};
use model::equations::Equations;
use model::{Model, Trace};
use std::sync::{Arc, Mutex, PoisonError};
use symbolic::{Sym, substitute_all};

/// Pivots below this part of the largest are rounding.
const RANK: f64 = 1e-11;

/// A law whose accelerations are solved for.
#[derive(Debug)]
pub(crate) struct Implicit {
    model: Arc<Model>,
    /// The upper triangle of M, -h, the rows of J, -c.
    program: Program,
    speeds: usize,
    constraints: usize,
    plain: Pool<f64>,
    slopes: Pool<Directions>,
    exact: Pool<DoubleDouble>,
}

/// Room for evaluations that run at the same time.
#[derive(Debug)]
struct Pool<S>(Mutex<Vec<Room<S>>>);

impl<S> Default for Pool<S> {
    fn default() -> Self {
        Pool(Mutex::new(Vec::new()))
    }
}

/// Room for one evaluation.
#[derive(Debug)]
struct Room<S> {
    written: Vec<S>,
    /// Row after row.
    matrix: Vec<S>,
    right: Vec<S>,
    ordered: Vec<S>,
    scale: Vec<f64>,
    /// Which unknown each column holds.
    columns: Vec<usize>,
}

impl Implicit {
    /// The law of a model without conditions whose parameters have values.
    pub fn of(model: &Arc<Model>) -> Result<Self, NotCompiled> {
        let speeds = model.speeds();
        let mut constraints = 0;
        let program = Program::of_any_length(model.positions() + speeds, |time, state| {
            let trace = Trace::of(model);
            let equations = Equations::of(&trace);
            constraints = equations.constraints.len();
            let upper = (0..speeds).flat_map(|i| equations.mass[i][i..].iter().copied());
            let forces = equations.bias.iter().map(|bias| -*bias);
            let rows = equations.constraints.iter().flat_map(|one| one.row.iter().copied());
            let rest = equations.constraints.iter().map(|one| -one.bias);
            let all: Vec<Sym> = upper.chain(forces).chain(rows).chain(rest).collect();
            substitute_all(&all, &values(&trace, time, state))
        });
        let program = program.ok_or(NotCompiled::TooLong)?;
        let (plain, slopes, exact) = (Pool::default(), Pool::default(), Pool::default());
        Ok(Implicit { model: Arc::clone(model), program, speeds, constraints, plain, slopes, exact })
    }

    /// The length of [`Self::extend`].
    pub fn extended(&self) -> usize {
        self.model.positions() + 2 * self.speeds + self.constraints
    }

    /// The state with the accelerations and the multipliers behind it; no numbers where they are not determined.
    pub fn extend(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut extended = state.to_vec();
        extended.resize(self.extended(), f64::NAN);
        let shown = self.solve(&self.plain, time, state, |found| {
            let (accelerations, multipliers) = extended[state.len()..].split_at_mut(self.speeds);
            accelerations.copy_from_slice(&found[..self.speeds]);
            multipliers.iter_mut().zip(&found[self.speeds..]).for_each(|(lambda, less)| *lambda = -less);
        });
        // what is not determined stays no number
        shown.unwrap_or(());
        extended
    }

    /// Shows the accelerations and the negative multipliers, where they are determined.
    fn solve<S: Field>(&self, pool: &Pool<S>, t: S, y: &[S], show: impl FnOnce(&[S])) -> Result<(), Option<usize>> {
        let (n, m) = (self.speeds, self.constraints);
        let size = n + m;
        let taken = pool.0.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut room = taken.unwrap_or_else(|| Room {
            written: vec![S::zero(); n * (n + 1) / 2 + n + m * n + m],
            matrix: vec![S::zero(); size * size],
            right: vec![S::zero(); size],
            ordered: vec![S::zero(); size],
            scale: vec![0.0; size],
            columns: (0..size).collect(),
        });
        let made = self.program.run(t, y, &mut room.written);
        room.fill(n, m);
        let solved = made.ok_or(None).and_then(|()| room.solved(n));
        if solved.is_ok() {
            show(&room.right);
        }
        pool.0.lock().unwrap_or_else(PoisonError::into_inner).push(room);
        solved
    }
}

impl<S: Field> Room<S> {
    /// The matrix and the right side, scaled: entries of a row and its column are divided by the root of the row's largest.
    fn fill(&mut self, n: usize, m: usize) {
        let size = n + m;
        let (upper, rest) = self.written.split_at(n * (n + 1) / 2);
        let (forces, rest) = rest.split_at(n);
        let (rows, biases) = rest.split_at(m * n);
        let mut entries = upper.iter();
        for i in 0..n {
            for (j, entry) in (i..n).zip(entries.by_ref()) {
                (self.matrix[i * size + j], self.matrix[j * size + i]) = (*entry, *entry);
            }
        }
        for k in 0..m {
            for j in 0..n {
                let entry = rows[k * n + j];
                (self.matrix[(n + k) * size + j], self.matrix[j * size + n + k]) = (entry, entry);
            }
            self.matrix[(n + k) * size + n..][..m].fill(S::zero());
        }
        self.right[..n].copy_from_slice(forces);
        self.right[n..].copy_from_slice(biases);
        for (row, scale) in self.matrix.chunks_exact(size).zip(&mut self.scale) {
            let largest = row.iter().fold(0.0, |largest: f64, entry| largest.max(entry.size()));
            // a power of two, which rounds nothing
            *scale = if largest > 0.0 { (-(largest.log2() / 2.0).round()).exp2() } else { 1.0 };
        }
        for i in 0..size {
            for j in 0..size {
                self.matrix[i * size + j] = self.matrix[i * size + j].scaled(self.scale[i] * self.scale[j]);
            }
            self.right[i] = self.right[i].scaled(self.scale[i]);
        }
    }

    /// The unknowns in the place of the right side.
    ///
    /// # Errors
    /// One of the first n that is not determined, where there is one, or none where a number is missing.
    fn solved(&mut self, n: usize) -> Result<(), Option<usize>> {
        let size = self.right.len();
        self.columns.iter_mut().enumerate().for_each(|(place, column)| *column = place);
        let (mut rank, mut first) = (size, 0.0);
        for step in 0..size {
            let (mut row, mut column, mut largest) = (step, step, -1.0);
            for i in step..size {
                for j in step..size {
                    let entry = self.matrix[i * size + j].size();
                    if entry.is_nan() {
                        return Err(None);
                    }
                    if entry > largest {
                        (row, column, largest) = (i, j, entry);
                    }
                }
            }
            if step == 0 {
                first = largest;
            }
            if largest <= RANK * first {
                rank = step;
                break;
            }
            for j in 0..size {
                self.matrix.swap(step * size + j, row * size + j);
            }
            self.right.swap(step, row);
            for i in 0..size {
                self.matrix.swap(i * size + step, i * size + column);
            }
            self.columns.swap(step, column);
            let (above, below) = self.matrix.split_at_mut((step + 1) * size);
            let pivots = &above[step * size..];
            for (i, row) in below.chunks_exact_mut(size).enumerate() {
                if row[step].is_zero() {
                    continue;
                }
                let factor = row[step] / pivots[step];
                for j in step + 1..size {
                    row[j] -= factor * pivots[j];
                }
                let part = factor * self.right[step];
                self.right[step + 1 + i] -= part;
            }
        }
        // what is left free must be a multiplier
        if let Some(&free) = self.columns[rank..].iter().find(|column| **column < n) {
            return Err(Some(free));
        }
        self.right[rank..].fill(S::zero());
        for step in (0..rank).rev() {
            let row = &self.matrix[step * size..][..size];
            let known = (step + 1..rank).fold(self.right[step], |rest, j| rest - row[j] * self.right[j]);
            self.right[step] = known / row[step];
        }
        // back in the order of the unknowns
        self.ordered.clone_from_slice(&self.right);
        for (value, &column) in self.ordered.iter().zip(&self.columns) {
            self.right[column] = value.scaled(self.scale[column]);
        }
        Ok(())
    }
}

/// A field whose numbers have a size.
trait Field: Analytic + Running {
    fn size(self) -> f64;

    /// Times a power of two.
    fn scaled(self, factor: f64) -> Self;
}

impl Field for f64 {
    fn size(self) -> f64 {
        self.abs()
    }

    fn scaled(self, factor: f64) -> Self {
        self * factor
    }
}

impl Field for Directions {
    fn size(self) -> f64 {
        self.re.abs()
    }

    fn scaled(self, factor: f64) -> Self {
        self * factor
    }
}

impl Field for DoubleDouble {
    fn size(self) -> f64 {
        self.hi().abs()
    }

    fn scaled(self, factor: f64) -> Self {
        self * DoubleDouble::from(factor)
    }
}

macro_rules! runs {
    ($($field:ty: $pool:ident),*) => {$(
        impl Ode<$field> for Implicit {
            fn dimension(&self) -> usize {
                self.model.positions() + self.speeds
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                let (rates, accelerations) = dy.split_at_mut(self.model.positions());
                self.model.position_rates(y, rates);
                accelerations.fill(<$field>::from(f64::NAN));
                let shown =
                    self.solve(&self.$pool, t, y, |found| accelerations.copy_from_slice(&found[..self.speeds]));
                shown.unwrap_or(());
            }
        }
    )*};
}
runs!(f64: plain, Directions: slopes, DoubleDouble: exact);

impl System for Implicit {}
