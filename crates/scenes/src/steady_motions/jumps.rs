//! Equilibria at a jump of a force that depends on positions, such as -F sign(x). The potential energy is continuous and has an edge there.
//!
//! Let c(q) = 0 be the edge and R + s J the forces, with a factor s of the jump J between 0 and 1. J is parallel to the gradient of c, since the
//! energies of both sides agree on the edge. If J points against the gradient, both sides push towards the edge, and the energy has a strict
//! minimum if its restriction to the edge has one; s acts as a multiplier. If J points along the gradient and there is one coordinate, both sides
//! push away.

use super::conditions::Case;
use super::definiteness::signs;
use super::differentiability::jumps_along_gradient;
use super::equations::SteadyEquations;
use super::search::Boxes;
use super::stability::SteadyStability;
use algebra::boxes::Equations;
use field::Interval;
use model::Model;

/// The stability of an equilibrium at a jump, with positive inertia and all `n` coordinates unknown; `None` if the jump does not decide it.
pub(super) fn at_jump(
    model: &Model,
    equations: &SteadyEquations,
    boxes: &mut Boxes<'_>,
    (enclosure, n): (&[Interval], usize),
) -> Option<SteadyStability> {
    let held: Vec<usize> = (0..equations.cases.len()).filter(|&k| equations.cases[k] == Case::Between).collect();
    let is_condition = matches!(
        held[..],
        [place] if place < model.switches.len() && jumps_along_gradient(model, &equations.cases, place)
    );
    let is_square = equations.coordinates == n && enclosure.len() == n + 1 && equations.rows == n + 1;
    if !(is_condition && is_square && equations.reactions == 0) || boxes.lies_aside(enclosure) != Some(true) {
        return None;
    }
    let share = equations.unknowns.iter().position(|unknown| unknown.place >= equations.state.len())?;
    if !(enclosure[share].low() > 0.0 && enclosure[share].high() < 1.0 && share == n) {
        return None;
    }
    let mut slopes = vec![Interval::EVERYTHING; (n + 1) * (n + 1)];
    boxes.slopes(enclosure, &mut slopes);
    let at = |row: usize, column: usize| slopes[row * (n + 1) + column];
    let along = (0..n).fold(Interval::point(0.0), |sum, k| sum + at(k, n) * at(n, k));
    if along.low() > 0.0 && n == 1 {
        return Some(SteadyStability::FallsOnSide(1));
    }
    let (holds, keeps_energy) = (along.high() < 0.0, equations.energy_integral.is_some() || equations.decays);
    if !(holds && keeps_energy) {
        return None;
    }
    let half = Interval::point(0.5);
    let entry = |row: usize, column: usize| match (row < n, column < n) {
        (true, true) => -(at(row, column) + at(column, row)) * half,
        (false, false) => Interval::point(0.0),
        _ => at(n, row.min(column)),
    };
    let matrix: Vec<Interval> = (0..(n + 1) * (n + 1)).map(|k| entry(k / (n + 1), k % (n + 1))).collect();
    (signs(&matrix, n + 1) == Some([1, n])).then_some(SteadyStability::MinimumOnSides)
}
