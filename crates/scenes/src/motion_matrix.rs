//! Numeric values of the linear equations for the accelerations u' and the multipliers lambda at a state:
//!
//!   [ M  J^T ] [   u'    ]   [ -h ]
//!   [ J   0  ] [ -lambda ] = [ -c ]

use crate::implicit::linear_equations;
use crate::letters::Letters;
use crate::modes::{Case, Mode};
use model::{Model, Trace};
use nalgebra::DMatrix;
use simulation::Program;
use symbolic::{Sym, substitute_all};

/// Singular values below this multiple of the largest one count as zero.
const RANK: f64 = 1e-11;

/// Compiled matrix and right side of these equations for a model in one mode.
pub(crate) struct MotionMatrix {
    program: Program,
    /// Row and column of each entry that is not identically zero.
    places: Vec<(usize, usize)>,
    size: usize,
}

impl MotionMatrix {
    /// Compiles the matrix and the right side; `None` where an expression of them cannot be evaluated, for lack of a value.
    pub fn of(model: &Model, mode: &Mode) -> Option<Self> {
        let mut pattern = None;
        let program = Program::of(model.positions() + model.speeds(), |time, state| {
            let trace = Trace::of(model);
            let solve = linear_equations(&trace, Letters::with_data(time, state));
            let all = solve.expressions();
            pattern = Some(solve.pattern);
            let case = |case: &Case| if *case == Case::On { Sym::ONE } else { Sym::ZERO };
            let cases: Vec<(Sym, Sym)> = trace.switches.iter().copied().zip(mode.cases.iter().map(case)).collect();
            substitute_all(&all, &cases)
        })?;
        let pattern = pattern?;
        Some(MotionMatrix { program, places: pattern.places().to_vec(), size: pattern.size() })
    }

    /// The matrix and the right side at a state (coordinates, then speeds) and a time in seconds; `None` where the evaluation fails.
    pub fn at(&self, time: f64, state: &[f64]) -> Option<Terms> {
        let MotionMatrix { program, places, size } = self;
        let mut found = vec![f64::NAN; places.len() + size];
        program.run(time, state, &mut found)?;
        let right = found.split_off(places.len());
        let mut matrix = vec![0.0; size * size];
        places.iter().zip(found).for_each(|(&(row, column), entry)| matrix[row * size + column] = entry);
        Some(Terms { size: *size, matrix, right })
    }
}

/// The matrix and the right side at one state.
pub(crate) struct Terms {
    /// The number of rows and columns: speeds and constraints.
    pub size: usize,
    /// The entries, row by row; `size` rows and columns.
    pub matrix: Vec<f64>,
    /// The right side: -h, then -c.
    pub right: Vec<f64>,
}

impl Terms {
    /// The mass matrix M of a model with n speeds.
    pub fn mass(&self, n: usize) -> DMatrix<f64> {
        DMatrix::from_fn(n, n, |i, j| self.matrix[i * self.size + j])
    }

    /// The first n components of a null vector of the matrix; `None` where the matrix is regular or these components are zero.
    pub fn free(&self, n: usize) -> Option<Vec<f64>> {
        // the singular value decomposition does not end for NaN
        if !self.matrix.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let decomposed = DMatrix::from_row_slice(self.size, self.size, &self.matrix).svd(false, true);
        let (least, smallest) = decomposed.singular_values.argmin();
        if smallest > RANK * decomposed.singular_values.amax() {
            return None;
        }
        let direction: Vec<f64> = decomposed.v_t.as_ref()?.row(least).iter().take(n).copied().collect();
        direction.iter().any(|part| *part != 0.0).then_some(direction)
    }

    /// The blocks M (n rows) and J (one row for each constraint) of a system with n speeds.
    pub fn blocks(&self, n: usize) -> [DMatrix<f64>; 2] {
        let whole = DMatrix::from_row_slice(self.size, self.size, &self.matrix);
        [whole.view((0, 0), (n, n)).into_owned(), whole.view((n, 0), (self.size - n, n)).into_owned()]
    }
}
