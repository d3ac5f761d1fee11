//! Equations of motion as linear equations for accelerations u' and multipliers λ:
//!
//!   [ M  J^T ] [   u'    ]   [ -h ]
//!   [ J   0  ] [ -lambda ] = [ -c ]

use crate::letters::Letters;
use model::Trace;
use model::equations::{Equations, constraints_of};
use symbolic::Sym;
use symbolic::linear::Solve;

/// The linear equations of a trace over `letters`. The accelerations must be determined by them; multipliers of redundant constraints
/// need not.
pub(crate) fn linear_equations(trace: &Trace<'_>, letters: Letters<'_>) -> Solve {
    let Equations { mass, bias, constraints } = Equations::of(trace);
    let (n, m) = (bias.len(), constraints.len());
    let upper = (0..n).flat_map(|i| mass[i][i..].iter().copied());
    let rows = constraints.iter().flat_map(|one| one.row.iter().copied());
    let right = bias.iter().map(|bias| -*bias).chain(constraints.iter().map(|one| -one.bias));
    let mut all = letters.put_into(trace, &upper.chain(rows).chain(right).collect::<Vec<Sym>>());
    let right = all.split_off(n * (n + 1) / 2 + m * n);
    let entry = |row: usize, column: usize| match (row.min(column), row.max(column)) {
        (i, j) if j < n => all[i * n - i * (i + 1) / 2 + j],
        (i, j) if i < n => all[n * (n + 1) / 2 + (j - n) * n + i],
        _ => Sym::ZERO,
    };
    let unknowns = (0..n + m).map(|k| Sym::symbol(&format!("z{k}"))).collect();
    Solve::new(unknowns, n, entry, right)
}

/// Substitutions: symbols of accelerations and multipliers, in this order, by `inputs`.
pub(crate) fn unknown_letters(trace: &Trace<'_>, inputs: &[Sym]) -> Vec<(Sym, Sym)> {
    let multipliers = constraints_of(trace).into_iter().map(|one| one.multiplier);
    trace.accelerations.iter().copied().chain(multipliers).zip(inputs.iter().copied()).collect()
}
