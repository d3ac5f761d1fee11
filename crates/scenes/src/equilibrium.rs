//! An equilibrium near a guess: coordinates at which nothing accelerates, with every speed zero.
//!
//!   h(q, 0) - Q(q, 0) - J^T lambda = 0,    f(q) = 0,    df/dt = 0 at rest
//!
//! Newton's method with least changes, by singular values: where equilibria form a family, the nearest one of it is found. Forces are
//! those of time zero.

use crate::compiled_system::NotCompiled;
use crate::layout::Layout;
use crate::linearisation::{At, Point, VariedEquations};
use crate::readiness::one_law;
use crate::start::given;
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// An equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// Coordinates, then speeds, which are zero.
    pub state: Vec<f64>,
    /// Directions of coordinates and reactions in which equilibria stand side by side.
    pub family: usize,
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
    let mut state = model.start_state();
    state[layout.positions()..].fill(0.0);
    let guess = equations.point(0.0, &state);
    let m = guess.multipliers.len();
    let (mut point, mut system) = balanced(&equations, &free, guess.clone());
    // a guess at which a force is stationary, an angle of 90 degrees, says nothing of the way: others around it do
    let aside = (0..MOST_GUESSES).map(|attempt| {
        let mut other = guess.clone();
        let size = ASIDE * GROWTH.powi(attempt);
        for (at, &place) in free.iter().enumerate() {
            // in turn to both sides, by parts that are no multiples of each other
            let part = ((at + 1) as f64 * GOLDEN).fract() + 0.5;
            equations.displace(&mut other, place, if attempt % 2 == 0 { size * part } else { -size * part });
        }
        other
    });
    for other in aside {
        if system.unmet().is_none() {
            break;
        }
        let (next, at) = balanced(&equations, &free, other);
        if at.unmet().is_none() || at.size() < system.size() {
            (point, system) = (next, at);
        }
    }
    match system.unmet() {
        None => {
            let singular: Vec<f64> = match free.len() + m {
                0 => Vec::new(),
                _ => system.jacobian.singular_values().iter().copied().collect(),
            };
            let largest = singular.iter().copied().fold(0.0, f64::max);
            let rank = singular.iter().filter(|value| **value > RANK * largest).count();
            let state = point.coordinates.iter().chain(point.speeds.iter()).copied().collect();
            Ok(Equilibrium { state, family: free.len() + m - rank })
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

impl VariedEquations {
    /// The places of all constraints of positions.
    fn of_positions(&self) -> Vec<usize> {
        let positions = self.constraints.iter().enumerate().filter(|(_, known)| known.level == Level::Position);
        positions.map(|(place, _)| place).collect()
    }
}

/// The best point that Newton's method comes to from a guess.
fn balanced(equations: &VariedEquations, free: &[usize], guess: Point) -> (Point, System) {
    let m = guess.multipliers.len();
    let (mut point, mut system) = (guess.clone(), System::of(equations, &guess, free));
    // multipliers that balance most of the forces, to begin with
    let reactions = system.jacobian.columns(free.len(), m).into_owned();
    if m > 0
        && system.is_finite()
        && let Ok(first) = reactions.svd(true, true).solve(&-&system.residuals, RANK)
    {
        let trial = moved(equations, &point, &[], &first, 1.0);
        let at = System::of(equations, &trial, free);
        if at.size() < system.size() {
            (point, system) = (trial, at);
        }
    }
    for _ in 0..MOST_STEPS {
        if system.size() == 0.0 || free.is_empty() && m == 0 || !system.is_finite() {
            break;
        }
        let decomposed = system.jacobian.clone().svd(true, true);
        let largest = decomposed.singular_values.amax();
        let Ok(step) = decomposed.solve(&-&system.residuals, RANK * largest) else { break };
        // a step is not longer than the way that derivatives speak for
        let far = free.iter().zip(step.iter()).map(|(&place, part)| part.abs() / equations.size(&point, place));
        let longest = far.fold(LONGEST, f64::max);
        let halves = (0..MOST_HALVES).map(|halves| LONGEST / longest * 0.5_f64.powi(halves as i32));
        let better = halves.map(|share| moved(equations, &point, free, &step, share)).find_map(|trial| {
            let at = System::of(equations, &trial, free);
            (at.size() < system.size()).then_some((trial, at))
        });
        let Some((next, at)) = better else { break };
        (point, system) = (next, at);
    }
    (point, system)
}

/// The equations at a point: residuals, their derivatives by free coordinates and multipliers, and the size of what balances.
struct System {
    residuals: DVector<f64>,
    jacobian: DMatrix<f64>,
    scales: DVector<f64>,
}

impl System {
    fn of(equations: &VariedEquations, point: &Point, free: &[usize]) -> Self {
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
        let slope = |row: usize, column: usize| {
            let (values, row) = part(row);
            match free.get(column) {
                Some(&place) => values.by_coordinates[(row, place)],
                None => values.by_multipliers[(row, column - free.len())],
            }
        };
        let jacobian = DMatrix::from_fn(rows, free.len() + m, slope);
        let size = |row: usize| {
            let (values, at) = part(row);
            let by_place = (0..n).map(|i| values.by_coordinates[(at, i)].abs() * equations.size(point, i));
            let by_reaction = (0..m).map(|k| (values.by_multipliers[(at, k)] * point.multipliers[k]).abs());
            by_place.chain(by_reaction).sum::<f64>()
        };
        let scales = DVector::from_fn(rows, |row, _| size(row));
        System { residuals: DVector::from_fn(rows, |row, _| value(row)), jacobian, scales }
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

/// A share of a step: of free coordinates, then of multipliers.
fn moved(equations: &VariedEquations, point: &Point, free: &[usize], step: &DVector<f64>, share: f64) -> Point {
    let mut next = point.clone();
    for (&place, part) in free.iter().zip(step.iter()) {
        equations.displace(&mut next, place, share * part);
    }
    for (multiplier, part) in next.multipliers.iter_mut().zip(step.iter().skip(free.len())) {
        *multiplier += share * part;
    }
    next
}
