//! The Jacobian of a law whose accelerations are solved for. The matrix is factorised once; each directional derivative needs one solve
//! of
//!
//!   A z' = b' - A' z .

use super::{Implicit, Room};
use algebra::linear::NotSolved;
use integrators::{DIRECTIONS, Dual8, JacobianFn, slope, variable};

/// The Jacobian of one law, with work space.
pub(super) struct ImplicitSlopes<'a> {
    implicit: &'a Implicit,
    room: Room<f64>,
    state: Vec<Dual8>,
    terms: Vec<Dual8>,
    rates: Vec<Dual8>,
    /// Right side b' - A' z of one direction; after the solve z'.
    right: Vec<f64>,
}

impl<'a> ImplicitSlopes<'a> {
    pub fn new(implicit: &'a Implicit) -> Self {
        let Implicit { model, pattern, .. } = implicit;
        let zeros = |count: usize| vec![Dual8::from(0.0); count];
        ImplicitSlopes {
            implicit,
            room: Room::new(pattern),
            state: zeros(model.positions() + model.speeds()),
            terms: zeros(pattern.places().len() + pattern.size()),
            rates: zeros(model.positions()),
            right: vec![0.0; pattern.size()],
        }
    }
}

impl ImplicitSlopes<'_> {
    /// Factorises the matrix and solves for the unknowns, which overwrite the right side.
    fn solve(&mut self, t: f64, y: &[f64]) -> Result<(), NotSolved> {
        let Room { terms, factors } = &mut self.room;
        self.implicit.terms.run(t, y, terms).ok_or(NotSolved::NotANumber)?;
        let (entries, right) = terms.split_at_mut(self.implicit.pattern.places().len());
        factors.factor(entries)?;
        factors.solve(right);
        Ok(())
    }

    /// Evaluates the terms, and the rates of the positions, with directional derivatives by time or state.
    fn direct(&mut self, t: Dual8) -> Option<()> {
        self.implicit.model.position_rates(&self.state, &mut self.rates);
        self.implicit.terms.run(t, &self.state, &mut self.terms)
    }

    /// Passes the derivatives of all rates in direction k to `put`.
    fn along(&mut self, k: usize, mut put: impl FnMut(usize, f64)) {
        let pattern = &self.implicit.pattern;
        let (entries, right) = self.terms.split_at(pattern.places().len());
        let unknowns = &self.room.terms[pattern.places().len()..];
        self.right.iter_mut().zip(right).for_each(|(own, right)| *own = slope(right, k));
        for (&(row, column), entry) in pattern.places().iter().zip(entries) {
            self.right[row] -= slope(entry, k) * unknowns[column];
        }
        self.room.factors.solve(&mut self.right);
        let accelerations = &self.right[..self.state.len() - self.rates.len()];
        let rates = self.rates.iter().map(|rate| slope(rate, k)).chain(accelerations.iter().copied());
        rates.enumerate().for_each(|(row, rate)| put(row, rate));
    }
}

impl JacobianFn for ImplicitSlopes<'_> {
    fn matrix(&mut self, t: f64, y: &[f64], matrix: &mut [f64]) {
        let n = y.len();
        self.state.iter_mut().zip(y).for_each(|(own, y)| *own = Dual8::from(*y));
        if self.solve(t, y).is_err() {
            return matrix.fill(f64::NAN);
        }
        for first in (0..n).step_by(DIRECTIONS) {
            let block = DIRECTIONS.min(n - first);
            for k in 0..block {
                self.state[first + k] = variable(y[first + k], k);
            }
            if self.direct(Dual8::from(t)).is_none() {
                return matrix.fill(f64::NAN);
            }
            for k in 0..block {
                self.along(k, |row, slope| matrix[row * n + first + k] = slope);
                self.state[first + k] = Dual8::from(y[first + k]);
            }
        }
    }

    fn by_time(&mut self, t: f64, y: &[f64], slopes: &mut [f64]) {
        self.state.iter_mut().zip(y).for_each(|(own, y)| *own = Dual8::from(*y));
        match self.solve(t, y).is_ok() && self.direct(variable(t, 0)).is_some() {
            true => self.along(0, |row, slope| slopes[row] = slope),
            false => slopes.fill(f64::NAN),
        }
    }
}
