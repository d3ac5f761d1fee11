//! Inverse dynamics: the forces for a prescribed motion.
//!
//!   M z + h(q, u) - Q(q, u, t, p) - J^T lambda = 0  for p and lambda, with q(t), u = q', z = q'' given
//!
//! Coordinates that are not prescribed follow from position constraints, currents from the equations in which they act. The equations are
//! linear in the unknown parameters or inputs p. Constraints that are redundant at the first position are left out, since their
//! multipliers are not unique.

mod completion;
mod currents;
mod laws;
mod least_solution;
mod no_forces;
mod prescription;

use crate::linearisation::{At, NamedConstraint, Point, VariedEquations};
use crate::motions::PrescribedMotion;
use crate::readiness::independent_at;
use completion::Completion;
use currents::Currents;
use model::{Fault, Model};
use nalgebra::{DMatrix, DVector};
pub use no_forces::NoForces;
use prescription::Prescribed;

/// The forces at an instant, with the completed motion; SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Forces {
    /// Time, s.
    pub time: f64,
    /// Coordinates q, with four quaternion components for each free frame.
    pub coordinates: Vec<f64>,
    /// Speeds u.
    pub speeds: Vec<f64>,
    /// Accelerations z = u'.
    pub accelerations: Vec<f64>,
    /// The values of the unknown parameters and inputs, in the order of the request.
    pub unknowns: Vec<f64>,
    /// Multipliers of the constraints in [`AlongMotion::constraints`].
    pub multipliers: Vec<f64>,
}

/// The forces along a motion.
#[derive(Clone, Debug)]
pub struct AlongMotion {
    /// The forces at each time.
    pub forces: Vec<Forces>,
    /// The constraints that the multipliers belong to; position constraints are first.
    pub constraints: Vec<NamedConstraint>,
    /// Warnings for the redundant constraints that are left out.
    pub left_out: Vec<Fault>,
    /// Indices of the cyclic charges: their values are those of the start, and their rates are the currents.
    pub charges: Vec<usize>,
}

/// Singular values below this part of the largest count as zero.
const RANK: f64 = 1e-10;

/// The forces along a prescribed motion. `unknowns` are names of parameters and inputs; `times`, s, must increase, since each instant is
/// the guess of the next.
///
/// # Errors
/// [`NoForces`] with the reason.
pub fn inverse(
    model: &Model,
    motions: &[PrescribedMotion],
    unknowns: &[String],
    times: &[f64],
) -> Result<AlongMotion, NoForces> {
    let mut known = model.clone();
    known.close_inputs();
    let named = |name: &String| model.parameters.iter().position(|parameter| parameter.name == *name);
    let parameters: Vec<usize> = unknowns.iter().filter_map(named).collect();
    for &place in &parameters {
        known.parameters[place].value = Some(0.0);
    }
    let inputs: Vec<usize> =
        (0..model.inputs.len()).filter(|&place| unknowns.contains(&model.inputs[place].name)).collect();
    let equations_of = |known: &Model| {
        let equations = VariedEquations::with_inputs(known, &parameters, &inputs).map_err(NoForces::NotCompiled)?;
        let columns = columns_of(&equations, unknowns)?;
        Ok((equations, columns))
    };
    let (mut equations, mut columns) = equations_of(&known)?;
    let prescribed = Prescribed::of(&known, motions)?;
    let currents_of = |equations: &VariedEquations, columns: &[usize], time: f64| {
        let mut point = equations.point(time, &model.start_state());
        prescribed.put(&mut point);
        let open = (0..model.speeds()).filter(|&speed| !prescribed.has(speed)).collect();
        Currents::of(model, (equations, &point), (open, columns), &prescribed.speeds)
    };
    let mut currents = currents_of(&equations, &columns, times.first().copied().unwrap_or(0.0))?;
    if currents.count() == 0 && !prescribed.speeds.is_empty() {
        return Err(NoForces::NoOpenCurrent);
    }
    let mut guess = known.start_state();
    if let Some(&first) = times.first() {
        let point = equations.point(first, &guess);
        let point =
            Completion { equations: &equations, model, prescribed: &prescribed, currents: &currents }.of(point)?;
        let state = [point.coordinates.as_slice(), point.speeds.as_slice()].concat();
        // at a singular position all constraints stay; the rank test reports it
        if independent_at(&mut known, &state).is_ok() && !known.implied.is_empty() {
            (equations, columns) = equations_of(&known)?;
            currents = currents_of(&equations, &columns, first)?;
        }
    }
    let completion = Completion { equations: &equations, model, prescribed: &prescribed, currents: &currents };
    let mut forces = Vec::with_capacity(times.len());
    for &time in times {
        let mut point = equations.point(time, &guess);
        columns.iter().for_each(|&column| point.inputs[column] = 0.0);
        let mut point = completion.of(point)?;
        let (coordinates, speeds) = guess.split_at_mut(model.positions());
        coordinates.copy_from_slice(point.coordinates.as_slice());
        // the guess selects one of several currents with equal torque
        speeds.copy_from_slice(point.speeds.as_slice());
        columns.iter().for_each(|&column| point.inputs[column] = 0.0);
        forces.push(forces_at(&equations, &currents, point, &columns)?);
    }
    let left_out = known.warnings.split_off(model.warnings.len());
    let charges = (0..model.coordinates.len()).filter(|&place| currents.has(place)).collect();
    Ok(AlongMotion { forces, constraints: equations.constraints, left_out, charges })
}

/// The indices of the unknowns among the inputs of the equations.
///
/// # Errors
/// An unknown is no parameter or input of forces, or the forces are not linear in it.
fn columns_of(equations: &VariedEquations, unknowns: &[String]) -> Result<Vec<usize>, NoForces> {
    let column = |name: &String| match equations.inputs.iter().position(|input| input == name) {
        None => Err(NoForces::NotForce { name: name.clone() }),
        Some(column) if equations.nonlinear[column] => Err(NoForces::NotLinear { parameter: name.clone() }),
        Some(column) => Ok(column),
    };
    unknowns.iter().map(column).collect()
}

/// The unknowns p and multipliers at a point whose motion and currents are known.
fn forces_at(
    equations: &VariedEquations,
    currents: &Currents<'_>,
    point: Point,
    unknowns: &[usize],
) -> Result<Forces, NoForces> {
    let time = point.time;
    let At { motion, .. } = equations.at(&point);
    let others = |all: usize, known: &[usize]| (0..all).filter(|place| !known.contains(place)).collect::<Vec<_>>();
    let reactions = others(point.multipliers.len(), &[&currents.reactions[..], &currents.driven].concat());
    let rows = others(motion.values.len(), &currents.laws);
    let (n, m, k) = (rows.len(), reactions.len(), unknowns.len());
    let mut matrix = DMatrix::zeros(n, m + k);
    matrix.columns_mut(0, m).copy_from(&motion.by_multipliers.select_rows(&rows).select_columns(&reactions));
    matrix.columns_mut(m, k).copy_from(&motion.by_inputs.select_rows(&rows).select_columns(unknowns));
    let residuals = motion.values.select_rows(&rows);
    if !matrix.iter().chain(residuals.iter()).all(|value| value.is_finite()) {
        return Err(NoForces::NotFinite { time });
    }
    let scales: Vec<f64> =
        matrix.column_iter().map(|column| if column.amax() > 0.0 { column.amax() } else { 1.0 }).collect();
    for (mut column, scale) in matrix.column_iter_mut().zip(&scales) {
        column.scale_mut(1.0 / scale);
    }
    if m + k == 0 {
        return Err(NoForces::Underactuated { rank: 0, equations: n, time });
    }
    let scaled_columns: Vec<f64> = matrix.column_iter().map(|column| column.amax()).collect();
    let decomposed = matrix.svd(true, true);
    let largest = decomposed.singular_values.amax();
    let rank = decomposed.singular_values.iter().filter(|value| **value > RANK * largest).count();
    let unknown = |column: &usize| *column >= m && scaled_columns[*column] == 0.0;
    if let (Some(idle), true) = ((0..m + k).find(unknown), rank < n || rank < m + k) {
        return Err(NoForces::Idle { unknown: equations.inputs[unknowns[idle - m]].clone(), time });
    }
    if rank < n {
        return Err(NoForces::Underactuated { rank, equations: n, time });
    }
    if rank < m + k {
        return Err(NoForces::NotUnique { rank, unknowns: m + k, time });
    }
    let solution = decomposed.solve(&-&residuals, RANK * largest).map_err(|_| NoForces::NotFinite { time })?;
    let value = |at: usize| solution[at] / scales[at];
    let list = |values: &DVector<f64>| values.iter().copied().collect();
    let mut multipliers = point.multipliers.clone();
    reactions.iter().enumerate().for_each(|(at, &place)| multipliers[place] = value(at));
    Ok(Forces {
        time,
        coordinates: list(&point.coordinates),
        speeds: list(&point.speeds),
        accelerations: list(&point.accelerations),
        multipliers: list(&multipliers),
        unknowns: (m..m + k).map(value).collect(),
    })
}
