//! Models with state feedback: the closed loop of a regulator, and the integral of its cost as a coordinate without inertia.

use crate::arena::{Arena, Number, Scalar};
use crate::{Constraint, Coordinate, Model, ScalarId, Zero};
use symbolic::Dimension;

/// A linear feedback law about a motion with constant speeds: input k is u_k - sum_i K_ki d_i, where d is the deviation of
/// coordinates and speeds from the motion. Everything is in SI units.
#[derive(Clone, Debug)]
pub struct Feedback {
    /// For each controlled input: its index, its value u along the motion, and its row of K.
    pub inputs: Vec<(usize, f64, Vec<f64>)>,
    /// The motion at time zero: n coordinates, then n speeds.
    pub motion: Vec<f64>,
    /// The symmetric matrix of the cost rate, over the deviations of n coordinates, of n speeds, and of the controlled inputs.
    pub cost: Vec<Vec<f64>>,
}

impl Feedback {
    /// Returns the deviations of the inputs, -K d, for a deviation d of the state (2n numbers).
    pub fn added(&self, deviation: &[f64]) -> Vec<f64> {
        let product = |row: &[f64]| -row.iter().zip(deviation).map(|(gain, part)| gain * part).sum::<f64>();
        self.inputs.iter().map(|(_, _, row)| product(row)).collect()
    }

    /// Returns the cost per unit time at a deviation d of the state (2n numbers).
    pub fn cost(&self, deviation: &[f64]) -> f64 {
        let all = [deviation, &self.added(deviation)].concat();
        let row = |row: &Vec<f64>| row.iter().zip(&all).map(|(entry, part)| entry * part).sum::<f64>();
        self.cost.iter().zip(&all).map(|(own, part)| part * row(own)).sum()
    }
}

impl Model {
    /// Returns the model with its loop closed and an additional last coordinate, the integral of the cost. The model must not have free frames.
    #[must_use]
    pub fn closed_by(&self, feedback: &Feedback) -> Model {
        let mut closed = self.clone();
        let n = self.coordinates.len();
        let mut written = Written { arena: &mut closed.arena, all: Vec::new() };
        let deviations: Vec<ScalarId> = (0..2 * n).map(|place| written.deviation(place, n, &feedback.motion)).collect();
        let mut added = Vec::with_capacity(feedback.inputs.len());
        for (_, _, row) in &feedback.inputs {
            let row: Vec<f64> = row.iter().map(|gain| -gain).collect();
            added.push(written.combination(&row, &deviations));
        }
        for ((input, value, _), &by) in feedback.inputs.iter().zip(&added) {
            let value = written.number(*value);
            closed.inputs[*input].value = Some(written.of(Scalar::Sum(value, by)));
        }
        let all = [deviations, added].concat();
        let rows: Vec<ScalarId> = feedback.cost.iter().map(|row| written.combination(row, &all)).collect();
        let zero = written.number(0.0);
        let cost = all.iter().zip(rows).fold(zero, |sum, (&part, row)| {
            let product = written.of(Scalar::Product(part, row));
            written.of(Scalar::Sum(sum, product))
        });
        closed.ahead = written.all;
        closed.with_integral(cost)
    }

    /// Adds a last coordinate whose rate is the expression `of`.
    fn with_integral(mut self, of: ScalarId) -> Model {
        let (coordinate, at) = (self.coordinates.len(), 0..0);
        // names in files contain no spaces, hence this one is unused
        let name = "integral of the cost".to_owned();
        self.coordinates.push(Coordinate { name, dimension: Dimension::none(), unit: "1".to_owned(), at: at.clone() });
        let rate = self.arena.scalar(Scalar::Rate { coordinate, order: 1 }, None);
        let zero = Zero::Scalar(self.arena.scalar(Scalar::Difference(rate, of), None));
        self.inertialess.push(coordinate);
        self.determining.push(self.constraints.len());
        self.constraints.push(Constraint {
            name: None,
            zero,
            dimension: Dimension::none(),
            gains: None,
            gains_at: at.clone(),
            at,
        });
        self
    }
}

/// Additional expressions, listed after their operands.
struct Written<'a> {
    arena: &'a mut Arena,
    all: Vec<ScalarId>,
}

impl Written<'_> {
    fn of(&mut self, scalar: Scalar) -> ScalarId {
        self.own(scalar, None)
    }

    fn own(&mut self, scalar: Scalar, dimension: Option<Dimension>) -> ScalarId {
        let own = self.arena.scalar(scalar, dimension);
        self.all.push(own);
        own
    }

    fn number(&mut self, value: f64) -> ScalarId {
        self.own(Scalar::Number(Number { value, times: 1.0, per: 1.0 }), Some(Dimension::none()))
    }

    /// Returns the deviation of a coordinate from its motion at constant speed (place < n), or of a speed.
    fn deviation(&mut self, place: usize, n: usize, motion: &[f64]) -> ScalarId {
        let begun = self.number(motion[place]);
        match place.checked_sub(n) {
            Some(coordinate) => {
                let own = self.of(Scalar::Rate { coordinate, order: 1 });
                self.of(Scalar::Difference(own, begun))
            }
            None => {
                let (own, time, speed) = (Scalar::Coordinate(place), Scalar::Time, motion[n + place]);
                let (own, time, speed) = (self.of(own), self.of(time), self.number(speed));
                let way = self.of(Scalar::Product(speed, time));
                let there = self.of(Scalar::Sum(begun, way));
                self.of(Scalar::Difference(own, there))
            }
        }
    }

    fn combination(&mut self, factors: &[f64], of: &[ScalarId]) -> ScalarId {
        let zero = self.number(0.0);
        factors.iter().zip(of).filter(|(factor, _)| **factor != 0.0).fold(zero, |sum, (&factor, &part)| {
            let factor = self.number(factor);
            let product = self.of(Scalar::Product(factor, part));
            self.of(Scalar::Sum(sum, product))
        })
    }
}
