//! Stability of a steady motion: by the energy where it is conserved, else by the linear equations.

use super::definiteness::signs;
use super::equations::SteadyEquations;
use super::search::Boxes;
use super::spectrum::{EnclosedSpectrum, NotEnclosed};
use crate::conservation::keeps_energy;
use crate::linearisation::{Linear, VariedEquations};
use algebra::boxes::Equations;
use field::Interval;
use model::Model;

/// The stability of a steady motion, as far as it is known.
#[derive(Clone, Debug)]
pub enum SteadyStability {
    /// The amended potential energy, with the kinetic energy of cyclic coordinates at their momenta, has a strict minimum in
    /// every direction that constraints allow: stable in all but cyclic coordinates (Lagrange and Dirichlet, Routh).
    Minimum,
    /// An equilibrium at which the potential energy decreases in this number of directions: unstable, since frequencies there are imaginary.
    Falls(usize),
    /// The amended potential energy decreases in an odd number of directions: unstable with any gyroscopic forces (Thomson and Tait).
    FallsOdd(usize),
    /// A condition of the law is zero there, and of this side of it alone is known whether the potential energy has a strict minimum.
    AtCondition { is_minimum: bool },
    /// The law has a kink there, and the potential energy has a strict minimum on each of its sides: a strict minimum, since its slope does
    /// not jump (Lagrange and Dirichlet).
    MinimumOnSides,
    /// By eigenvalues of the linear equations.
    Linear(Box<Eigenvalues>),
    /// There are no linear equations.
    Unknown(String),
}

/// Eigenvalues at a motion, as numbers and in discs.
#[derive(Clone, Debug)]
pub struct Eigenvalues {
    pub linear: Linear,
    pub enclosed: Result<EnclosedSpectrum, NotEnclosed>,
}

/// The stability at an enclosure of unknowns and reactions; `state` is a state within it.
pub(super) fn judged(
    model: &Model,
    equations: &SteadyEquations,
    boxes: &mut Boxes<'_>,
    (enclosure, state): (&[Interval], &[f64]),
) -> SteadyStability {
    let n = model.speeds();
    if equations.is_at_condition {
        return SteadyStability::AtCondition { is_minimum: false };
    }
    let is_open = boxes.lies_aside(enclosure) != Some(true);
    // a coordinate held fixed by the user may move: then the energy test decides nothing
    let is_whole =
        equations.coordinates == equations.unknowns.len() && equations.coordinates + equations.cyclic.len() == n;
    let keeps_energy = equations.have_potential || keeps_energy(model);
    if is_whole && keeps_energy && has_inertia(equations, boxes, enclosure, n) {
        let rests = state[n..].iter().all(|speed| *speed == 0.0);
        let falls = falls(equations, boxes, enclosure);
        if is_open {
            return SteadyStability::AtCondition { is_minimum: falls == Some(0) };
        }
        match falls {
            Some(0) => return SteadyStability::Minimum,
            Some(falls) if rests => return SteadyStability::Falls(falls),
            Some(falls) if falls % 2 == 1 => return SteadyStability::FallsOdd(falls),
            _ => {}
        }
    }
    if is_open {
        return SteadyStability::AtCondition { is_minimum: false };
    }
    // inputs have their values, with all derivatives of these
    let varied = match VariedEquations::with_inputs(model, &[], &[]) {
        Ok(varied) => varied,
        Err(why) => return SteadyStability::Unknown(why.to_string()),
    };
    match varied.about(0.0, state) {
        Ok(linear) => {
            let enclosed = EnclosedSpectrum::of(model, equations, &varied, (enclosure, state), keeps_energy);
            SteadyStability::Linear(Box::new(Eigenvalues { linear, enclosed }))
        }
        Err(why) => SteadyStability::Unknown(why.to_string()),
    }
}

/// Whether the kinetic energy is positive in every direction that constraints allow, for all enclosed numbers. Bodies without mass are allowed
/// between others. The matrix
///
///   | M   f'^T |
///   | f'   0   |
///
/// then has as many negative eigenvalues as there are constraints f = 0, and all others are positive.
fn has_inertia(equations: &SteadyEquations, boxes: &mut Boxes<'_>, enclosure: &[Interval], n: usize) -> bool {
    let Some(tape) = &equations.masses else { return false };
    let (own, positions) = (enclosure.len(), equations.unknowns.len());
    let mut masses = vec![Interval::EVERYTHING; n * n];
    tape.over::<Interval>().evaluate(&enclosure[..positions], &mut masses);
    if signs(&masses, n) == Some([0, n]) {
        return true;
    }
    let mut slopes = vec![Interval::EVERYTHING; own * own];
    boxes.slopes(enclosure, &mut slopes);
    let unknown_at: Vec<Option<usize>> =
        (0..n).map(|place| equations.unknowns.iter().position(|unknown| unknown.place == place)).collect();
    let (reactions, zero) = (equations.reactions, Interval::point(0.0));
    // constraints contain no cyclic coordinates
    let push =
        |place: usize, reaction: usize| unknown_at[place].map_or(zero, |row| slopes[row * own + positions + reaction]);
    let size = n + reactions;
    let entry = |row: usize, column: usize| match (row < n, column < n) {
        (true, true) => masses[row * n + column],
        (true, false) => push(row, column - n),
        (false, true) => push(column, row - n),
        (false, false) => zero,
    };
    let matrix: Vec<Interval> = (0..size * size).map(|at| entry(at / size, at % size)).collect();
    signs(&matrix, size) == Some([reactions, n])
}

/// The number of directions in which the amended potential energy decreases; none if this is not decided. The matrix
///
///   | V'' - lambda f'' - T''   f'^T   p'^T |
///   | f'                        0     0    |
///   | p'                        0    -M_c  |
///
/// with the momenta p of cyclic coordinates and their masses M_c has a positive eigenvalue for each constraint and each direction in
/// which that energy increases, and a negative one for each constraint, each cyclic coordinate and each direction in which it decreases.
fn falls(equations: &SteadyEquations, boxes: &mut Boxes<'_>, enclosure: &[Interval]) -> Option<usize> {
    let (own, positions, cyclic) = (enclosure.len(), equations.unknowns.len(), equations.cyclic.len());
    let mut slopes = vec![Interval::EVERYTHING; own * own];
    boxes.slopes(enclosure, &mut slopes);
    let tape = equations.momenta.as_ref()?;
    let mut momenta = vec![Interval::EVERYTHING; tape.outputs()];
    tape.over::<Interval>().evaluate(&enclosure[..positions], &mut momenta);
    let (by_unknowns, masses) = momenta.split_at(cyclic * positions);
    let size = own + cyclic;
    let zero = Interval::point(0.0);
    let entry = |row: usize, column: usize| match (row < own, column < own) {
        // residuals are forces: less the derivatives of the energy
        (true, true) if row < positions && column < positions => -slopes[row * own + column],
        (true, true) => slopes[row * own + column],
        (true, false) if row < positions => by_unknowns[(column - own) * positions + row],
        (false, true) if column < positions => by_unknowns[(row - own) * positions + column],
        (false, false) => -masses[(row - own) * cyclic + column - own],
        _ => zero,
    };
    let matrix: Vec<Interval> = (0..size * size).map(|at| entry(at / size, at % size)).collect();
    let [negative, _] = signs(&matrix, size)?;
    negative.checked_sub(equations.reactions + cyclic)
}
