//! Inertia at a steady motion: whether the kinetic energy is positive in every direction that the constraints allow.
//!
//! The kinetic energy of bodies is positive for every motion of the system. If the mass matrix is singular nevertheless, as at the pole of
//! spherical angles, the coordinates are singular: several values describe one position, the equations of motion hold there for any force,
//! and neither equilibrium nor stability follows from them.

use super::definiteness::signs;
use super::equations::SteadyEquations;
use super::search::Boxes;
use crate::linearisation::without_inertia;
use algebra::boxes::Equations;
use field::Interval;
use nalgebra::DMatrix;

/// Components of a direction without inertia below this fraction of the largest one are rounding errors.
const MOVED: f64 = 1e-3;

/// The definiteness of the kinetic energy at a motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Inertia {
    /// Proved positive in every allowed direction.
    Positive,
    /// Zero up to rounding in a direction; the indices are those of the coordinates that change.
    Singular(Vec<usize>),
    /// Undecided.
    Open,
}

impl Inertia {
    /// The definiteness at an enclosure of unknowns and reactions, for a system with `n` speeds. Single coordinates may lack inertia if
    /// constraints connect them with others. The matrix
    ///
    ///   | M   f'^T |
    ///   | f'   0   |
    ///
    /// then has one negative eigenvalue for each constraint f = 0, and n positive ones.
    pub fn of(equations: &SteadyEquations, boxes: &mut Boxes<'_>, enclosure: &[Interval], n: usize) -> Self {
        let Some(tape) = &equations.masses else { return Inertia::Open };
        let (own, positions) = (enclosure.len(), equations.unknowns.len());
        let mut masses = vec![Interval::EVERYTHING; n * n];
        tape.over::<Interval>().evaluate(&enclosure[..positions], &mut masses);
        if signs(&masses, n) == Some([0, n]) {
            return Inertia::Positive;
        }
        let mut slopes = vec![Interval::EVERYTHING; own * own];
        boxes.slopes(enclosure, &mut slopes);
        let unknown_at: Vec<Option<usize>> =
            (0..n).map(|place| equations.unknowns.iter().position(|unknown| unknown.place == place)).collect();
        let (reactions, zero) = (equations.reactions, Interval::point(0.0));
        // constraints do not depend on cyclic coordinates
        let push = |place: usize, reaction: usize| {
            unknown_at[place].map_or(zero, |row| slopes[row * own + positions + reaction])
        };
        let size = n + reactions;
        let entry = |row: usize, column: usize| match (row < n, column < n) {
            (true, true) => masses[row * n + column],
            (true, false) => push(row, column - n),
            (false, true) => push(column, row - n),
            (false, false) => zero,
        };
        let matrix: Vec<Interval> = (0..size * size).map(|at| entry(at / size, at % size)).collect();
        if signs(&matrix, size) == Some([reactions, n]) {
            return Inertia::Positive;
        }
        let sizes = largest(equations, n);
        let root = |place: usize| if sizes[place] > 0.0 { sizes[place].sqrt() } else { 1.0 };
        let masses = DMatrix::from_fn(n, n, |i, j| masses[i * n + j].middle() / (root(i) * root(j)));
        let pushes = DMatrix::from_fn(n, reactions, |i, k| push(i, k).middle() / root(i));
        let Some(direction) = without_inertia(masses, pushes) else { return Inertia::Open };
        let most = direction.amax();
        let places: Vec<usize> = (0..n).filter(|&place| direction[place].abs() > MOVED * most).collect();
        // a coordinate without inertia at every position lacks a mass; its coordinates are not singular
        if places.iter().any(|&place| sizes[place] == 0.0) { Inertia::Open } else { Inertia::Singular(places) }
    }

    pub fn is_positive(&self) -> bool {
        *self == Inertia::Positive
    }
}

/// The largest diagonal entry of the mass matrix for each coordinate over the searched ranges; 1 where it is unbounded.
fn largest(equations: &SteadyEquations, n: usize) -> Vec<f64> {
    let ranges: Vec<Interval> = equations.unknowns.iter().map(|unknown| unknown.range.interval()).collect();
    let mut masses = vec![Interval::EVERYTHING; n * n];
    if let Some(tape) = &equations.masses {
        tape.over::<Interval>().evaluate(&ranges, &mut masses);
    }
    let size = |place: usize| masses[place * n + place].size();
    (0..n).map(size).map(|size| if size.is_finite() { size } else { 1.0 }).collect()
}
