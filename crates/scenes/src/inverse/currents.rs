//! Currents that give a prescribed motion.
//!
//! No equation depends on the charge of a winding. Its current i follows from the laws that contain neither unknowns nor rates of
//! currents, such as the law of a shaft with inertia J, J z + h = k i + J_c^T lambda. Its rate follows from the derivative of these laws
//! along the motion, which needs the third derivatives of the prescribed quantities:
//!
//!   F(t, q, u, z, lambda) = 0,    F_q u + F_u z + F_z z' + F_lambda lambda' + F_t = 0 .
//!
//! The unknown voltage then follows from the law of the winding.

use super::NoForces;
use super::laws::Laws;
use super::least_solution::scaled;
use crate::linearisation::{At, Point, Values, VariedEquations};
use crate::row_units::{force_unit, measured};
use model::Model;
use nalgebra::{DMatrix, DVector};
use symbolic::Dimension;

const MOST_STEPS: usize = 50;
const MOST_HALVES: i32 = 20;

/// Further guesses: their number, their first distance from the given one in amperes, and its growth factor. They are needed since a
/// torque that is quadratic in a current has a zero derivative at zero current.
const MOST_GUESSES: i32 = 12;
const ASIDE: f64 = 0.1;
const GROWTH: f64 = 4.0;

/// Components of a unit vector below this value are rounding errors.
const FLAT: f64 = 1e-6;

/// The equations and unknowns that determine the currents, by their indices.
pub(super) struct Currents<'a> {
    model: &'a Model,
    /// Speeds that are not prescribed.
    pub open: Vec<usize>,
    /// Constraints without unknowns. `rates` are those of them that are not stabilised.
    pub held: Vec<usize>,
    pub rates: Vec<usize>,
    /// Constraints with an unknown: laws of coordinates without inertia. Their multipliers are zero.
    pub driven: Vec<usize>,
    /// Equations of motion without unknowns, which determine currents, and multipliers in these equations.
    pub laws: Vec<usize>,
    pub reactions: Vec<usize>,
    /// Outputs whose zeros express prescribed currents.
    pub prescribed: Vec<usize>,
    /// Directions of cyclic charges over all speeds, as columns.
    directions: DMatrix<f64>,
}

impl<'a> Currents<'a> {
    /// Classifies the equations near a point with the prescribed coordinates. `unknowns` are indices of inputs.
    ///
    /// # Errors
    /// [`NoForces::OfItsStart`]: a current depends on its start.
    pub fn of(
        model: &'a Model,
        (equations, point): (&VariedEquations, &Point),
        (open, unknowns): (Vec<usize>, &[usize]),
        prescribed: &[usize],
    ) -> Result<Self, NoForces> {
        let points = equations.around(point);
        let charges: Vec<usize> = open.iter().copied().filter(|place| equations.charges.contains(place)).collect();
        let directions = equations.cyclic(&points, &charges);
        let holds = |part: fn(&At) -> &Values, row: usize| {
            points.iter().any(|at| unknowns.iter().any(|&unknown| part(at).by_inputs[(row, unknown)] != 0.0))
        };
        let constraints = 0..equations.constraints.len();
        let (driven, held): (Vec<usize>, Vec<usize>) = constraints.partition(|&row| holds(|at| &at.rate, row));
        let rates = held.iter().copied().filter(|&row| row < equations.kept()).collect();
        let (mut laws, prescribed) = (Vec::new(), prescribed.to_vec());
        for row in (0..point.speeds.len()).filter(|_| directions.ncols() > 0) {
            let slopes = |at: &At| at.motion.by_accelerations.row(row) * &directions;
            match (points.iter().any(|at| slopes(at).amax() > 0.0), holds(|at| &at.motion, row)) {
                (false, false) => laws.push(row),
                (true, false) => {
                    return Err(NoForces::OfItsStart {
                        current: model.state_names()[model.positions() + row].0.clone(),
                    });
                }
                (_, true) => {}
            }
        }
        let acts = |multiplier: &usize| {
            points.iter().any(|at| laws.iter().any(|&row| at.motion.by_multipliers[(row, *multiplier)] != 0.0))
        };
        let reactions = held.iter().copied().filter(acts).collect();
        Ok(Currents { model, open, held, rates, driven, laws, reactions, prescribed, directions })
    }

    /// The number of independent currents.
    pub fn count(&self) -> usize {
        self.directions.ncols()
    }

    /// True if a speed is a current that only these laws determine.
    pub fn has(&self, speed: usize) -> bool {
        self.directions.row(speed).norm() > FLAT
    }

    /// The point with its currents and their rates. `third` are the third derivatives of the prescribed coordinates.
    ///
    /// # Errors
    /// The laws have no solution, or do not determine the currents.
    pub fn flow(&self, equations: &VariedEquations, point: Point, third: &DVector<f64>) -> Result<Point, NoForces> {
        if self.count() == 0 {
            return Ok(point);
        }
        let aside = |number: i32| {
            let size = if number == 0 { 0.0 } else { ASIDE * GROWTH.powi((number - 1) / 2) };
            let mut other = point.clone();
            other.speeds += self.directions.column_sum() * if number % 2 == 0 { -size } else { size };
            self.balanced(equations, other)
        };
        let mut found = aside(0);
        for number in 1..=MOST_GUESSES {
            if found.1.unmet().is_none() {
                break;
            }
            let other = aside(number);
            if other.1.size() < found.1.size() {
                found = other;
            }
        }
        let (point, laws) = found;
        let time = point.time;
        if let Some(row) = laws.unmet() {
            return Err(self.unmet(laws.speeds[row], laws.residuals[row], time));
        }
        let free = scaled(&laws.jacobian, &-&laws.residuals).ok_or(NoForces::NotFinite { time })?.free(FLAT);
        let (open, own) = (self.open.len(), free.len());
        if free[..open].contains(&true) {
            return Err(self.open_currents(&free[..open], time));
        }
        if free[own - self.reactions.len()..].contains(&true) {
            let unknowns = own - open;
            let rank = unknowns - free[open..].iter().filter(|one| **one).count();
            return Err(NoForces::NotUnique { rank, unknowns, time });
        }
        self.with_rates(equations, point, third)
    }

    /// The best point that Newton's method reaches from a guess, and the laws there.
    fn balanced(&self, equations: &VariedEquations, guess: Point) -> (Point, Laws) {
        let laws = |point: &Point| Laws::of(self, &equations.at(point), point);
        let (mut known, mut point) = (laws(&guess), guess);
        for _ in 0..MOST_STEPS {
            let Some(step) = scaled(&known.jacobian, &-&known.residuals) else { break };
            let trials = (0..MOST_HALVES).map(|halves| {
                let mut trial = point.clone();
                let step = &step.solution * 0.5_f64.powi(halves);
                let n = self.open.len();
                for (at, &place) in self.open.iter().enumerate() {
                    trial.speeds[place] += step[at];
                    trial.accelerations[place] += step[n + at];
                }
                for (at, &place) in self.reactions.iter().enumerate() {
                    trial.multipliers[place] += step[2 * n + at];
                }
                (laws(&trial), trial)
            });
            let better = trials.into_iter().find(|(at, _)| at.size() < known.size());
            let Some(next) = better else { break };
            (known, point) = next;
        }
        (point, known)
    }

    /// The point with the rates of its currents, from the derivative of the laws.
    fn with_rates(
        &self,
        equations: &VariedEquations,
        mut point: Point,
        third: &DVector<f64>,
    ) -> Result<Point, NoForces> {
        let (time, n) = (point.time, self.open.len());
        // constraints that are not linear in currents contain products of their rates
        for _ in 0..MOST_STEPS {
            let (matrix, right) = Laws::rates(self, &equations.at(&point), &point, third);
            let found = scaled(&matrix, &right).ok_or(NoForces::NotFinite { time })?;
            let free = found.free(FLAT);
            if free[..n].contains(&true) {
                return Err(self.open_currents(&free[..n], time));
            }
            let before = point.accelerations.clone();
            for (at, &place) in self.open.iter().enumerate() {
                point.accelerations[place] = found.solution[at];
            }
            if (&point.accelerations - before).amax() <= f64::EPSILON * point.accelerations.amax() {
                break;
            }
        }
        Ok(point)
    }

    fn unmet(&self, speed: Option<usize>, residual: f64, time: f64) -> NoForces {
        let Some(speed) = speed else { return NoForces::NotFinite { time } };
        let names = self.model.state_names();
        let along = self.model.coordinates.get(speed).map_or_else(Dimension::none, |own| own.dimension);
        let equation = match self.model.coordinates.get(speed) {
            Some(coordinate) => coordinate.name.clone(),
            None => names[self.model.positions() + speed].0.clone(),
        };
        NoForces::NoCurrent { equation, residual: measured(residual, &force_unit(along)), time }
    }

    fn open_currents(&self, free: &[bool], time: f64) -> NoForces {
        let names = self.model.state_names();
        let open = self.open.iter().zip(free).filter(|(_, free)| **free);
        let currents = open.map(|(&place, _)| format!("`{}`", names[self.model.positions() + place].0)).collect();
        NoForces::OpenCurrents { currents, time }
    }
}
