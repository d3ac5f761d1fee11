//! Newton's method for an equilibrium, with least-norm steps.

use super::RANK;
use super::balance::Balance;
use crate::kernel::Rows;
use crate::linearisation::{Point, VariedEquations};
use crate::start::Leaf;
use nalgebra::{DMatrix, DVector};

/// The largest number of Newton steps, and of halvings of one step.
const MOST_STEPS: usize = 100;
const MOST_HALVES: usize = 30;

/// A step changes a coordinate by at most this part of its size, or of one metre or radian.
const LONGEST: f64 = 0.3;

/// Further guesses: their number, their first distance from the given one (m or rad), and the growth factor of the distance.
const MOST_GUESSES: i32 = 24;
const ASIDE: f64 = 0.05;
const GROWTH: f64 = 1.2;

/// The golden ratio conjugate: fractional parts of its multiples are evenly distributed.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// The search for an equilibrium from a guess.
pub(super) struct Ways<'a> {
    /// The equations of the model with their derivatives.
    pub equations: &'a VariedEquations,
    /// Indices of the free coordinates.
    pub free: &'a [usize],
    /// Directions of cyclic charges over all speeds, as columns.
    pub currents: &'a DMatrix<f64>,
    /// Nonholonomic constraints along which displacements must go, if any.
    pub leaf: Option<Leaf<'a>>,
}

impl Ways<'_> {
    /// The best point found from a guess, or from further guesses around it.
    pub fn near(&self, guess: &Point) -> (Point, Balance) {
        let (mut point, mut system) = self.balanced(guess.clone());
        // at a guess with a stationary force, such as an angle of 90 degrees, the step is undetermined
        for attempt in 0..MOST_GUESSES {
            if system.unmet().is_none() {
                break;
            }
            let size = ASIDE * GROWTH.powi(attempt);
            // alternating sides, with incommensurable components
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

    /// The best point that Newton's method reaches from one guess.
    fn balanced(&self, guess: Point) -> (Point, Balance) {
        let m = guess.multipliers.len();
        let (mut point, mut system) = (guess.clone(), self.system(&guess));
        // first guess of the multipliers: least squares of the force balance
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
            let [displaced, currents, multipliers] = system.parts(&step);
            // smaller components are rounding errors of the largest; if real, the next step contains them
            let felt = |part: f64| if part.abs() > f64::EPSILON * step.amax() { part } else { 0.0 };
            let (displaced, currents) = (&system.directions * displaced, self.currents * currents);
            let (displaced, currents) = (displaced.map(felt), currents.map(felt));
            // limits the step to the range in which derivatives are valid
            let places = self.free.iter().zip(displaced.iter());
            let far = places.map(|(&place, part)| part.abs() / self.equations.size(&point, place));
            let grown = point.speeds.iter().zip(currents.iter()).map(|(now, part)| part.abs() / (1.0 + now.abs()));
            let longest = far.chain(grown).fold(LONGEST, f64::max);
            let halves = (0..MOST_HALVES).map(|halves| LONGEST / longest * 0.5_f64.powi(halves as i32));
            let trials = halves.map(|share| {
                let mut trial = self.moved(&point, &(&displaced * share));
                trial.speeds += &currents * share;
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

    /// The point after a displacement of the free coordinates, along the nonholonomic constraints if there are any.
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

    /// The equations at a point, with directions that exclude the cyclic charges.
    fn system(&self, point: &Point) -> Balance {
        let all = match &self.leaf {
            Some(leaf) => leaf.directions(point.coordinates.as_slice(), self.free),
            None => DMatrix::identity(self.free.len(), self.free.len()),
        };
        let mut still = Rows::none(all.ncols());
        still.add(&(self.currents.select_rows(self.free).transpose() * &all));
        let directions = all * still.kernel();
        Balance::of(self.equations, point, (self.free, directions), self.currents)
    }
}
