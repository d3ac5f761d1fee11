//! Singular positions of a run, at which the constraints become linearly dependent. Beyond such a position several motions, or none, may
//! exist, and the run ends.
//!
//! Let J be the Jacobian with rows scaled to lengths of about one. The measure s = 1/|J^+|, with the Frobenius norm of the pseudoinverse, is
//! zero if and only if the rows are linearly dependent; s^-2 is the trace of (J J^T)^-1. Near a singular position s is proportional to the
//! distance from it, and along a motion |s'| is at most |J'|. A row may be zero at some positions; rows are therefore divided by their largest
//! length at the start and at displaced positions. If a motion violates its constraints by d, s^2 is of the order of d at a singular position.

use super::constraints::Constraints;
use super::start_speeds;
use integrators::Pace;
use model::equations::Level;
use model::{Coordinate, Model};
use nalgebra::{Cholesky, DMatrix, DVector};
use simulation::Program;
use simulation::events::Margin;
use std::sync::{Arc, Mutex, PoisonError};

const SINGULAR: &str =
    "singular position: the constraints are linearly dependent here, and several motions may follow, or none";

const KEPT: &str = "the constraints that are used become dependent at this position, but the redundant one, which was left out, would still \
     hold the system: remove one of the others from the file instead, and the run passes this position";

/// A position is singular where s is below this fraction of its largest value at the start and at displaced positions, so that a start near a
/// singular position does not lower the threshold. If lengths of bars differ from the singular ones by the fraction e, s comes down to the
/// order of e^(1/2). Motions therefore pass such positions mostly for e = 1e-6, and always for e = 1e-4.
const LEAST: f64 = 1e-3;

/// Above this value of s^2 its rate is not computed, since the bound by |J'| is sufficient.
const FAR: f64 = 0.02;

/// Increment of the state (SI units) and of the time (s) for numerical derivatives.
const APART: f64 = 1e-7;

/// With the constraints violated by d, a position is singular where s^2 is below this multiple of d.
const DRIFT: f64 = 10.0;

/// Largest number of Newton's iterations that project a state onto the constraints.
const CORRECTIONS: usize = 4;

/// Violations of the constraints below this size count as zero.
const MET: f64 = 1e-12;

/// The allowance for violations is at most this multiple of the threshold of s^2.
const MOST_DRIFT: f64 = 1e4;

/// Safety factor for the bound of |J'|, which is measured at a few positions only.
const SAFETY: f64 = 2.0;

/// Displacements from the start at which J is evaluated: in radians, no simple fractions of a turn, or as multiples of the length over which
/// J changes.
const ASIDE: [f64; 3] = [0.37, -0.61, 1.93];

/// Compiled measure of the linear independence of a model's constraints.
#[derive(Debug)]
pub(crate) struct SingularPositions {
    program: Arc<Program>,
    parameters: Vec<f64>,
    /// Numbers of all equations, of enforced constraints, of position constraints among these, and of speeds.
    counts: [usize; 4],
    /// The number of independent enforced constraints.
    rank: usize,
    /// The length by which each row is divided.
    lengths: Vec<f64>,
    /// For each coordinate, whether it is an angle.
    angles: Vec<bool>,
    /// For each coordinate, a bound of the change of J per unit.
    weights: Vec<f64>,
    /// Whether J depends explicitly on time.
    knows_time: bool,
    /// The threshold of s^2, below which a position is singular.
    least: f64,
    /// Buffers for a state and a neighbouring state.
    looks: Mutex<[Look; 2]>,
    /// If redundant constraints were removed: the measure with these included.
    whole: Option<Box<SingularPositions>>,
}

/// The constraints at one state, and buffers for their evaluation.
#[derive(Clone, Debug)]
struct Look {
    /// State and parameters.
    input: Vec<f64>,
    /// The outputs of the program of the constraints: values of all constraints, their time derivatives, and the rows of the Jacobian.
    values: Vec<f64>,
    /// The scaled rows of the Jacobian J, one row for each retained constraint and one column for each speed.
    rows: DMatrix<f64>,
    /// The largest scaled residual of the position constraints.
    off: f64,
    /// J J^T, and the inverse of its Cholesky factor L.
    product: DMatrix<f64>,
    inverse: DMatrix<f64>,
}

impl Look {
    fn new([all, kept, _, speeds]: [usize; 4]) -> Self {
        Look {
            input: Vec::new(),
            // entries that the program does not write are NaN
            values: vec![f64::NAN; all * (2 + speeds)],
            rows: DMatrix::zeros(kept, speeds),
            off: 0.0,
            product: DMatrix::zeros(kept, kept),
            inverse: DMatrix::zeros(kept, kept),
        }
    }

    /// The value of s^2 at full rank from the Cholesky factor: tr (J J^T)^-1 = |L^-1|^2. If J has the smaller rank `rank`, from the `rank` largest
    /// eigenvalues of J J^T.
    fn independence(&mut self, rank: usize) -> f64 {
        let Look { rows, product, inverse, .. } = self;
        for i in 0..rows.nrows() {
            for j in 0..=i {
                product[(i, j)] = rows.row(i).dot(&rows.row(j));
                product[(j, i)] = product[(i, j)];
            }
        }
        if rank < rows.nrows() {
            let mut values: Vec<f64> = product.symmetric_eigenvalues().iter().copied().collect();
            values.sort_by(|one, other| other.total_cmp(one));
            let trace: f64 = values.iter().take(rank).map(|value| value.max(0.0).recip()).sum();
            return trace.recip();
        }
        let Some(factor) = Cholesky::new(std::mem::replace(product, DMatrix::zeros(0, 0))) else {
            *product = DMatrix::zeros(rows.nrows(), rows.nrows());
            return 0.0;
        };
        inverse.fill_with_identity();
        factor.l_dirty().solve_lower_triangular_mut(inverse);
        *product = factor.unpack_dirty();
        inverse.norm_squared().recip()
    }
}

impl SingularPositions {
    /// Whether a run ended for the reason `why` at a singular position.
    pub fn ends(why: &str) -> bool {
        why == SINGULAR || why == KEPT
    }

    /// The measure for a model and its start; `None` if no constraint is enforced or the constraints are dependent at the start.
    pub fn of(model: &Model, start: &[f64]) -> Option<Self> {
        let own = SingularPositions::with(model, 0, start)?;
        let whole = match model.implied.len() {
            0 => None,
            left_out => SingularPositions::with(&model.whole(), left_out, start).map(Box::new),
        };
        Some(SingularPositions { whole, ..own })
    }

    /// The measure for a model with `redundant` redundant equations.
    fn with(model: &Model, redundant: usize, start: &[f64]) -> Option<Self> {
        let constraints = Constraints::of(model).ok()?.filter(|constraints| constraints.kept > redundant)?;
        let positions = constraints.known.iter().take_while(|known| known.level == Level::Position).count();
        let values: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
        let is_angle = |place: usize| model.coordinates.get(place).is_some_and(Coordinate::is_angle);
        let singular = SingularPositions {
            parameters: Vec::new(),
            angles: (0..model.positions()).map(is_angle).collect(),
            counts: [constraints.known.len(), constraints.kept, positions.min(constraints.kept), model.speeds()],
            rank: constraints.kept - redundant,
            whole: None,
            lengths: vec![1.0; constraints.kept],
            weights: vec![0.0; model.positions()],
            knows_time: false,
            least: 0.0,
            program: Arc::new(Program::of_tape(constraints.tape)?),
            looks: Mutex::new([Look::new([0; 4]), Look::new([0; 4])]),
        };
        singular.of_member(&values, &start_speeds(model), start)
    }

    /// The measure for a member of an ensemble with its parameters, quasi-velocities and start, with the compiled program shared.
    pub fn of_member(&self, parameters: &[f64], speeds: &[f64], start: &[f64]) -> Option<Self> {
        let [_, kept, ..] = self.counts;
        let mut singular = SingularPositions {
            program: Arc::clone(&self.program),
            parameters: [parameters, speeds].concat(),
            lengths: vec![1.0; kept],
            angles: self.angles.clone(),
            weights: Vec::new(),
            looks: Mutex::new([Look::new(self.counts), Look::new(self.counts)]),
            whole: match &self.whole {
                Some(whole) => whole.of_member(parameters, speeds, start).map(Box::new),
                None => None,
            },
            ..*self
        };
        let here = singular.look(0.0, start);
        singular.lengths = (0..kept).map(|row| here.rows.row(row).norm()).collect();
        let scales: Vec<f64> = (0..self.angles.len()).map(|place| singular.scale(start, place)).collect();
        let aside = |by: &f64| {
            let mut state = start.to_vec();
            scales
                .iter()
                .enumerate()
                .for_each(|(place, scale)| state[place] += by * scale * (1.0 + place as f64).sqrt());
            state
        };
        let states: Vec<Vec<f64>> = [start.to_vec()].into_iter().chain(ASIDE.iter().map(aside)).collect();
        singular.lengths = vec![1.0; kept];
        let all: Vec<Look> = states.iter().map(|state| singular.look(0.0, state)).collect();
        let length = |row: usize| all.iter().map(|look| look.rows.row(row).norm()).fold(0.0, f64::max);
        singular.lengths = (0..kept).map(length).collect();
        singular.weights = (0..self.angles.len()).map(|place| singular.weight(&states, place)).collect();
        let mut at_start = singular.look(0.0, start);
        singular.knows_time = ASIDE.iter().any(|time| singular.look(time.abs(), start).rows != at_start.rows);
        let independence = |state: &Vec<f64>| singular.look(0.0, state).independence(self.rank);
        let largest = states.iter().map(independence).fold(0.0, f64::max);
        singular.least = LEAST * LEAST * largest;
        (at_start.independence(self.rank) > 0.0).then_some(singular)
    }

    /// The unit of displacement of a coordinate: one radian, or the length over which J changes by its own size. Zero for lengths in models
    /// with free frames.
    fn scale(&self, start: &[f64], place: usize) -> f64 {
        match self.angles[place] {
            true => 1.0,
            false if self.angles.len() > self.counts[3] => 0.0,
            false => Some(self.weight(&[start.to_vec()], place)).filter(|&weight| weight > 0.0).map_or(0.0, f64::recip),
        }
    }

    /// The bound of the change of J per unit of a coordinate, from the given states.
    fn weight(&self, states: &[Vec<f64>], place: usize) -> f64 {
        let by = APART.sqrt();
        let change = |state: &Vec<f64>| {
            let mut moved = state.clone();
            moved[place] += by;
            (self.look(0.0, &moved).rows - self.look(0.0, state).rows).norm() / by
        };
        SAFETY * states.iter().map(change).fold(0.0, f64::max)
    }

    fn look(&self, time: f64, state: &[f64]) -> Look {
        let mut look = Look::new(self.counts);
        self.look_at(time, state.iter().copied(), &mut look);
        look
    }

    fn look_at(&self, time: f64, state: impl Iterator<Item = f64>, look: &mut Look) {
        let [all, kept, positions, n] = self.counts;
        look.input.clear();
        look.input.extend(state.chain(self.parameters.iter().copied()));
        look.values.fill(f64::NAN);
        let _ = self.program.run(time, &look.input, &mut look.values);
        for i in 0..kept {
            for j in 0..n {
                look.rows[(i, j)] = look.values[2 * all + i * n + j] / self.lengths[i];
            }
        }
        let residuals = look.values.iter().zip(&self.lengths).take(positions);
        look.off = residuals.map(|(residual, length)| (residual / length).abs()).fold(0.0, f64::max);
    }

    /// The value of s^2 minus the threshold and minus the allowance for violated constraints; negative at singular positions.
    fn value(&self, look: &mut Look) -> f64 {
        look.independence(self.rank) - self.least - (DRIFT * look.off).min(MOST_DRIFT * self.least)
    }

    /// The function [`Self::value`] at the projection of a state onto the constraints; `None` if the projection fails, or with free frames.
    fn on_constraints(&self, time: f64, state: &[f64], look: &mut Look) -> Option<f64> {
        let [_, _, positions, n] = self.counts;
        if positions == 0 || self.angles.len() != n {
            return None;
        }
        let mut moved = state.to_vec();
        for _ in 0..=CORRECTIONS {
            self.look_at(time, moved.iter().copied(), look);
            if look.off <= MET {
                return Some(self.value(look));
            }
            let rows = look.rows.rows(0, positions);
            let residuals = look.values.iter().zip(&self.lengths).take(positions);
            let residuals = DVector::from_iterator(positions, residuals.map(|(residual, length)| residual / length));
            let shares = Cholesky::new(rows * rows.transpose())?.solve(&residuals);
            let step = rows.transpose() * shares;
            moved.iter_mut().zip(step.iter()).for_each(|(own, step)| *own -= step);
        }
        None
    }

    /// The margin of a state: s^2 above the threshold, its rate along the motion (1/s), and a bound of that rate.
    pub fn margin(&self, time: f64, state: &[f64], rates: &[f64]) -> Margin {
        let mut looks = self.looks.lock().unwrap_or_else(PoisonError::into_inner);
        let [here, beside] = &mut *looks;
        self.look_at(time, state.iter().copied(), here);
        let own = self.value(here);
        // at a state that violates its constraints the value is unreliable
        let value = match own <= 0.0 && here.off > MET {
            true => self.on_constraints(time, state, beside).unwrap_or(own),
            false => own,
        };
        // coordinates mostly change different entries of J, so that squares add up
        let squares = self.weights.iter().zip(rates).map(|(weight, rate)| (weight * rate) * (weight * rate));
        let near = squares.sum::<f64>().sqrt();
        let (mut rate, mut pace) = (0.0, near);
        let largest = rates.iter().fold(0.0, |largest: f64, rate| largest.max(rate.abs()));
        if largest > 0.0 && largest.is_finite() {
            let apart = APART / largest.max(1.0);
            let moved = state.iter().zip(rates).map(|(part, rate)| part + apart * rate);
            self.look_at(time + apart, moved, beside);
            if value < FAR || self.knows_time {
                rate = (self.value(beside) - own) / apart;
            }
            let changes = beside.rows.iter().zip(&here.rows).map(|(moved, own)| (moved - own) * (moved - own));
            pace = changes.sum::<f64>().sqrt() / apart;
        }
        let pace = Pace { near: near.max(pace), own: pace };
        let is_left_out = value < self.least && self.whole.as_ref().is_some_and(|whole| whole.is_regular(time, state));
        Margin { value, rate, pace, what: if is_left_out { KEPT } else { SINGULAR }, goes_on: true }
    }

    /// Whether s^2 at a state is above twice the threshold.
    fn is_regular(&self, time: f64, state: &[f64]) -> bool {
        let [here, _] = &mut *self.looks.lock().unwrap_or_else(PoisonError::into_inner);
        self.look_at(time, state.iter().copied(), here);
        self.value(here) > self.least
    }
}
