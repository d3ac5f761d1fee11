//! Numerical rank test of the equations of motion: accelerations are determined by the mass matrix alone, by the mass matrix with
//! constraints, or not at all. The second case is the first equation, and the third case the second equation, for some u other than zero:
//!
//!   M u = 0    or    [ M  J^T ; J  0 ] (u, lambda) = 0
//!
//! Example: the mass matrix of a point mass ahead of a knife edge is singular everywhere because of cos^2 + sin^2 = 1, which no single
//! entry shows. Ranks are computed in double-double arithmetic, with the values of the parameters, at a few states near the start. A pivot
//! that is rounding error at these states is taken as zero at all states.

use super::linear_equations;
use crate::elimination::MOST_WRITTEN;
use crate::letters::Letters;
use algebra::linear::{Magnitude, Pattern};
use field::DoubleDouble;
use model::equations::Equations;
use model::{Model, Trace};
use simulation::Program;
use symbolic::{Sym, apart};

/// Distances of the test states from the start, relative to the size of each component.
const ASIDE: [f64; 4] = [0.5, 0.3, 0.01, 0.003];

/// A pivot below this value is a rounding error, if rows and columns are scaled to the size one.
const ROUNDED: f64 = 1e-23;

/// Iterations of the scaling of rows and columns to the size one (Ruiz 2001).
const ROUNDS: usize = 20;

/// The result of the rank test of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Inertia {
    /// The mass matrix is regular on the speeds that appear in it; or the test was not possible.
    Resists,
    /// Some combination of speeds has no inertia, but the constraints determine it.
    Held,
    /// Some combination of speeds, among them `speed`, has no inertia, and no constraint determines it.
    Open { speed: usize },
}

impl Inertia {
    /// Tests a model whose law does not change and whose parameters have values.
    pub fn of(model: &Model) -> Self {
        let (n, m) = (model.speeds(), model.constraints.len());
        if n == 0 || n + m > MOST_WRITTEN || !model.algebraic_speeds.is_empty() {
            return Inertia::Resists;
        }
        Everywhere::of(model).map_or(Inertia::Resists, |everywhere| everywhere.inertia(&model.start_state()))
    }
}

/// The matrix of the equations of motion as a function of the state.
struct Everywhere {
    program: Program,
    pattern: Pattern,
    /// The number of speeds, and the indices of those with a nonzero row of the mass matrix.
    speeds: usize,
    inertial: Vec<usize>,
}

impl Everywhere {
    fn of(model: &Model) -> Option<Self> {
        let inertial: Vec<usize> = apart(|| {
            let Equations { mass, .. } = Equations::of(&Trace::of(model));
            (0..mass.len()).filter(|&row| mass[row].iter().any(|entry| *entry != Sym::ZERO)).collect()
        });
        let mut pattern = None;
        let program = Program::of(model.positions() + model.speeds(), |time, state| {
            let solve = linear_equations(&Trace::of(model), Letters::with_data(time, state));
            pattern = Some(solve.pattern);
            solve.entries
        })?;
        Some(Everywhere { program, pattern: pattern?, speeds: model.speeds(), inertial })
    }

    fn inertia(&self, start: &[f64]) -> Inertia {
        let (n, size) = (self.speeds, self.pattern.size());
        let found: Vec<Vec<Vec<DoubleDouble>>> =
            (0..ASIDE.len()).filter_map(|place| self.beside(start, place)).collect();
        if found.len() < 2 {
            return Inertia::Resists;
        }
        let is_singular = |matrix: &Vec<Vec<DoubleDouble>>| {
            pivots(part(matrix, &self.inertial, &self.inertial)).len() < self.inertial.len()
        };
        let [speeds, multipliers]: [Vec<usize>; 2] = [(0..n).collect(), (n..size).collect()];
        // multipliers of redundant constraints are undetermined in any case
        let open = |matrix: &Vec<Vec<DoubleDouble>>| {
            let columns = pivots(matrix.clone());
            let independent = pivots(part(matrix, &multipliers, &speeds)).len();
            let left = speeds.iter().find(|speed| !columns.contains(speed)).copied();
            (columns.len() < n + independent).then(|| left.unwrap_or(0))
        };
        if let Some(speeds) = found.iter().map(open).collect::<Option<Vec<usize>>>() {
            return Inertia::Open { speed: speeds[0] };
        }
        if found.iter().all(is_singular) { Inertia::Held } else { Inertia::Resists }
    }

    /// The matrix at test state number `place` near the start; `None` if an entry is not finite.
    fn beside(&self, start: &[f64], place: usize) -> Option<Vec<Vec<DoubleDouble>>> {
        let aside =
            |component: usize| ASIDE[place] * (0.5 + ((component * 7 + place * 3 + 1) as f64 * 0.618_034).fract());
        let state: Vec<DoubleDouble> = start
            .iter()
            .enumerate()
            .map(|(component, &value)| DoubleDouble::from(value + aside(component) * (1.0 + value.abs())))
            .collect();
        let mut entries = vec![DoubleDouble::from(f64::NAN); self.pattern.places().len()];
        self.program.run(DoubleDouble::from(aside(start.len())), &state, &mut entries)?;
        let size = self.pattern.size();
        let mut matrix = vec![vec![DoubleDouble::from(0.0); size]; size];
        for (&(row, column), entry) in self.pattern.places().iter().zip(entries) {
            if !entry.magnitude().is_finite() {
                return None;
            }
            matrix[row][column] = entry;
        }
        Some(matrix)
    }
}

/// The submatrix of some rows and columns.
fn part(matrix: &[Vec<DoubleDouble>], rows: &[usize], columns: &[usize]) -> Vec<Vec<DoubleDouble>> {
    rows.iter().map(|&row| columns.iter().map(|&column| matrix[row][column]).collect()).collect()
}

/// The columns of the pivots of Gaussian elimination with complete pivoting; their number is the rank.
fn pivots(mut matrix: Vec<Vec<DoubleDouble>>) -> Vec<usize> {
    let columns = matrix.first().map_or(0, Vec::len);
    scale(&mut matrix);
    let mut found = Vec::new();
    while found.len() < matrix.len().min(columns) {
        let done = found.len();
        let places = (done..matrix.len()).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let size = |&(row, column): &(usize, usize)| matrix[row][column].magnitude();
        let Some((row, column)) =
            places.filter(|(_, column)| !found.contains(column)).max_by(|a, b| size(a).total_cmp(&size(b)))
        else {
            break;
        };
        if size(&(row, column)) < ROUNDED {
            break;
        }
        matrix.swap(done, row);
        let (above, below) = matrix.split_at_mut(done + 1);
        let pivot = &above[done];
        for row in below {
            let factor = row[column] / pivot[column];
            row.iter_mut().zip(pivot).for_each(|(entry, &above)| *entry -= factor * above);
        }
        found.push(column);
    }
    found
}

/// Scales rows and columns of a matrix to the size one by powers of two (Ruiz 2001).
fn scale(matrix: &mut [Vec<DoubleDouble>]) {
    let columns = matrix.first().map_or(0, Vec::len);
    let by = |largest: f64| if largest > 0.0 { (-largest.log2() / 2.0).round().exp2() } else { 1.0 };
    for _ in 0..ROUNDS {
        let rows: Vec<f64> =
            matrix.iter().map(|row| by(row.iter().fold(0.0, |most: f64, entry| most.max(entry.magnitude())))).collect();
        let of_column = |column: usize| matrix.iter().fold(0.0, |most: f64, row| most.max(row[column].magnitude()));
        let beside: Vec<f64> = (0..columns).map(|column| by(of_column(column))).collect();
        for (row, own) in matrix.iter_mut().zip(&rows) {
            row.iter_mut().zip(&beside).for_each(|(entry, other)| *entry *= DoubleDouble::from(own * other));
        }
    }
}
