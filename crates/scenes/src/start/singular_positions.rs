//! The end of a run at a singular position: constraints lose their independence there, and the motion may go on in several ways.
//!
//! With rows of J whose lengths are of the order of one, s = 1/|J^+|, the norm being that of Frobenius, is zero where they depend on
//! each other, and only there; s^2 is one by the trace of (J J^T)^-1. It falls to zero like the distance from such a position, and
//! along a motion its rate is at most |J'|. A row may vanish by itself, so its length is not taken where the motion is, but as the
//! largest at the start and where the angles are others. A motion that has come off its constraints by d passes such a position with
//! s^2 of the order of d.

use super::constraints::Constraints;
use super::start_speeds;
use derivations::scene::law_end::Margin;
use derivations::taped::Program;
use model::Model;
use model::equations::Level;
use nalgebra::{Cholesky, DMatrix};
use std::sync::Arc;

const SINGULAR: &str =
    "its constraints depend on each other at this position, so that the motion may go on in several ways";

/// A position is singular where s falls below this part of its value at the start: bars that differ by a millionth pass it.
const LEAST: f64 = 1e-3;

/// Above this value of s^2 its rate does not matter, since the bound of that is enough.
const FAR: f64 = 0.02;

/// The part of a unit of the state, and of time, over which rates are taken.
const APART: f64 = 1e-7;

/// A position that is off its constraints by d is singular where s^2 is below so many times d.
const DRIFT: f64 = 10.0;

/// But not where s^2 is above so many times the value below which it is singular anyway.
const MOST_DRIFT: f64 = 1e4;

/// By so much angles differ from the start, where the lengths of the rows are looked at: no part of a turn.
const ASIDE: [f64; 3] = [0.37, -0.61, 1.93];

/// The independence of the constraints of a model.
#[derive(Clone, Debug)]
pub(crate) struct SingularPositions {
    program: Arc<Program>,
    parameters: Vec<f64>,
    /// Numbers of all equations, of those of constraints that are kept, and of those of positions among these; then of speeds.
    counts: [usize; 4],
    /// The length of each row.
    lengths: Vec<f64>,
    /// Whether each coordinate is an angle.
    angles: Vec<bool>,
    /// The most by which a coordinate changes the rows, for each unit.
    weights: Vec<f64>,
    /// Whether the time changes the rows by itself.
    knows_time: bool,
    /// The value of s^2 below which a position is singular.
    least: f64,
}

/// The rows of J by their lengths, and how far a state is off its constraints of positions.
struct Rows(DMatrix<f64>, f64);

impl SingularPositions {
    /// None where no constraint is kept, or where they depend on each other at the start.
    pub fn of(model: &Model, start: &[f64]) -> Option<Self> {
        let constraints = Constraints::of(model).ok()?.filter(|constraints| constraints.kept > 0)?;
        let positions = constraints.known.iter().take_while(|known| known.level == Level::Position).count();
        let values: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
        let is_angle = |place: usize| model.coordinates.get(place).is_some_and(|own| own.unit == "rad");
        let singular = SingularPositions {
            parameters: Vec::new(),
            angles: (0..model.positions()).map(is_angle).collect(),
            counts: [constraints.known.len(), constraints.kept, positions.min(constraints.kept), model.speeds()],
            lengths: vec![1.0; constraints.kept],
            weights: vec![0.0; model.positions()],
            knows_time: false,
            least: 0.0,
            program: Arc::new(Program::of_tape(constraints.tape)?),
        };
        singular.of_member(&values, &start_speeds(model), start)
    }

    /// The same with other parameters, quasi-velocities at the start, and another start.
    pub fn of_member(&self, parameters: &[f64], speeds: &[f64], start: &[f64]) -> Option<Self> {
        let [_, kept, ..] = self.counts;
        let mut singular = self.clone();
        singular.parameters = [parameters, speeds].concat();
        singular.lengths = vec![1.0; kept];
        let angles: Vec<usize> = (0..self.angles.len()).filter(|place| self.angles[*place]).collect();
        let aside = |by: &f64| {
            let mut state = start.to_vec();
            angles.iter().for_each(|&place| state[place] += by * (1.0 + place as f64).sqrt());
            state
        };
        let states: Vec<Vec<f64>> = [start.to_vec()].into_iter().chain(ASIDE.iter().map(aside)).collect();
        let all: Vec<DMatrix<f64>> = states.iter().map(|state| singular.rows(0.0, state).0).collect();
        let length = |row: usize| all.iter().map(|rows| rows.row(row).norm()).fold(0.0, f64::max);
        singular.lengths = (0..kept).map(length).collect();
        singular.weights = (0..self.angles.len()).map(|place| singular.weight(&states, place)).collect();
        singular.knows_time =
            ASIDE.iter().any(|time| singular.rows(time.abs(), start).0 != singular.rows(0.0, start).0);
        singular.least = LEAST * LEAST * independence(&singular.rows(0.0, start).0);
        (singular.least > 0.0).then_some(singular)
    }

    /// The most by which a coordinate changes the rows.
    fn weight(&self, states: &[Vec<f64>], place: usize) -> f64 {
        let by = APART.sqrt();
        let change = |state: &Vec<f64>| {
            let mut moved = state.clone();
            moved[place] += by;
            (self.rows(0.0, &moved).0 - self.rows(0.0, state).0).norm() / by
        };
        states.iter().map(change).fold(0.0, f64::max)
    }

    fn rows(&self, time: f64, state: &[f64]) -> Rows {
        let [all, kept, positions, n] = self.counts;
        let mut values = vec![f64::NAN; all * (2 + n)];
        // what it does not write is no number
        let _ = self.program.run(time, &[state, &self.parameters].concat(), &mut values);
        let rows = DMatrix::from_fn(kept, n, |i, j| values[2 * all + i * n + j] / self.lengths[i]);
        let residuals = values.iter().zip(&self.lengths).take(positions);
        Rows(rows, residuals.map(|(residual, length)| (residual / length).abs()).fold(0.0, f64::max))
    }

    /// By how much s^2 is above where a position is singular.
    fn value(&self, Rows(rows, off): &Rows) -> f64 {
        independence(rows) - self.least - (DRIFT * off).min(MOST_DRIFT * self.least)
    }

    /// The distance of a state from a singular position.
    pub fn margin(&self, time: f64, state: &[f64], rates: &[f64]) -> Margin {
        let here = self.rows(time, state);
        let value = self.value(&here);
        // each coordinate changes entries of its own in the main, so that squares add up
        let squares = self.weights.iter().zip(rates).map(|(weight, rate)| (weight * rate) * (weight * rate));
        let mut fastest = squares.sum::<f64>().sqrt();
        let mut rate = 0.0;
        let largest = rates.iter().fold(0.0, |largest: f64, rate| largest.max(rate.abs()));
        if (value < FAR || self.knows_time) && largest > 0.0 && largest.is_finite() {
            let apart = APART / largest.max(1.0);
            let moved: Vec<f64> = state.iter().zip(rates).map(|(part, rate)| part + apart * rate).collect();
            let beside = self.rows(time + apart, &moved);
            rate = (self.value(&beside) - value) / apart;
            fastest = f64::max(fastest, (beside.0 - here.0).norm() / apart);
        }
        Margin { value, rate, fastest, what: SINGULAR }
    }
}

/// The value of s^2.
fn independence(rows: &DMatrix<f64>) -> f64 {
    Cholesky::new(rows * rows.transpose()).map_or(0.0, |product| product.inverse().trace().recip())
}
