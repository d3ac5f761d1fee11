//! Inverse dynamics: the forces under which a system moves as prescribed.
//!
//!   M z + h(q, u) - Q(q, u, t, p) - J^T lambda = 0  for p and lambda, with q(t), u = q', z = q'' given
//!
//! Coordinates that are not prescribed follow from the constraints of positions. The unknown parameters p stand in the forces linearly.
//! Equations of constraints that follow from others at the first position of the motion are left out: nothing determines their lambda.

mod completion;
mod prescription;

use crate::compiled_system::NotCompiled;
use crate::linearisation::{At, Known, Point, VariedEquations};
use crate::motions::Motion;
use crate::readiness::{independent_at, without_law};
use completion::Completion;
use derivations::scene::Issue;
use model::{Fault, Model};
use nalgebra::{DMatrix, DVector};
use prescription::Prescribed;
use std::fmt;

/// The forces at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Forces {
    pub time: f64,
    pub coordinates: Vec<f64>,
    pub speeds: Vec<f64>,
    pub accelerations: Vec<f64>,
    /// The unknown parameters and inputs.
    pub unknowns: Vec<f64>,
    /// Multipliers of constraints, those of positions first.
    pub multipliers: Vec<f64>,
}

/// The forces along a motion.
#[derive(Clone, Debug)]
pub struct AlongMotion {
    pub forces: Vec<Forces>,
    /// The constraints of the multipliers.
    pub constraints: Vec<Known>,
    /// Warnings of the equations of constraints that follow from others.
    pub left_out: Vec<Fault>,
}

/// Why no forces are found.
#[derive(Clone, Debug, PartialEq)]
pub enum NoForces {
    NotCompiled(NotCompiled),
    /// A prescribed motion asks for something that moves.
    NotOfTime {
        coordinate: String,
    },
    /// An unknown that is no parameter and no input of forces.
    NotForce {
        name: String,
    },
    /// The forces are not linear in a parameter.
    NotLinear {
        parameter: String,
    },
    /// Constraints leave coordinates open: so many directions.
    Open {
        coordinates: Vec<String>,
        time: f64,
    },
    /// A constraint does not hold along the motion; the residual has its unit.
    Unmet {
        constraint: String,
        residual: String,
        time: f64,
    },
    /// A programmed constraint does not go to zero as its gains say.
    NotLed {
        constraint: String,
        /// The sum that its gains lead to zero.
        equation: &'static str,
        residual: String,
        time: f64,
    },
    /// No equation holds an unknown at an instant.
    Idle {
        unknown: String,
        time: f64,
    },
    /// Unknowns and reactions do not reach every equation.
    Underactuated {
        rank: usize,
        equations: usize,
        time: f64,
    },
    /// Several forces do.
    NotUnique {
        rank: usize,
        unknowns: usize,
        time: f64,
    },
    NotFinite {
        time: f64,
    },
}

impl fmt::Display for NoForces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotCompiled(why) => write!(f, "{why}"),
            Self::NotOfTime { coordinate } => {
                write!(f, "the motion of `{coordinate}` must be an expression of t and of parameters")
            }
            Self::NotForce { name } => {
                write!(f, "`{name}` is neither a parameter nor an input of forces: an unknown must be one")
            }
            Self::NotLinear { parameter } => write!(f, "the forces are not linear in `{parameter}`"),
            Self::Open { coordinates, time } => write!(
                f,
                "at t = {time} s the constraints do not determine {}: prescribe more coordinates",
                coordinates.join(", ")
            ),
            Self::Unmet { constraint, residual, time } => {
                write!(f, "at t = {time} s the prescribed motion leaves {residual} of {constraint}, which must be zero")
            }
            Self::NotLed { constraint, equation, residual, time } => write!(
                f,
                "{constraint} is programmed, and the prescribed motion does not follow it: at t = {time} s {equation} is {residual}, and not \
                 zero; a file without this constraint has forces for any motion"
            ),
            Self::Idle { unknown, time } => write!(
                f,
                "at t = {time} s no equation of motion holds `{unknown}`: its factor is zero there, and nothing determines it"
            ),
            Self::Underactuated { rank, equations, time } => write!(
                f,
                "at t = {time} s the unknowns and reactions reach {rank} of {equations} equations (the rank): underactuated; \
                 more unknowns are needed"
            ),
            Self::NotUnique { rank, unknowns, time } => write!(
                f,
                "at t = {time} s {unknowns} unknowns and reactions have the rank {rank}: several forces give this motion; fewer \
                 unknowns are needed"
            ),
            Self::NotFinite { time } => write!(f, "at t = {time} s the equations have no finite value"),
        }
    }
}

impl NoForces {
    /// At its place in the file, with what is accepted.
    pub fn at(&self, model: &Model) -> Issue {
        let of_name = |name: &str| {
            let coordinates = model.coordinates.iter().map(|one| (&one.name, &one.at));
            let parameters = model.parameters.iter().map(|one| (&one.name, &one.at));
            let inputs = model.inputs.iter().map(|one| (&one.name, &one.at));
            let mut all = coordinates.chain(parameters).chain(inputs);
            all.find(|(own, _)| *own == name).map_or(0..0, |(_, at)| at.clone())
        };
        let (place, accepted) = match self {
            Self::NotCompiled(why) => return without_law(model, why, "no forces can be found"),
            Self::NotOfTime { coordinate } => {
                (of_name(coordinate), "a motion such as --motion \"theta = 0.5*sin(t*(2 rad/s))\"")
            }
            Self::NotForce { name } => {
                (of_name(name), "--unknown with a parameter or an input of the file that forces hold")
            }
            Self::NotLinear { parameter } => {
                (of_name(parameter), "an unknown that is a factor of forces, such as their size")
            }
            Self::Open { coordinates, .. } => (
                of_name(coordinates.first().map_or("", String::as_str)),
                "--motion for each coordinate that constraints leave open",
            ),
            Self::Unmet { .. } => {
                (0..0, "motions that meet every constraint; fewer --motion, where constraints give the rest")
            }
            Self::NotLed { .. } => (0..0, "a motion on which the programmed constraint goes to zero by its gains"),
            Self::Idle { unknown, .. } => {
                (of_name(unknown), "an unknown that has power on the motion at every instant")
            }
            Self::Underactuated { .. } => (0..0, "as many --unknown forces as the motion has degrees of freedom"),
            Self::NotUnique { .. } => (0..0, "fewer --unknown forces, or constraints that are independent"),
            Self::NotFinite { .. } => (0..0, "a motion along which every force and every constraint has a value"),
        };
        let label = if place.is_empty() { "in this file" } else { "this one" };
        Issue::at(place, self.to_string(), label).accepted(accepted)
    }
}

/// Singular values below this part of the largest one are taken for zero.
const RANK: f64 = 1e-10;

/// The forces at times, which rise.
///
/// # Errors
/// Why there are none.
pub fn inverse(model: &Model, motions: &[Motion], unknowns: &[String], times: &[f64]) -> Result<AlongMotion, NoForces> {
    let mut known = model.clone();
    known.close_inputs();
    let named = |name: &String| model.parameters.iter().position(|parameter| parameter.name == *name);
    let parameters: Vec<usize> = unknowns.iter().filter_map(named).collect();
    for &place in &parameters {
        known.parameters[place].value = Some(0.0);
    }
    let mut equations = VariedEquations::of(&known, &parameters).map_err(NoForces::NotCompiled)?;
    let mut columns = columns_of(&equations, unknowns)?;
    let prescribed = Prescribed::of(&known, motions)?;
    let mut guess = known.start_state();
    if let Some(&first) = times.first() {
        let point = equations.point(first, &guess);
        let point = Completion { equations: &equations, model, prescribed: &prescribed }.of(point)?;
        let state = [point.coordinates.as_slice(), point.speeds.as_slice()].concat();
        // at a singular position all stay, and the rank says it
        if independent_at(&mut known, &state).is_ok() && !known.implied.is_empty() {
            equations = VariedEquations::of(&known, &parameters).map_err(NoForces::NotCompiled)?;
            columns = columns_of(&equations, unknowns)?;
        }
    }
    let mut forces = Vec::with_capacity(times.len());
    for &time in times {
        let point = equations.point(time, &guess);
        let mut point = Completion { equations: &equations, model, prescribed: &prescribed }.of(point)?;
        guess[..model.positions()].copy_from_slice(point.coordinates.as_slice());
        columns.iter().for_each(|&column| point.inputs[column] = 0.0);
        forces.push(forces_at(&equations, point, &columns)?);
    }
    let left_out = known.warnings.split_off(model.warnings.len());
    Ok(AlongMotion { forces, constraints: equations.constraints, left_out })
}

/// The columns of unknowns among the inputs.
fn columns_of(equations: &VariedEquations, unknowns: &[String]) -> Result<Vec<usize>, NoForces> {
    let column = |name: &String| match equations.inputs.iter().position(|input| input == name) {
        None => Err(NoForces::NotForce { name: name.clone() }),
        Some(column) if equations.nonlinear[column] => Err(NoForces::NotLinear { parameter: name.clone() }),
        Some(column) => Ok(column),
    };
    unknowns.iter().map(column).collect()
}

/// p and lambda at a point whose motion is known.
fn forces_at(equations: &VariedEquations, point: Point, unknowns: &[usize]) -> Result<Forces, NoForces> {
    let time = point.time;
    let At { motion, .. } = equations.at(&point);
    let (n, m, k) = (motion.values.len(), point.multipliers.len(), unknowns.len());
    let mut matrix = DMatrix::zeros(n, m + k);
    matrix.columns_mut(0, m).copy_from(&motion.by_multipliers);
    for (column, &unknown) in unknowns.iter().enumerate() {
        matrix.set_column(m + column, &motion.by_inputs.column(unknown));
    }
    if !matrix.iter().chain(motion.values.iter()).all(|value| value.is_finite()) {
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
    let solution = decomposed.solve(&-&motion.values, RANK * largest).map_err(|_| NoForces::NotFinite { time })?;
    let value = |at: usize| solution[at] / scales[at];
    let list = |values: &DVector<f64>| values.iter().copied().collect();
    Ok(Forces {
        time,
        coordinates: list(&point.coordinates),
        speeds: list(&point.speeds),
        accelerations: list(&point.accelerations),
        multipliers: (0..m).map(value).collect(),
        unknowns: (m..m + k).map(value).collect(),
    })
}
