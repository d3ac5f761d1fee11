//! Search for an equilibrium near a guess: all accelerations and speeds are zero, except steady currents.
//!
//!   h(q, u) - Q(q, u) - J^T lambda = 0,    f(q) = 0,    df/dt = 0,    u = D i
//!
//! The columns of D are directions of cyclic charges, on which no equation depends. The unknowns are coordinates, multipliers λ, and the
//! rates i of these charges.
//!
//! The method is Newton's with least-norm steps by singular value decomposition; in a family of equilibria it finds one near the guess.
//! Forces are evaluated at time zero.
//!
//! With nonholonomic constraints, steps are displacements along the constraints, so that motions from the start can reach the
//! equilibrium. If none is found, a start that must itself be an equilibrium is searched for without this restriction.

mod balance;
mod ways;

use crate::compiled_system::NotCompiled;
use crate::layout::Layout;
use crate::linearisation::{Point, VariedEquations};
use crate::row_units::{force_unit, rate_unit};
use crate::start::{Leaf, consistent, given};
use model::equations::Level;
use model::{Model, StartValue};
use nalgebra::DMatrix;
use symbolic::Dimension;
use ways::Ways;

/// An equilibrium, with information on its uniqueness.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// Coordinates, then speeds (SI); speeds are zero except steady currents.
    pub state: Vec<f64>,
    /// The dimension of the family of equilibria in coordinates, currents and multipliers. If `is_reached`, only displacements along the
    /// constraints count.
    pub family: usize,
    /// Names of the coordinates and currents along which no force changes to first order: the largest component of each such direction.
    pub flat: Vec<String>,
    /// True if the equilibrium was found among positions that motions from the start reach along constraints of speeds.
    pub is_reached: bool,
}

/// The reason for which there is no equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub enum NoEquilibrium {
    /// The start has a nonzero speed.
    Moves {
        speed: String,
    },
    /// No solution was found: the equation with the largest residual at the best point, and `is_moved`: whether a coordinate changes it
    /// to first order.
    NotFound {
        equation: String,
        residual: f64,
        unit: String,
        is_moved: bool,
    },
    /// The rate of a constraint does not vanish at zero speeds, in any position. `residual` is this rate.
    Driven {
        constraint: String,
        residual: f64,
        unit: String,
    },
    /// The condition with this index is zero at the equilibrium, or has another case there than in the law that was solved.
    AtCondition {
        switch: usize,
    },
    NotCompiled(NotCompiled),
}

/// Singular values below this part of the largest count as zero.
const RANK: f64 = 1e-11;

/// The largest number of restarts after the conditions have other cases at the solution than at the guess.
const MOST_LAWS: usize = 8;

/// The point with each condition in its case at this point.
fn chosen(equations: &VariedEquations, point: &Point) -> Point {
    let mut there = point.clone();
    equations.choose(&mut there);
    there
}

/// Searches for an equilibrium. Coordinates given in `[start]` are fixed; those that are missing or given as a guess are unknowns. With
/// `all` every coordinate is an unknown. Currents at the start are the first guess.
///
/// # Errors
/// [`NoEquilibrium`] with the reason.
pub fn equilibrium(model: &Model, all: bool) -> Result<Equilibrium, NoEquilibrium> {
    let layout = Layout::of(model);
    let (n, names) = (layout.speeds(), model.state_names());
    // inputs that depend on the state are ordinary forces
    let equations = VariedEquations::with_inputs(model, &[], &[]).map_err(NoEquilibrium::NotCompiled)?;
    let is_current = |start: &&StartValue| equations.charges.contains(&start.coordinate);
    let mut moving = model.start.iter().filter(|start| start.order == 1 && start.value != 0.0 && !is_current(start));
    if let (Some(start), false) = (moving.next(), all) {
        return Err(NoEquilibrium::Moves { speed: names[layout.positions() + start.coordinate].0.clone() });
    }
    let state = match consistent(model) {
        Ok(completed) if all || !model.start_speeds.is_empty() => completed.state,
        _ => model.start_state(),
    };
    let mut guess = equations.point(0.0, &state);
    let currents = equations.cyclic(&equations.around(&guess), &equations.charges);
    guess.speeds = &currents * (currents.transpose() * &guess.speeds);
    let given = given(model);
    // the value of a cyclic charge is arbitrary: it keeps its start
    let is_cyclic = |speed: usize| currents.row(speed).norm() > 1.0 - FLAT;
    let is_free = |&speed: &usize| !is_cyclic(speed) && (all || !layout.places(speed, 0).any(|at| given[at]));
    let free: Vec<usize> = (0..n).filter(is_free).collect();
    let sought = |leaf: Option<Leaf<'_>>| {
        let ways = Ways { equations: &equations, free: &free, currents: &currents, leaf };
        let (mut point, mut system) = ways.near(&guess);
        for _ in 0..MOST_LAWS {
            let there = chosen(&equations, &point);
            if there.switches == point.switches || system.unmet().is_some() {
                break;
            }
            (point, system) = ways.near(&there);
        }
        (point, system, ways.leaf.is_some())
    };
    let is_bound = |leaf: &Leaf<'_>| leaf.directions(guess.coordinates.as_slice(), &free).ncols() < free.len();
    let leaf = Leaf::of(model).filter(is_bound);
    let is_held = leaf.is_some();
    let mut found = sought(leaf);
    if is_held && !all && found.1.unmet().is_some() {
        found = sought(None);
    }
    let (point, system, is_reached) = found;
    if system.unmet().is_none() {
        let there = chosen(&equations, &point);
        let changed = (0..point.switches.len()).find(|&switch| there.switches[switch] != point.switches[switch]);
        if let Some(switch) = equations.kinked_switch(&point).or(changed) {
            return Err(NoEquilibrium::AtCondition { switch });
        }
    }
    match system.unmet() {
        None => {
            let unknowns = system.jacobian.ncols();
            let is_known = unknowns > 0 && system.jacobian.iter().all(|entry| entry.is_finite());
            let decomposed = is_known.then(|| square(&system.jacobian).svd(false, true));
            let singular: &[f64] = decomposed.as_ref().map_or(&[], |decomposed| decomposed.singular_values.as_slice());
            let largest = singular.iter().copied().fold(0.0, f64::max);
            let vanish = (0..singular.len()).filter(|&k| singular[k] <= RANK * largest);
            let along = decomposed.as_ref().and_then(|decomposed| decomposed.v_t.as_ref());
            let flat = vanish.clone().filter_map(|k| {
                let [places, rates, _] = system.parts(&along?.row(k).transpose());
                let (places, rates) = (&system.directions * places, &currents * rates);
                let of_current = || names[layout.positions() + rates.iamax()].0.clone();
                match (places.amax() > FLAT, rates.amax() > FLAT) {
                    (true, _) => Some(name_of(&names, layout, free[places.iamax()])),
                    (false, is_current) => is_current.then(of_current),
                }
            });
            let mut flat: Vec<String> = flat.collect();
            flat.sort();
            flat.dedup();
            let state = point.coordinates.iter().chain(point.speeds.iter()).copied().collect();
            Ok(Equilibrium { state, family: vanish.count(), flat, is_reached })
        }
        Some(row) => {
            let (equation, unit) = match row.checked_sub(n) {
                None => {
                    let name = name_of(&names, layout, row);
                    let along = model.coordinates.get(row).map_or_else(Dimension::none, |own| own.dimension);
                    (format!("the equation of forces along `{name}`"), force_unit(along))
                }
                Some(k) => {
                    // position constraints have two rows: f and df/dt
                    let places = equations.of_positions();
                    let known = &equations.constraints[places.get(k).copied().unwrap_or_else(|| k - places.len())];
                    if k >= places.len() && system.jacobian.row(row).amax() == 0.0 {
                        let unit = if known.level == Level::Position { rate_unit(&known.of) } else { known.of.clone() };
                        let (constraint, residual) = (known.title(), system.residuals[row]);
                        return Err(NoEquilibrium::Driven { constraint, residual, unit });
                    }
                    match k < places.len() {
                        true => (known.title(), known.of.clone()),
                        false if known.level == Level::Position => {
                            (format!("the rate of {}", known.title()), rate_unit(&known.of))
                        }
                        false => (known.title(), known.of.clone()),
                    }
                }
            };
            let is_moved = system.is_moved(row);
            Err(NoEquilibrium::NotFound { equation, residual: system.residuals[row], unit, is_moved })
        }
    }
}

/// Components of a unit vector below this value are rounding errors.
const FLAT: f64 = 1e-6;

/// The name of the coordinate of a speed; for a free frame the name of its rotation component.
fn name_of(names: &[(String, String)], layout: Layout, speed: usize) -> String {
    let order = usize::from(layout.places(speed, 0).len() > 1);
    names[layout.places(speed, order).start].0.clone()
}

/// The matrix with rows of zeros appended until it is square or tall: then each column direction has a singular value.
fn square(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let rows = matrix.nrows().max(matrix.ncols());
    DMatrix::from_fn(rows, matrix.ncols(), |row, column| if row < matrix.nrows() { matrix[(row, column)] } else { 0.0 })
}

impl Equilibrium {
    /// A sentence on the selection among several equilibria; `None` if the equilibrium is isolated and not restricted by constraints of
    /// speeds.
    pub fn choice(&self) -> Option<String> {
        if let (false, [_, ..]) = (self.is_reached, self.flat.as_slice()) {
            let flat: Vec<String> = self.flat.iter().map(|name| format!("`{name}`")).collect();
            return Some(format!(
                "at this equilibrium no force rises with {} to first order: it is one of a family, or terms of higher order hold it, and \
                 then its place is known roughly",
                flat.join(", ")
            ));
        }
        let family = match self.family {
            0 => String::new(),
            1 => "; it belongs to a family of equilibria with one parameter".to_owned(),
            many => format!("; it belongs to a family of equilibria with {many} parameters"),
        };
        let sentence = "constraints hold speeds: this equilibrium is one that motions from the start reach";
        self.is_reached.then(|| format!("{sentence}{family}"))
    }
}
