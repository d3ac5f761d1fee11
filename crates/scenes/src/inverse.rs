//! Inverse dynamics: the forces under which a system moves as prescribed.
//!
//!   M z + h(q, u) - Q(q, u, t, p) - J^T lambda = 0  for p and lambda, with q(t), u = q', z = q'' given
//!
//! Coordinates that are not prescribed follow from the constraints of positions. The unknown parameters p stand in the forces linearly.

use crate::compiled_system::{NotCompiled, values};
use crate::linearisation::{At, Known, Point, VariedEquations};
use derivations::taped::Program;
use model::{Model, ScalarId, Trace};
use nalgebra::{DMatrix, DVector};
use std::fmt;
use symbolic::substitute_all;

/// A prescribed coordinate: its place, and an expression of the time.
pub type Motion = (usize, ScalarId);

/// The forces at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Forces {
    pub time: f64,
    pub coordinates: Vec<f64>,
    pub speeds: Vec<f64>,
    pub accelerations: Vec<f64>,
    /// The unknown parameters.
    pub unknowns: Vec<f64>,
    /// Of constraints, those of positions first.
    pub multipliers: Vec<f64>,
}

/// Why no forces are found.
#[derive(Clone, Debug, PartialEq)]
pub enum NoForces {
    NotCompiled(NotCompiled),
    /// A prescribed motion asks for something that moves.
    NotOfTime {
        coordinate: String,
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
    /// A constraint does not hold along the motion.
    Unmet {
        constraint: String,
        residual: f64,
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
            Self::NotLinear { parameter } => write!(f, "the forces are not linear in `{parameter}`"),
            Self::Open { coordinates, time } => write!(
                f,
                "at t = {time} s the constraints do not determine {}: prescribe more coordinates",
                coordinates.join(", ")
            ),
            Self::Unmet { constraint, residual, time } => {
                write!(
                    f,
                    "at t = {time} s the prescribed motion leaves {residual:.6e} of {constraint}, which must be zero"
                )
            }
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

/// Residuals of constraints below this, in SI units, are rounding.
const MET: f64 = 1e-9;
const RANK: f64 = 1e-10;
const MOST_STEPS: usize = 50;

/// The forces at times, which rise.
///
/// # Errors
/// Why there are none.
pub fn inverse(model: &Model, motions: &[Motion], unknowns: &[usize], times: &[f64]) -> Result<Vec<Forces>, NoForces> {
    let mut known = model.clone();
    for &place in unknowns {
        known.parameters[place].value.get_or_insert(0.0);
    }
    let equations = VariedEquations::of(&known, unknowns).map_err(NoForces::NotCompiled)?;
    if let Some(place) = equations.nonlinear_input {
        return Err(NoForces::NotLinear { parameter: model.parameters[place].name.clone() });
    }
    let prescribed = Prescribed::of(&known, motions)?;
    let mut guess = known.start_state();
    let mut all = Vec::with_capacity(times.len());
    for &time in times {
        let mut point = equations.point(&known, time, &guess);
        point.inputs.fill(0.0);
        let point = Completion { equations: &equations, model, prescribed: &prescribed }.of(point)?;
        guess[..model.coordinates.len()].copy_from_slice(point.coordinates.as_slice());
        all.push(forces(&equations, point)?);
    }
    Ok(all)
}

/// p and lambda at a point whose motion is known.
fn forces(equations: &VariedEquations, point: Point) -> Result<Forces, NoForces> {
    let time = point.time;
    let At { motion, .. } = equations.at(&point);
    let (n, m, k) = (motion.values.len(), point.multipliers.len(), point.inputs.len());
    let mut matrix = DMatrix::zeros(n, m + k);
    matrix.columns_mut(0, m).copy_from(&motion.by_multipliers);
    matrix.columns_mut(m, k).copy_from(&motion.by_inputs);
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
    let decomposed = matrix.svd(true, true);
    let largest = decomposed.singular_values.amax();
    let rank = decomposed.singular_values.iter().filter(|value| **value > RANK * largest).count();
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

/// Prescribed coordinates as functions of the time, with two rates.
struct Prescribed {
    places: Vec<usize>,
    program: Program,
}

impl Prescribed {
    fn of(model: &Model, motions: &[Motion]) -> Result<Self, NoForces> {
        let mut wrong = None;
        let program = Program::of_any_length(0, |time, _| {
            let trace = Trace::of(model);
            let positions: Vec<_> = motions.iter().map(|(_, is)| trace.scalar(*is)).collect();
            let speeds: Vec<_> = positions.iter().map(|&position| trace.rate_of(position)).collect();
            let accelerations: Vec<_> = speeds.iter().map(|&speed| trace.rate_of(speed)).collect();
            let moving = [&trace.coordinates, &trace.speeds, &trace.accelerations];
            wrong = positions.iter().position(|position| {
                position.symbols_of().iter().any(|symbol| moving.iter().any(|letters| letters.contains(symbol)))
            });
            if wrong.is_some() {
                return Vec::new();
            }
            substitute_all(&[positions, speeds, accelerations].concat(), &values(&trace, time, &[]))
        });
        match (wrong, program) {
            (Some(place), _) => {
                Err(NoForces::NotOfTime { coordinate: model.coordinates[motions[place].0].name.clone() })
            }
            (None, Some(program)) => {
                Ok(Prescribed { places: motions.iter().map(|(place, _)| *place).collect(), program })
            }
            (None, None) => Err(NoForces::NotCompiled(NotCompiled::TooLong)),
        }
    }

    /// Into the coordinates, speeds and accelerations of a point.
    fn put(&self, point: &mut Point) {
        let count = self.places.len();
        let mut numbers = vec![f64::NAN; 3 * count];
        self.program.run(point.time, &[], &mut numbers);
        for (k, &place) in self.places.iter().enumerate() {
            point.coordinates[place] = numbers[k];
            point.speeds[place] = numbers[count + k];
            point.accelerations[place] = numbers[2 * count + k];
        }
    }
}

/// Coordinates that are not prescribed, by the constraints.
struct Completion<'a> {
    equations: &'a VariedEquations,
    model: &'a Model,
    prescribed: &'a Prescribed,
}

impl Completion<'_> {
    fn of(&self, mut point: Point) -> Result<Point, NoForces> {
        let (n, positions, time) = (point.coordinates.len(), self.equations.positions(), point.time);
        self.prescribed.put(&mut point);
        let open: Vec<usize> = (0..n).filter(|place| !self.prescribed.places.contains(place)).collect();
        let columns = |matrix: &DMatrix<f64>, rows: usize| {
            DMatrix::from_fn(rows, open.len(), |row, column| matrix[(row, open[column])])
        };
        let rank_of = |matrix: &DMatrix<f64>| match matrix.is_empty() {
            true => 0,
            false => {
                let singular = matrix.singular_values();
                singular.iter().filter(|value| **value > RANK * singular.amax()).count()
            }
        };
        for _ in 0..MOST_STEPS {
            let at = self.equations.at(&point);
            let residuals = at.zero.values.rows(0, positions).into_owned();
            if open.is_empty() || residuals.iter().all(|residual| residual.abs() <= 1e-14) {
                break;
            }
            let matrix = columns(&at.zero.by_coordinates, positions);
            let Some(step) = least(&matrix, &residuals) else { break };
            if !step.iter().all(|part| part.is_finite()) || step.amax() <= 1e-16 {
                break;
            }
            for (&place, part) in open.iter().zip(step.iter()) {
                point.coordinates[place] -= part;
            }
        }
        let at = self.equations.at(&point);
        self.met(&at.zero.values, positions, time)?;
        if rank_of(&columns(&at.zero.by_coordinates, positions)) < open.len() {
            let coordinates = open.iter().map(|&place| format!("`{}`", self.model.coordinates[place].name)).collect();
            return Err(NoForces::Open { coordinates, time });
        }
        // rates are linear in speeds once more, accelerations in themselves; constraints of speeds that are not are iterated
        for _ in 0..MOST_STEPS {
            let at = self.equations.at(&point);
            let matrix = columns(&at.rate.by_speeds, at.rate.values.len());
            let Some(step) = least(&matrix, &at.rate.values) else { break };
            if step.amax() <= 1e-15 {
                break;
            }
            open.iter().zip(step.iter()).for_each(|(&place, part)| point.speeds[place] -= part);
        }
        let at = self.equations.at(&point);
        self.met(&at.rate.values, at.rate.values.len(), time)?;
        let matrix = columns(&at.acceleration.by_accelerations, at.acceleration.values.len());
        if let Some(step) = least(&matrix, &at.acceleration.values) {
            open.iter().zip(step.iter()).for_each(|(&place, part)| point.accelerations[place] -= part);
        }
        let at = self.equations.at(&point);
        self.met(&at.acceleration.values, at.acceleration.values.len(), time)?;
        Ok(point)
    }

    fn met(&self, residuals: &DVector<f64>, count: usize, time: f64) -> Result<(), NoForces> {
        let unmet = |residual: &f64| residual.is_nan() || residual.abs() > MET;
        match residuals.iter().take(count).position(|residual| unmet(residual)) {
            None => Ok(()),
            Some(row) => {
                let constraint = match &self.equations.constraints[row] {
                    Known { name, .. } if name.is_empty() => format!("constraint {}", row + 1),
                    Known { name, .. } => format!("the constraint `{name}`"),
                };
                Err(NoForces::Unmet { constraint, residual: residuals[row], time })
            }
        }
    }
}

/// The least solution of a linear system; none of an empty one.
fn least(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if matrix.is_empty() || !matrix.iter().chain(right.iter()).all(|value| value.is_finite()) {
        return None;
    }
    let decomposed = matrix.clone().svd(true, true);
    let largest = decomposed.singular_values.amax();
    decomposed.solve(right, RANK * largest).ok()
}
