//! Elimination of the dependent speeds of nonholonomic constraints, by Cramer's rule.

use algebra::linear::minors;
use model::Trace;
use model::equations::{Equation, vanishes};
use symbolic::{Sym, Tape, substitute_all};

/// Largest number of constraints of speeds, relations of quasi-velocities among them, that are solved symbolically.
const MOST_SOLVED: usize = 6;

/// Largest number of choices of dependent speeds that are compared.
const MOST_COMPARED: usize = 16;

/// A choice is singular at a state if its determinant is below this fraction of the largest one.
const REGULAR: f64 = 1e-3;

/// Preferences for the choice of independent speeds.
pub(super) struct Wanted<'a> {
    /// Indices of speeds that should remain independent if possible.
    pub free: Vec<usize>,
    /// A state at which the determinant should not vanish. It must not vanish if `is_near`, for a motion near this state.
    pub state: &'a [f64],
    pub is_near: bool,
}

/// The dependent speeds in terms of the others, and whether the determinant is not zero at the state.
pub(super) struct Solution {
    pub determined: Vec<(usize, Sym)>,
    pub is_regular: bool,
}

/// Solutions that keep the largest number of wanted speeds independent; those regular at the state come first. `None` if constraints are not
/// linear in the speeds, or if there are too many.
pub(super) fn solutions(
    trace: &Trace<'_>,
    (of_speeds, residuals, zeros_of_positions): (&[Equation], &[Sym], &[Sym]),
    wanted: &Wanted<'_>,
    put: impl Fn(&[Sym]) -> Vec<Sym>,
) -> Option<Vec<Solution>> {
    let n = trace.speeds.len();
    let rows: Vec<Vec<Sym>> = of_speeds.iter().map(|one| put(&one.row)).collect();
    let is_linear = |slope: &Sym| slope.symbols_of().iter().all(|symbol| !trace.speeds.contains(symbol));
    if of_speeds.len() > MOST_SOLVED || !rows.iter().flatten().all(is_linear) {
        return None;
    }
    let zeros = put(&of_speeds.iter().map(|one| one.zero).collect::<Vec<_>>());
    // coordinates that occur in no equation first, those in position constraints late, since these determine them
    let written: Vec<Sym> = residuals.iter().chain(rows.iter().flatten()).flat_map(|row| row.symbols_of()).collect();
    let held: Vec<Sym> = zeros_of_positions.iter().flat_map(|zero| zero.symbols_of()).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by_key(|&k| {
        let own = trace.coordinates[k];
        // a speed given at the start should remain independent
        let is_given = !wanted.is_near && wanted.state[trace.coordinates.len() + k] != 0.0;
        (wanted.free.contains(&k), is_given, held.contains(&own), written.contains(&own))
    });
    let all: Vec<(Vec<usize>, Sym)> = choices(&order, of_speeds.len())
        .into_iter()
        .map(|chosen| {
            let determinant = determinant(rows.len(), |row, column| rows[row][chosen[column]]);
            (chosen, determinant)
        })
        .collect();
    let sizes = sizes(trace, &all, wanted.state);
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    let is_regular = |place: usize| sizes[place] > REGULAR * largest;
    let lost = |place: usize| all[place].0.iter().filter(|k| wanted.free.contains(k)).count();
    let mut order: Vec<usize> = (0..all.len()).filter(|&place| !wanted.is_near || is_regular(place)).collect();
    order.sort_by_key(|&place| (lost(place), !is_regular(place)));
    let determines = |place: &usize| is_regular(*place) || !vanishes(all[*place].1);
    let least = order.iter().copied().find(|place| determines(place)).map_or(0, lost);
    let chosen = order.into_iter().filter(|&place| lost(place) == least && determines(&place)).take(MOST_COMPARED);
    let resting: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let right: Vec<Sym> = substitute_all(&zeros, &resting).into_iter().map(|zero| -zero).collect();
    let solved = |(chosen, below): &(Vec<usize>, Sym)| -> Vec<(usize, Sym)> {
        let quotient = |place: usize, of: &dyn Fn(usize) -> Sym| {
            let replaced =
                |row: usize, column: usize| if column == place { of(row) } else { rows[row][chosen[column]] };
            determinant(rows.len(), replaced) / *below
        };
        let others = || (0..n).filter(|other| !chosen.contains(other));
        let rate = |(place, &k): (usize, &usize)| {
            let by = |sum: Sym, other: usize| sum - quotient(place, &|row| rows[row][other]) * trace.speeds[other];
            (k, others().fold(quotient(place, &|row| right[row]), by))
        };
        chosen.iter().enumerate().map(rate).collect()
    };
    Some(chosen.map(|place| Solution { determined: solved(&all[place]), is_regular: is_regular(place) }).collect())
}

/// Absolute values of the determinants at a state; zero where they are not finite.
fn sizes(trace: &Trace<'_>, all: &[(Vec<usize>, Sym)], state: &[f64]) -> Vec<f64> {
    let inputs: Vec<Sym> = [&trace.coordinates[..], &[trace.time]].concat();
    let values: Vec<Sym> = all.iter().map(|(_, determinant)| *determinant).collect();
    let mut sizes = vec![0.0; all.len()];
    if let Ok(tape) = Tape::record(&inputs, &values) {
        let at: Vec<f64> = state[..trace.coordinates.len()].iter().copied().chain([0.0]).collect();
        tape.over::<f64>().evaluate(&at, &mut sizes);
    }
    sizes.iter().map(|size| if size.is_finite() { size.abs() } else { 0.0 }).collect()
}

fn determinant(size: usize, entry: impl Fn(usize, usize) -> Sym) -> Sym {
    minors(size, entry, size)[(1 << size) - 1]
}

/// All subsets of `count` elements, in lexicographic order.
fn choices(of: &[usize], count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let with = |first: usize| {
        choices(&of[first + 1..], count - 1).into_iter().map(move |rest| [&[of[first]], &rest[..]].concat())
    };
    (0..of.len()).flat_map(with).collect()
}
