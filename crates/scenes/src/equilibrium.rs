//! An equilibrium near a guess: coordinates at which nothing accelerates, with every speed zero.
//!
//!   h(q, 0) - Q(q, 0) - J^T lambda = 0,    f(q) = 0,    df/dt = 0 at rest
//!
//! Newton's method with least changes, by singular values: where equilibria form a family, the nearest one of it is found. Forces are
//! those of time zero.
//!
//! Where constraints hold speeds, every step goes along displacements that they leave: the equilibrium is one that motions from the
//! start reach. A start that is to be an equilibrium itself may stand elsewhere, where none is reached.

use crate::compiled_system::NotCompiled;
use crate::layout::Layout;
use crate::linearisation::{At, Point, VariedEquations};
use crate::readiness::one_law;
use crate::start::{Leaf, consistent, given};
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// An equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// Coordinates, then speeds, which are zero.
    pub state: Vec<f64>,
    /// Directions of coordinates and reactions in which equilibria stand side by side: of those that motions reach, where they are
    /// sought among these.
    pub family: usize,
    /// Whether it is sought, and found, among positions that motions from the start reach along constraints of speeds.
    pub is_reached: bool,
}

/// Why there is none.
#[derive(Clone, Debug, PartialEq)]
pub enum NoEquilibrium {
    /// A start gives a speed.
    Moves {
        speed: String,
    },
    /// Residual at the best point found.
    NotFound {
        equation: String,
        residual: f64,
    },
    NotCompiled(NotCompiled),
}

/// Steps of Newton's method, each halved up to so often.
const MOST_STEPS: usize = 100;
const MOST_HALVES: usize = 30;

/// A coordinate moves by at most this part of its size, or of one radian or metre, in a step.
const LONGEST: f64 = 0.3;

/// Guesses beside the given one: their number, the first distance from it, in radians or metres, and how distances grow.
const MOST_GUESSES: i32 = 24;
const ASIDE: f64 = 0.05;
const GROWTH: f64 = 1.2;

/// Multiples of the golden section are spread evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Singular values below this part of the largest one are taken for zero.
const RANK: f64 = 1e-11;

/// Residuals below this part of the forces that balance there are rounding.
const MET: f64 = 1e-11;

/// An equation is at least this part as large as the largest one.
const FLOOR: f64 = 1e-3;

/// Coordinates that `[start]` gives are kept; those that it leaves out, or gives as a guess, are moved. With `all` every coordinate is.
///
/// # Errors
/// Why there is none.
pub fn equilibrium(model: &Model, all: bool) -> Result<Equilibrium, NoEquilibrium> {
    one_law(model).map_err(NoEquilibrium::NotCompiled)?;
    let layout = Layout::of(model);
    let (n, names) = (layout.speeds(), model.state_names());
    if let (Some(start), false) = (model.start.iter().find(|start| start.order == 1 && start.value != 0.0), all) {
        return Err(NoEquilibrium::Moves { speed: names[layout.positions() + start.coordinate].0.clone() });
    }
    let equations = VariedEquations::of(model, &[]).map_err(NoEquilibrium::NotCompiled)?;
    let given = given(model);
    let free: Vec<usize> = (0..n).filter(|&speed| all || !layout.places(speed, 0).any(|at| given[at])).collect();
    let mut state = match consistent(model) {
        Ok(completed) if all => completed.state,
        _ => model.start_state(),
    };
    state[layout.positions()..].fill(0.0);
    let guess = equations.point(0.0, &state);
    let sought = |leaf: Option<Leaf<'_>>| {
        let ways = Ways { equations: &equations, free: &free, leaf };
        let (point, system) = ways.near(&guess);
        (point, system, ways.leaf.is_some())
    };
    let leaf = Leaf::of(model);
    let is_held = leaf.is_some();
    let mut found = sought(leaf);
    if is_held && !all && found.1.unmet().is_some() {
        found = sought(None);
    }
    let (point, system, is_reached) = found;
    match system.unmet() {
        None => {
            let unknowns = system.jacobian.ncols();
            let singular: Vec<f64> = match unknowns {
                0 => Vec::new(),
                _ => system.jacobian.singular_values().iter().copied().collect(),
            };
            let largest = singular.iter().copied().fold(0.0, f64::max);
            let rank = singular.iter().filter(|value| **value > RANK * largest).count();
            let state = point.coordinates.iter().chain(point.speeds.iter()).copied().collect();
            Ok(Equilibrium { state, family: unknowns - rank, is_reached })
        }
        Some(row) => {
            let equation = match row.checked_sub(n) {
                None => format!(
                    "the forces along `{}`",
                    names[layout.places(row, usize::from(row >= model.coordinates.len())).start].0
                ),
                Some(k) => {
                    // those of positions stand twice: as they are, and as rates
                    let places = equations.of_positions();
                    let k = places.get(k).copied().unwrap_or_else(|| k - places.len());
                    match equations.constraints[k].name.as_str() {
                        "" => format!("constraint {}", k + 1),
                        name => format!("the constraint `{name}`"),
                    }
                }
            };
            Err(NoEquilibrium::NotFound { equation, residual: system.residuals[row] })
        }
    }
}

impl Equilibrium {
    /// The choice among equilibria, where constraints of speeds decide it.
    pub fn choice(&self) -> Option<String> {
        let family = match self.family {
            0 => String::new(),
            1 => "; it stands in a family of equilibria with one direction".to_owned(),
            many => format!("; it stands in a family of equilibria with {many} directions"),
        };
        let sentence = "constraints hold speeds: this equilibrium is one that motions from the start reach";
        self.is_reached.then(|| format!("{sentence}{family}"))
    }
}

impl VariedEquations {
    /// The places of all constraints of positions.
    fn of_positions(&self) -> Vec<usize> {
        let positions = self.constraints.iter().enumerate().filter(|(_, known)| known.level == Level::Position);
        positions.map(|(place, _)| place).collect()
    }
}

/// Ways from a guess to a point of rest.
struct Ways<'a> {
    equations: &'a VariedEquations,
    /// Speeds whose coordinates may move.
    free: &'a [usize],
    /// Constraints of speeds that the ways go along.
    leaf: Option<Leaf<'a>>,
}

impl Ways<'_> {
    /// The best point that is found from a guess or from others around it.
    fn near(&self, guess: &Point) -> (Point, System) {
        let (mut point, mut system) = self.balanced(guess.clone());
        // a guess at which a force is stationary, an angle of 90 degrees, says nothing of the way: others around it do
        for attempt in 0..MOST_GUESSES {
            if system.unmet().is_none() {
                break;
            }
            let size = ASIDE * GROWTH.powi(attempt);
            // in turn to both sides, by parts that are no multiples of each other
            let side = if attempt % 2 == 0 { size } else { -size };
            let part = |at: usize, _| side * (((at + 1) as f64 * GOLDEN).fract() + 0.5);
            let other = self.moved(guess, &DVector::from_fn(self.free.len(), part));
            let (next, at) = self.balanced(other);
            if at.unmet().is_none() || at.size() < system.size() {
                (point, system) = (next, at);
            }
        }
        (point, system)
    }

    /// The best point that Newton's method comes to from a guess.
    fn balanced(&self, guess: Point) -> (Point, System) {
        let m = guess.multipliers.len();
        let (mut point, mut system) = (guess.clone(), self.system(&guess));
        // multipliers that balance most of the forces, to begin with
        let reactions = system.jacobian.columns(system.jacobian.ncols() - m, m).into_owned();
        if m > 0
            && system.is_finite()
            && let Ok(first) = reactions.svd(true, true).solve(&-&system.residuals, RANK)
        {
            let mut trial = point.clone();
            trial.multipliers += first;
            let at = self.system(&trial);
            if at.size() < system.size() {
                (point, system) = (trial, at);
            }
        }
        for _ in 0..MOST_STEPS {
            if system.size() == 0.0 || system.jacobian.ncols() == 0 || !system.is_finite() {
                break;
            }
            let decomposed = system.jacobian.clone().svd(true, true);
            let largest = decomposed.singular_values.amax();
            let Ok(step) = decomposed.solve(&-&system.residuals, RANK * largest) else { break };
            let displaced = &system.directions * step.rows(0, system.directions.ncols());
            let multipliers = step.rows(system.directions.ncols(), m).into_owned();
            // a step is not longer than the way that derivatives speak for
            let places = self.free.iter().zip(displaced.iter());
            let far = places.map(|(&place, part)| part.abs() / self.equations.size(&point, place));
            let longest = far.fold(LONGEST, f64::max);
            let halves = (0..MOST_HALVES).map(|halves| LONGEST / longest * 0.5_f64.powi(halves as i32));
            let trials = halves.map(|share| {
                let mut trial = self.moved(&point, &(&displaced * share));
                trial.multipliers += &multipliers * share;
                trial
            });
            let better = trials.into_iter().find_map(|trial| {
                let at = self.system(&trial);
                (at.size() < system.size()).then_some((trial, at))
            });
            let Some((next, at)) = better else { break };
            (point, system) = (next, at);
        }
        (point, system)
    }

    /// The point after a displacement of the free coordinates, along the constraints of speeds.
    fn moved(&self, point: &Point, displaced: &DVector<f64>) -> Point {
        let mut next = point.clone();
        match &self.leaf {
            Some(leaf) => {
                let coordinates = leaf.along(point.coordinates.as_slice(), self.free, displaced);
                next.coordinates = DVector::from_vec(coordinates);
            }
            None => {
                for (&place, part) in self.free.iter().zip(displaced.iter()) {
                    self.equations.displace(&mut next, place, *part);
                }
            }
        }
        next
    }

    fn system(&self, point: &Point) -> System {
        let directions = match &self.leaf {
            Some(leaf) => leaf.directions(point.coordinates.as_slice(), self.free),
            None => DMatrix::identity(self.free.len(), self.free.len()),
        };
        System::of(self.equations, point, self.free, directions)
    }
}

/// The equations at a point: residuals, their derivatives along directions and by multipliers, and the size of what balances.
struct System {
    /// Directions of free coordinates, columns.
    directions: DMatrix<f64>,
    residuals: DVector<f64>,
    jacobian: DMatrix<f64>,
    scales: DVector<f64>,
}

impl System {
    fn of(equations: &VariedEquations, point: &Point, free: &[usize], directions: DMatrix<f64>) -> Self {
        let At { motion, zero, rate, .. } = equations.at(point);
        let (n, m) = (motion.values.len(), zero.values.len());
        // constraints of speeds have no f of positions: their row is that of the rate at rest
        let places = equations.of_positions();
        let rows = n + places.len() + m;
        let part = |row: usize| match row.checked_sub(n) {
            None => (&motion, row),
            Some(k) => match places.get(k) {
                Some(&place) => (&zero, place),
                None => (&rate, k - places.len()),
            },
        };
        let value = |row: usize| part(row).0.values[part(row).1];
        let along = DMatrix::from_fn(rows, free.len(), |row, column| {
            let (values, row) = part(row);
            values.by_coordinates[(row, free[column])]
        });
        let along = along * &directions;
        let jacobian = DMatrix::from_fn(rows, directions.ncols() + m, |row, column| {
            match column.checked_sub(directions.ncols()) {
                None => along[(row, column)],
                Some(multiplier) => part(row).0.by_multipliers[(part(row).1, multiplier)],
            }
        });
        let size = |row: usize| {
            let (values, at) = part(row);
            let by_place = (0..n).map(|i| values.by_coordinates[(at, i)].abs() * equations.size(point, i));
            let by_reaction = (0..m).map(|k| (values.by_multipliers[(at, k)] * point.multipliers[k]).abs());
            by_place.chain(by_reaction).sum::<f64>()
        };
        let scales = DVector::from_fn(rows, |row, _| size(row));
        System { directions, residuals: DVector::from_fn(rows, |row, _| value(row)), jacobian, scales }
    }

    fn is_finite(&self) -> bool {
        self.residuals.iter().chain(self.jacobian.iter()).all(|value| value.is_finite())
    }

    fn size(&self) -> f64 {
        let size = self.residuals.norm();
        if size.is_nan() { f64::INFINITY } else { size }
    }

    /// The worst equation that does not hold.
    fn unmet(&self) -> Option<usize> {
        // an equation that nothing changes has no size of its own
        let least = FLOOR * self.scales.iter().copied().fold(0.0, f64::max);
        let excess = |row: usize| self.residuals[row].abs() - MET * self.scales[row].max(least);
        let open = (0..self.residuals.len()).filter(|&row| excess(row).is_nan() || excess(row) > 0.0);
        open.max_by(|&a, &b| self.residuals[a].abs().total_cmp(&self.residuals[b].abs()))
    }
}
