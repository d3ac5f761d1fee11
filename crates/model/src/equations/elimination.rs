//! Accelerations and multipliers by symbolic elimination: M = L D L^T, then J M^-1 J^T likewise.
//!
//! Pivots are taken in the given order. M is positive definite if the system is regular, so that every pivot is positive. Entries
//! that are the constant zero cost no operations.

use super::{Equations, Solved, vanishes};
use std::collections::BTreeSet;
use std::fmt;
use symbolic::Sym;

/// The position of a pivot that is identically zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Singular {
    /// No inertia acts along this coordinate.
    Massless { coordinate: usize },
    /// This constraint depends on earlier ones, or is empty.
    Redundant { constraint: usize },
}

impl fmt::Display for Singular {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Massless { coordinate } => write!(f, "no inertia resists coordinate {coordinate}"),
            Self::Redundant { constraint } => write!(f, "constraint {constraint} depends on those before it"),
        }
    }
}

/// The factorisation M = L D L^T of a symmetric matrix: the rows of L without the diagonal, and D.
struct Factors {
    lower: Vec<Vec<Sym>>,
    pivots: Vec<Sym>,
}

impl Factors {
    /// Factorises a matrix; the error is the index of the first pivot that is zero.
    fn of(matrix: &[Vec<Sym>]) -> Result<Self, usize> {
        let (mut lower, mut pivots): (Vec<Vec<Sym>>, Vec<Sym>) = (Vec::new(), Vec::new());
        for (i, entries) in matrix.iter().enumerate() {
            // row i of L D
            let mut scaled: Vec<Sym> = Vec::with_capacity(i);
            for j in 0..i {
                let known = (0..j).map(|k| scaled[k] * lower[j][k]).fold(entries[j], |rest, each| rest - each);
                scaled.push(known);
            }
            let row: Vec<Sym> = (0..i).map(|j| scaled[j] / pivots[j]).collect();
            let pivot = (0..i).map(|k| scaled[k] * row[k]).fold(entries[i], |rest, each| rest - each);
            if pivot == Sym::ZERO || pivot == Sym::UNDEFINED {
                return Err(i);
            }
            lower.push(row);
            pivots.push(pivot);
        }
        Ok(Factors { lower, pivots })
    }

    fn solve(&self, right: &[Sym]) -> Vec<Sym> {
        let n = right.len();
        let mut x = right.to_vec();
        for i in 0..n {
            x[i] = (0..i).map(|k| self.lower[i][k] * x[k]).fold(x[i], |rest, each| rest - each);
        }
        for (x, pivot) in x.iter_mut().zip(&self.pivots) {
            *x /= *pivot;
        }
        for i in (0..n).rev() {
            x[i] = (i + 1..n).map(|k| self.lower[k][i] * x[k]).fold(x[i], |rest, each| rest - each);
        }
        x
    }
}

/// Solves a system with a symmetric matrix in an order that preserves sparsity (minimum degree).
///
/// # Errors
/// The row of the first pivot that is identically zero.
pub fn solve_sparse(matrix: &[Vec<Sym>], right: &[Sym]) -> Result<Vec<Sym>, usize> {
    let order = order(matrix);
    let arranged: Vec<Vec<Sym>> = order.iter().map(|&i| order.iter().map(|&j| matrix[i][j]).collect()).collect();
    let factors = Factors::of(&arranged).map_err(|place| order[place])?;
    let found = factors.solve(&order.iter().map(|&i| right[i]).collect::<Vec<Sym>>());
    let mut values = vec![Sym::ZERO; right.len()];
    order.iter().zip(found).for_each(|(&place, value)| values[place] = value);
    Ok(values)
}

/// Returns the minimum degree order (Tinney and Walker 1967): the neighbours of an eliminated row become neighbours of
/// each other.
fn order(matrix: &[Vec<Sym>]) -> Vec<usize> {
    let entries =
        |row: usize| (0..matrix.len()).filter(move |&column| column != row && matrix[row][column] != Sym::ZERO);
    let mut neighbours: Vec<BTreeSet<usize>> = (0..matrix.len()).map(|row| entries(row).collect()).collect();
    let mut left: BTreeSet<usize> = (0..matrix.len()).collect();
    let mut order = Vec::with_capacity(matrix.len());
    while let Some(&next) = left.iter().min_by_key(|&&row| neighbours[row].len()) {
        left.remove(&next);
        order.push(next);
        let joined = std::mem::take(&mut neighbours[next]);
        for &row in &joined {
            neighbours[row].extend(&joined);
            neighbours[row].remove(&row);
            neighbours[row].remove(&next);
        }
    }
    order
}

/// Factorises M, after adding J^T J, and J^T c to h, for all constraints that contain a coordinate without inertia. Since J u' + c = 0 along every motion,
/// accelerations and multipliers do not change, and M becomes definite if the constraints determine the coordinate. All of these constraints are
/// added, since a single one may not determine the coordinate in every position.
fn inertia_of(equations: &Equations) -> Result<(Factors, Vec<Sym>), Singular> {
    let Equations { mass, bias, constraints } = equations;
    let (mut mass, mut bias) = (mass.clone(), bias.clone());
    let mut is_added = vec![false; constraints.len()];
    loop {
        let coordinate = match Factors::of(&mass) {
            Ok(factors) => {
                let is_open = |pivot: &Sym| is_added.contains(&true) && vanishes(*pivot);
                match factors.pivots.iter().position(is_open) {
                    None => return Ok((factors, bias)),
                    Some(coordinate) => coordinate,
                }
            }
            Err(coordinate) => coordinate,
        };
        let holds = |k: &usize| !is_added[*k] && constraints[*k].row[coordinate] != Sym::ZERO;
        let holding: Vec<usize> = (0..constraints.len()).filter(holds).collect();
        if holding.is_empty() {
            return Err(Singular::Massless { coordinate });
        }
        for place in holding {
            is_added[place] = true;
            let constraint = &constraints[place];
            for (i, &slope) in constraint.row.iter().enumerate().filter(|(_, slope)| **slope != Sym::ZERO) {
                for (entry, &other) in mass[i].iter_mut().zip(&constraint.row) {
                    *entry += slope * other;
                }
                bias[i] += slope * constraint.bias;
            }
        }
    }
}

/// The accelerations u' = free + columns * lambda as an affine function of the multipliers.
#[derive(Clone, Debug)]
pub struct Pushes {
    /// M^-1 (-h), the accelerations for zero multipliers.
    pub free: Vec<Sym>,
    /// The columns of M^-1 J^T, one for each multiplier.
    pub columns: Vec<Vec<Sym>>,
}

pub(super) fn pushes(equations: &Equations) -> Result<Pushes, Singular> {
    let (inertia, bias) = inertia_of(equations)?;
    let free = inertia.solve(&bias.iter().map(|h| -*h).collect::<Vec<_>>());
    let columns = equations.constraints.iter().map(|constraint| inertia.solve(&constraint.row)).collect();
    Ok(Pushes { free, columns })
}

pub(super) fn solved(equations: &Equations) -> Solved {
    let constraints = &equations.constraints;
    let Pushes { free, columns: moved } = pushes(equations)?;
    if constraints.is_empty() {
        return Ok((free, Vec::new()));
    }
    let dot = |a: &[Sym], b: &[Sym]| a.iter().zip(b).fold(Sym::ZERO, |sum, (&a, &b)| sum + a * b);
    let matrix: Vec<Vec<Sym>> = constraints
        .iter()
        .map(|constraint| moved.iter().map(|column| dot(&constraint.row, column)).collect())
        .collect();
    let factors = Factors::of(&matrix).map_err(|constraint| Singular::Redundant { constraint })?;
    let right: Vec<Sym> =
        constraints.iter().map(|constraint| -(constraint.bias + dot(&constraint.row, &free))).collect();
    let multipliers = factors.solve(&right);
    let accelerations = (0..free.len())
        .map(|i| moved.iter().zip(&multipliers).fold(free[i], |sum, (column, &lambda)| sum + column[i] * lambda))
        .collect();
    Ok((accelerations, multipliers))
}
