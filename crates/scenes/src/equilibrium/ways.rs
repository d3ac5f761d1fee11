//! Newton's method from a guess to an equilibrium, with least changes.

use super::RANK;
use super::balance::Balance;
use crate::kernel::Rows;
use crate::linearisation::{Point, VariedEquations};
use crate::start::Leaf;
use nalgebra::{DMatrix, DVector};

/// The largest number of steps of Newton's method, and of halvings of a step.
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

/// The search for an equilibrium from a guess.
pub(super) struct Ways<'a> {
    pub equations: &'a VariedEquations,
    /// Speeds whose coordinates may move.
    pub free: &'a [usize],
    /// Directions of charges for which no equation asks: over all speeds, columns.
    pub currents: &'a DMatrix<f64>,
    /// Constraints of speeds that the ways go along.
    pub leaf: Option<Leaf<'a>>,
}

impl Ways<'_> {
    /// The best point that is found from a guess or from others around it.
    pub fn near(&self, guess: &Point) -> (Point, Balance) {
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
    fn balanced(&self, guess: Point) -> (Point, Balance) {
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
            let [displaced, currents, multipliers] = system.parts(&step);
            // rounding of the largest part: a part that is none of it comes with the next step
            let felt = |part: f64| if part.abs() > f64::EPSILON * step.amax() { part } else { 0.0 };
            let (displaced, currents) = (&system.directions * displaced, self.currents * currents);
            let (displaced, currents) = (displaced.map(felt), currents.map(felt));
            // a step must stay within the range in which derivatives are valid
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

    fn system(&self, point: &Point) -> Balance {
        let all = match &self.leaf {
            Some(leaf) => leaf.directions(point.coordinates.as_slice(), self.free),
            None => DMatrix::identity(self.free.len(), self.free.len()),
        };
        // along the others no equation changes
        let mut still = Rows::none(all.ncols());
        still.add(&(self.currents.select_rows(self.free).transpose() * &all));
        let directions = all * still.kernel();
        Balance::of(self.equations, point, (self.free, directions), self.currents)
    }
}
