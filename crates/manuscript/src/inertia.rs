//! The matrix of the equations of motion, which are linear in accelerations and reactions. Where it is singular, the model has no inertia in some
//! direction, or its coordinates have a singular position (a pole).

use crate::determinant::determinant;
use model::Trace;
use model::equations::Equations;
use symbolic::Sym;

/// The largest number of rows of a determinant that is expanded.
const MOST_ROWS: usize = 7;

/// The determinant of this matrix; `None` if the matrix is too large.
pub(crate) fn inertia_determinant(trace: &Trace<'_>) -> Option<Sym> {
    let Equations { mass, constraints, .. } = Equations::of(trace);
    let above = mass.iter().enumerate().map(|(k, row)| {
        let reactions = constraints.iter().map(|one| one.row[k]);
        row.iter().copied().chain(reactions).collect()
    });
    let zeros = || constraints.iter().map(|_| Sym::ZERO);
    let below = constraints.iter().map(|one| one.row.iter().copied().chain(zeros()).collect());
    let matrix: Vec<Vec<Sym>> = above.chain(below).collect();
    (matrix.len() <= MOST_ROWS).then(|| determinant(&matrix))
}
