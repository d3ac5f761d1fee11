//! Independent and dependent speeds of a system with constraints.
//!
//! With the rates J u + b = 0 of the constraints, the dependent speeds are u_d = A w + a, functions of the independent speeds w. Every admissible
//! displacement is a combination of the columns of N = du/dw, with J N = 0. The dependent speeds are the pivots of J at a random point, one for each
//! equation. Columns with short expressions are preferred, unless they cannot be pivots at the start.

use super::constraints::Equation;
use super::generic_point::pivots;
use crate::Trace;
use crate::presentation::simplified;
use crate::real_points::value_at_start;
use symbolic::{Sym, substitute_all};

/// The admissible directions of a system with constraints, and the equations that determine the dependent speeds.
#[derive(Clone, Debug)]
pub struct Characteristics {
    /// The indices of the independent speeds w.
    pub independent: Vec<usize>,
    /// For each dependent speed: its index, and the index of the equation that determines it.
    pub dependent: Vec<(usize, usize)>,
    /// The indices of equations that depend on earlier ones.
    pub redundant: Vec<usize>,
    /// The matrix A = du_d/dw: a row for each dependent speed, a column for each independent one.
    pub slopes: Vec<Vec<Sym>>,
    /// The rows of J, with short entries in normal form.
    rows: Vec<Vec<Sym>>,
}

impl Characteristics {
    /// Chooses independent and dependent speeds for the constraints of a trace.
    pub fn of(trace: &Trace<'_>, constraints: &[Equation]) -> Self {
        let row = |constraint: &Equation| constraint.row.iter().map(|&slope| in_short(slope)).collect();
        let rows: Vec<Vec<Sym>> = constraints.iter().map(row).collect();
        let mut order: Vec<usize> = (0..trace.speeds.len()).collect();
        order.sort_by_cached_key(|&i| {
            let column: Vec<Sym> = rows.iter().map(|row| row[i]).collect();
            Sym::operations_of(&column)
        });
        let generic = pivots(&rows, &order);
        let found = pivots_at_start(trace, &rows, &order)
            .filter(|found| found.iter().map(|(row, _)| row).eq(generic.iter().map(|(row, _)| row)))
            .unwrap_or(generic);
        let dependent: Vec<(usize, usize)> = found.iter().map(|&(row, column)| (column, row)).collect();
        let is_dependent = |i: &usize| dependent.iter().any(|(column, _)| column == i);
        let independent: Vec<usize> = (0..trace.speeds.len()).filter(|i| !is_dependent(i)).collect();
        let redundant = (0..rows.len()).filter(|row| found.iter().all(|(known, _)| known != row)).collect();
        let right = |row: usize| independent.iter().map(|&j| -rows[row][j]).collect::<Vec<Sym>>();
        let slopes = solved(&square(&rows, &dependent), dependent.iter().map(|&(_, row)| right(row)).collect());
        Characteristics { independent, dependent, redundant, slopes, rows }
    }

    /// Returns the columns of N. Each is the vector of all `speeds` speeds if one independent speed is one and the other independent ones are
    /// zero.
    pub fn directions(&self, speeds: usize) -> Vec<Vec<Sym>> {
        let of = |(place, &j): (usize, &usize)| {
            let mut direction = vec![Sym::ZERO; speeds];
            direction[j] = Sym::ONE;
            for (&(d, _), slopes) in self.dependent.iter().zip(&self.slopes) {
                direction[d] = slopes[place];
            }
            direction
        };
        self.independent.iter().enumerate().map(of).collect()
    }

    /// Returns N^T v for a vector v with one entry per speed.
    pub fn along(&self, values: &[Sym]) -> Vec<Sym> {
        let of = |(place, &j): (usize, &usize)| {
            let dependent = self.dependent.iter().zip(&self.slopes);
            dependent.fold(values[j], |sum, (&(d, _), slopes)| sum + slopes[place] * values[d])
        };
        self.independent.iter().enumerate().map(of).collect()
    }

    /// Eliminates multipliers: solves J^T lambda = v on the dependent speeds, and returns the entries of v - J^T lambda of the independent
    /// speeds.
    pub fn without_reactions(&self, values: &[Sym]) -> Vec<Sym> {
        let matrix = square(&self.rows, &self.dependent);
        let k = matrix.len();
        let transposed: Vec<Vec<Sym>> = (0..k).map(|i| (0..k).map(|j| matrix[j][i]).collect()).collect();
        let multipliers = solved(&transposed, self.dependent.iter().map(|&(d, _)| vec![values[d]]).collect());
        let reaction = |i: usize| {
            let terms = self.dependent.iter().zip(&multipliers);
            terms.fold(Sym::ZERO, |sum, (&(_, row), multiplier)| sum + multiplier[0] * self.rows[row][i])
        };
        self.independent.iter().map(|&j| values[j] - reaction(j)).collect()
    }

    /// Returns the dependent speeds and accelerations as functions of the independent ones.
    ///
    /// # Errors
    /// The index of the first constraint that is not linear in the speeds.
    pub fn motion(&self, trace: &Trace<'_>, constraints: &[Equation]) -> Result<SolvedMotion, usize> {
        let moves = |row: &Vec<Sym>| {
            let mut symbols = row.iter().flat_map(|slope| slope.symbols_of());
            symbols.any(|symbol| trace.speeds.contains(&symbol))
        };
        if let Some(place) = self.rows.iter().position(moves) {
            return Err(place);
        }
        let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
        let offset = |row: usize| in_short(-constraints[row].rate.substitute(&at_rest));
        let right = self.dependent.iter().map(|&(_, row)| vec![offset(row)]).collect();
        let offsets = solved(&square(&self.rows, &self.dependent), right);
        let speeds: Vec<(Sym, Sym)> = (self.dependent.iter().zip(&self.slopes).zip(&offsets))
            .map(|((&(d, _), slopes), offset)| {
                let by_others = self.independent.iter().zip(slopes);
                let sum = by_others.fold(offset[0], |sum, (&j, &slope)| sum + slope * trace.speeds[j]);
                (trace.speeds[d], sum)
            })
            .collect();
        let rates: Vec<Sym> = speeds.iter().map(|&(_, speed)| trace.rate_of(speed)).collect();
        let rates = substitute_all(&rates, &speeds);
        let accelerations = self.dependent.iter().zip(rates).map(|(&(d, _), rate)| (trace.accelerations[d], rate));
        Ok(SolvedMotion { accelerations: accelerations.collect(), speeds })
    }
}

/// Dependent speeds and accelerations as pairs (symbol, expression in the independent ones).
#[derive(Clone, Debug)]
pub struct SolvedMotion {
    /// The dependent speeds.
    pub speeds: Vec<(Sym, Sym)>,
    /// The dependent accelerations.
    pub accelerations: Vec<(Sym, Sym)>,
}

impl SolvedMotion {
    /// Restricts expressions to states that satisfy the constraints, by substitution.
    pub fn on_constraints(&self, expressions: &[Sym]) -> Vec<Sym> {
        let moved = substitute_all(expressions, &self.accelerations);
        substitute_all(&moved, &self.speeds)
    }
}

/// The smallest accepted pivot, relative to the largest entry of its row.
const LEAST_PIVOT: f64 = 0.05;

/// A row that elimination reduces to this fraction of its size counts as dependent.
const ROUNDED: f64 = 1e-9;

/// Chooses pivots by the values at the start; `None` if these are not known.
fn pivots_at_start(trace: &Trace<'_>, rows: &[Vec<Sym>], order: &[usize]) -> Option<Vec<(usize, usize)>> {
    let size = |row: &[f64]| row.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let mut reduced: Vec<Vec<f64>> = Vec::new();
    let mut pivots: Vec<(usize, usize)> = Vec::new();
    for (row, entries) in rows.iter().enumerate() {
        let mut values = entries.iter().map(|&entry| value_at_start(trace, entry)).collect::<Option<Vec<f64>>>()?;
        let before = size(&values);
        for &(above, column) in &pivots {
            let factor = values[column] / reduced[above][column];
            values.iter_mut().zip(&reduced[above]).for_each(|(value, above)| *value -= factor * above);
            values[column] = 0.0;
        }
        let largest = size(&values);
        let is_pivot = |column: &&usize| values[**column].abs() >= LEAST_PIVOT * largest;
        if largest > ROUNDED * before
            && let Some(&column) = order.iter().find(is_pivot)
        {
            pivots.push((row, column));
        }
        reduced.push(values);
    }
    Some(pivots)
}

/// Longer expressions, in operations, are not simplified.
const MOST_SIMPLIFIED: usize = 200;

/// Returns the normal form of a short expression if it is shorter: 1 in place of cos^2 + sin^2.
fn in_short(expression: Sym) -> Sym {
    let operations = Sym::operations_of(&[expression]);
    if operations > MOST_SIMPLIFIED {
        return expression;
    }
    let normal = simplified(expression);
    if Sym::operations_of(&[normal]) < operations { normal } else { expression }
}

/// Returns the square submatrix of the dependent speeds and the equations that determine them.
fn square(rows: &[Vec<Sym>], dependent: &[(usize, usize)]) -> Vec<Vec<Sym>> {
    dependent.iter().map(|&(_, row)| dependent.iter().map(|&(d, _)| rows[row][d]).collect()).collect()
}

/// Solves matrix * x = right for several right sides by Gaussian elimination, with the pivots in their given order.
fn solved(matrix: &[Vec<Sym>], right: Vec<Vec<Sym>>) -> Vec<Vec<Sym>> {
    eliminated(matrix.to_vec(), right, in_short).0
}

/// Returns the solution and the pivots. Short entries are brought to normal form at every step, so that common factors cancel.
pub(crate) fn solved_in_short(matrix: Vec<Vec<Sym>>, right: Vec<Vec<Sym>>) -> (Vec<Vec<Sym>>, Vec<Sym>) {
    eliminated(matrix, right, in_short)
}

fn eliminated(
    mut rows: Vec<Vec<Sym>>,
    mut right: Vec<Vec<Sym>>,
    read: impl Fn(Sym) -> Sym,
) -> (Vec<Vec<Sym>>, Vec<Sym>) {
    let k = rows.len();
    for above in 0..k {
        for below in above + 1..k {
            let factor = read(rows[below][above] / rows[above][above]);
            if factor == Sym::ZERO {
                continue;
            }
            for table in [&mut rows, &mut right] {
                let (upper, lower) = table.split_at_mut(below);
                for (entry, &pivot) in lower[0].iter_mut().zip(&upper[above]) {
                    *entry = read(*entry - factor * pivot);
                }
            }
        }
    }
    for row in (0..k).rev() {
        for place in 0..right[row].len() {
            let known = (row + 1..k).fold(right[row][place], |rest, j| rest - rows[row][j] * right[j][place]);
            right[row][place] = read(known / rows[row][row]);
        }
    }
    let pivots = rows.iter().enumerate().map(|(at, row)| row[at]).collect();
    (right, pivots)
}
