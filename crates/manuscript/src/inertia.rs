//! The matrix of the equations that are linear in accelerations and reactions. Where it is singular a model has no inertia along some direction, or its
//! coordinates have a pole.

use crate::determinant::determinant;
use model::Trace;
use model::equations::Equations;
use symbolic::Sym;

/// Determinants of more rows are not expanded.
const MOST_ROWS: usize = 7;

/// Its determinant; none where it is large.
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
