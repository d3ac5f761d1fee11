//! Linearisation of a model about a point: x' = A x + B w, y = C x + D w.
//!
//! The Jacobians are exact derivatives of the equations. Accelerations and reactions at the point enter these derivatives. The state x
//! has the independent variations, first of coordinates, then of speeds; constraints eliminate the others. Nonholonomic constraints leave
//! fewer speeds than coordinates in x.
//!
//! A free frame is varied by three small rotations about its own axes instead of the four components of its quaternion.

mod about;
mod at_rest;
mod cyclic;
mod displacement;
mod equations;
mod independence;
mod inertia;
mod kinks;
mod multipliers;
mod names;
mod over_fields;
mod point;
pub mod points;
mod recurrence;
mod stability;

pub use about::{Linear, inputs_of, point_of};
pub use at_rest::law_at_rest;
pub use equations::{At, NamedConstraint, Point, Values, VariedEquations};
pub use multipliers::{Multipliers, NoMultipliers, Ones, Orbit};
pub use names::Names;
pub use point::Undetermined;
pub use points::Standing;
pub use stability::{Spectrum, Stability, eigenvalues};

pub(crate) use independence::dependent;
use independence::others;
pub(crate) use inertia::without_inertia;
use model::Model;
use nalgebra::DMatrix;
pub(crate) use over_fields::AllSlopes;
use point::solved;
use reader::Issue;
use std::fmt;

/// The linear equations about a point. The state x has small displacements in SI units (rotations in rad), then variations of speeds.
#[derive(Clone, Debug)]
pub struct Linearisation {
    /// The point, with its accelerations and multipliers.
    pub point: Point,
    /// Indices of the speeds whose displacements are in x: of coordinates, and rotations of free frames.
    pub coordinates: Vec<usize>,
    /// Indices of the speeds in x.
    pub speeds: Vec<usize>,
    /// Variations of all displacements, then of all speeds, as functions of x: 2n rows for n speeds, one column for each state.
    pub variations: DMatrix<f64>,
    /// A: states by states.
    pub a: DMatrix<f64>,
    /// B: states by inputs.
    pub b: DMatrix<f64>,
    /// C: outputs by states.
    pub c: DMatrix<f64>,
    /// D: outputs by inputs.
    pub d: DMatrix<f64>,
}

impl Linearisation {
    /// The matrices with their names, row by row.
    pub fn matrices(&self) -> [(&'static str, Vec<Vec<f64>>); 4] {
        let rows = |matrix: &DMatrix<f64>| matrix.row_iter().map(|row| row.iter().copied().collect()).collect();
        [("A", rows(&self.a)), ("B", rows(&self.b)), ("C", rows(&self.c)), ("D", rows(&self.d))]
    }
}

/// The reason for which a linearisation does not exist.
#[derive(Clone, Debug, PartialEq)]
pub enum NotLinear {
    /// The equations do not determine accelerations and reactions.
    Undetermined(Undetermined),
    /// A constraint depends on those before it.
    Redundant(Box<NamedConstraint>),
    /// An input appears in a constraint, so that its rates would be inputs too.
    DrivenConstraint { input: String, constraint: Box<NamedConstraint> },
    /// The condition with this index is zero at the point, a kink.
    AtCondition { switch: usize },
    /// The coordinates of these speeds are singular at the point: they have no inertia there.
    SingularCoordinates { speeds: Vec<usize> },
    /// The output with this index has no finite derivative.
    SteepOutput { output: usize },
    /// A derivative has no finite value.
    NotFinite,
}

impl fmt::Display for NotLinear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Undetermined(why) => write!(f, "{why}"),
            Self::Redundant(known) => write!(f, "{} depends on those before it", known.title()),
            Self::DrivenConstraint { input, constraint } => write!(
                f,
                "the input `{input}` moves {}, whose rates of it would be inputs too; inputs of forces are accepted",
                constraint.title()
            ),
            Self::AtCondition { switch } => write!(
                f,
                "condition {} of `if`, `sign`, `abs`, `min`, `max` or `table` is zero: the equations have no derivative",
                switch + 1
            ),
            Self::SingularCoordinates { .. } => {
                write!(f, "the mass matrix is singular: these coordinates do not describe the position")
            }
            Self::SteepOutput { output } => write!(f, "output {} has no finite derivative", output + 1),
            Self::NotFinite => write!(f, "a derivative of the equations has no finite value"),
        }
    }
}

/// Larger derivatives count as infinite.
const STEEP: f64 = 1e250;
impl NotLinear {
    /// The issue with its position in the file, for a point at a time (s).
    pub fn at(&self, model: &Model, time: f64) -> Issue {
        if let Self::SteepOutput { output } = self {
            let name = &model.outputs[*output].name;
            let title = format!("at t = {time} s the output `{name}` has no finite derivative");
            let issue = Issue::at(0..0, title, "in this file");
            return issue.accepted("[outputs] without it, or a point at which none of its conditions is zero");
        }
        let (place, label, accepted) = match self {
            Self::Undetermined(_) | Self::NotFinite | Self::SteepOutput { .. } => (
                0..0,
                "in this file",
                "another point; inertia that resists every coordinate, and constraints that are independent there",
            ),
            Self::Redundant(known) => {
                (known.at.clone(), "this one", "constraints that are independent there, or another point")
            }
            Self::DrivenConstraint { constraint, .. } => (
                constraint.at.clone(),
                "this one",
                "inputs of forces; a constraint that depends on time, without the input",
            ),
            Self::AtCondition { switch } => (
                model.switch_places[*switch].clone(),
                "this condition is zero there",
                "a point at which no condition is zero: another start, or --times",
            ),
            Self::SingularCoordinates { speeds } => {
                let place = speeds.first().and_then(|speed| model.coordinates.get(*speed)).map(|own| own.at.clone());
                (
                    place.unwrap_or_default(),
                    "this coordinate has no inertia there",
                    "coordinates that describe this position, such as angles about another axis, or Cartesian coordinates with a constraint; or \
                     another point",
                )
            }
        };
        Issue::at(place, format!("at t = {time} s {self}"), label).accepted(accepted)
    }
}

impl VariedEquations {
    /// The linear equations about a point, whose accelerations and multipliers are computed first.
    ///
    /// # Errors
    /// [`NotLinear`] with the reason.
    pub fn linearised(&self, point: Point) -> Result<Linearisation, NotLinear> {
        let speeds = self.singular_speeds(&point, &self.at(&point));
        if !speeds.is_empty() {
            return Err(NotLinear::SingularCoordinates { speeds });
        }
        let point = self.with_accelerations(point).map_err(NotLinear::Undetermined)?;
        if let Some(switch) = self.kinked_switch(&point) {
            return Err(NotLinear::AtCondition { switch });
        }
        let at = self.at(&point);
        let (n, m, positions, kept) = (point.speeds.len(), self.constraints.len(), self.positions(), self.kept());
        for (row, constraint) in self.constraints[..kept].iter().enumerate().filter(|(_, known)| !known.is_law) {
            if let Some(column) = (0..self.inputs.len()).find(|&column| {
                [&at.zero, &at.rate, &at.acceleration].iter().any(|part| part.by_inputs[(row, column)] != 0.0)
            }) {
                let input = self.inputs[column].clone();
                return Err(NotLinear::DrivenConstraint { input, constraint: Box::new(constraint.clone()) });
            }
        }
        let redundant = |row: usize| NotLinear::Redundant(Box::new(self.constraints[row].clone()));
        let rows = &at.acceleration.by_accelerations.rows(0, kept).into_owned();
        let fixed_speeds = dependent(rows).map_err(redundant)?;
        let (fixed, _) = fixed_speeds.split_at(positions);
        // the acceleration of a coordinate without inertia contains rates of inputs
        for (row, constraint) in self.constraints[..kept].iter().enumerate().filter(|(_, known)| known.is_law) {
            let is_shown = at.outputs.by_accelerations.column(fixed_speeds[row]).iter().any(|slope| *slope != 0.0);
            let driving = (0..self.inputs.len()).find(|&column| at.rate.by_inputs[(row, column)] != 0.0);
            if let (true, Some(column)) = (is_shown, driving) {
                let input = self.inputs[column].clone();
                return Err(NotLinear::DrivenConstraint { input, constraint: Box::new(constraint.clone()) });
            }
        }
        let (free, free_speeds) = (others(n, fixed), others(n, &fixed_speeds));

        // dq = N x_q, du = P x_u + K dq + L w, with the inputs w of laws without inertia
        let k = self.inputs.len();
        let held = rows.rows(0, positions).into_owned();
        let by_free = tied(&held, fixed, &free, &DMatrix::zeros(positions, 0)).ok_or(NotLinear::NotFinite)?;
        let mut more = DMatrix::zeros(kept, n + k);
        more.columns_mut(0, n).copy_from(&at.rate.by_coordinates.rows(0, kept));
        more.columns_mut(n, k).copy_from(&at.rate.by_inputs.rows(0, kept));
        let by_speeds = tied(rows, &fixed_speeds, &free_speeds, &more).ok_or(NotLinear::NotFinite)?;
        let of_speeds = by_speeds.columns(0, free_speeds.len());
        let carried = by_speeds.columns(free_speeds.len(), n);
        let driven = by_speeds.columns(free_speeds.len() + n, k).into_owned();
        let (x_q, x_u) = (free.len(), free_speeds.len());
        let mut coordinates = DMatrix::zeros(n, x_q + x_u);
        coordinates.columns_mut(0, x_q).copy_from(&by_free);
        let mut speeds = DMatrix::zeros(n, x_q + x_u);
        speeds.columns_mut(0, x_q).copy_from(&(carried * &by_free));
        speeds.columns_mut(x_q, x_u).copy_from(&of_speeds);

        // accelerations and multipliers by coordinates, speeds and inputs
        let mut right = DMatrix::zeros(n + m, x_q + x_u + k);
        let by_state =
            |values: &equations::Values| -(&values.by_coordinates * &coordinates + &values.by_speeds * &speeds);
        right.view_mut((0, 0), (n, x_q + x_u)).copy_from(&by_state(&at.motion));
        right.view_mut((n, 0), (m, x_q + x_u)).copy_from(&by_state(&at.acceleration));
        let by_inputs = |values: &equations::Values| -(&values.by_inputs + &values.by_speeds * &driven);
        right.view_mut((0, x_q + x_u), (n, k)).copy_from(&by_inputs(&at.motion));
        right.view_mut((n, x_q + x_u), (m, k)).copy_from(&by_inputs(&at.acceleration));
        let moved = solved(&at, &right).map_err(NotLinear::Undetermined)?;

        let mut a = DMatrix::zeros(x_q + x_u, x_q + x_u);
        let mut b = DMatrix::zeros(x_q + x_u, k);
        let rates = self.displacement_rates(&point, &coordinates, &speeds);
        for (row, &place) in free.iter().enumerate() {
            a.row_mut(row).copy_from(&rates.row(place));
            b.row_mut(row).copy_from(&driven.row(place));
        }
        for (row, &place) in free_speeds.iter().enumerate() {
            a.row_mut(x_q + row).copy_from(&moved.view((place, 0), (1, x_q + x_u)));
            b.row_mut(x_q + row).copy_from(&moved.view((place, x_q + x_u), (1, k)));
        }
        let (accelerations, multipliers) = (moved.rows(0, n), moved.rows(n, m));
        let shown = &at.outputs.by_accelerations * accelerations + &at.outputs.by_multipliers * multipliers;
        let c =
            &at.outputs.by_coordinates * &coordinates + &at.outputs.by_speeds * &speeds + shown.columns(0, x_q + x_u);
        let d = &at.outputs.by_inputs + &at.outputs.by_speeds * &driven + shown.columns(x_q + x_u, k);
        // an output has an infinite derivative where its condition is zero
        let is_steep = |value: &f64| value.is_nan() || value.abs() >= STEEP;
        let steep = (0..c.nrows()).find(|&row| c.row(row).iter().chain(d.row(row).iter()).any(is_steep));
        if let Some(output) = steep {
            return Err(NotLinear::SteepOutput { output });
        }
        match !a.iter().chain(b.iter()).any(is_steep) {
            true => {
                let variations = DMatrix::from_fn(2 * n, x_q + x_u, |row, column| {
                    if row < n { coordinates[(row, column)] } else { speeds[(row - n, column)] }
                });
                Ok(Linearisation { point, coordinates: free, speeds: free_speeds, variations, a, b, c, d })
            }
            false => Err(NotLinear::NotFinite),
        }
    }
}

/// The general solution x of `rows` x + `more` y = 0, as a matrix whose columns belong to the free components of x, then to y. `None` if
/// the columns `fixed` are singular.
fn tied(rows: &DMatrix<f64>, fixed: &[usize], free: &[usize], more: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = rows.ncols();
    let (m, wide) = (rows.nrows(), free.len() + more.ncols());
    let mut all = DMatrix::zeros(n, wide);
    for (column, &place) in free.iter().enumerate() {
        all[(place, column)] = 1.0;
    }
    if m == 0 {
        return Some(all);
    }
    let own = DMatrix::from_fn(m, m, |row, column| rows[(row, fixed[column])]);
    let right = DMatrix::from_fn(m, wide, |row, column| match free.get(column) {
        Some(&place) => -rows[(row, place)],
        None => -more[(row, column - free.len())],
    });
    let solution = own.full_piv_lu().solve(&right)?;
    for (row, &place) in fixed.iter().enumerate() {
        all.row_mut(place).copy_from(&solution.row(row));
    }
    Some(all)
}
