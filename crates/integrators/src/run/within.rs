//! States within an accepted step, for outputs between two steps.
//!
//! Outputs do not affect the steps. The state at an output is computed by a separate step of the method from the
//! beginning of the accepted step: it has the order of the method, and an error at most that of the longer step. If a
//! step has more outputs than a polynomial of degree [`DEGREE`] has nodes, the states at the Chebyshev points are
//! computed and all outputs are interpolated, provided that the polynomial reproduces one more state within the
//! tolerance. The cost of a step is then bounded for any number of outputs. (Barycentric formula: Berrut and Trefethen,
//! SIAM Review 46, 2004.)

use crate::{Failure, Outcome, Real, Span, Tolerance, clock};
use std::time::Instant;

/// The degree of the interpolating polynomial.
const DEGREE: usize = 16;

/// The relative accuracy required of the polynomial for a method without a tolerance.
const MET: f64 = 1e-11;

/// Computes states within steps by additional steps.
pub(crate) struct Within<'a, S> {
    /// Runs the method over a span within one of its steps.
    again: &'a dyn Fn(&Span<'_, S>) -> Outcome<S>,
    /// `None` for a method with a constant step.
    tolerance: Option<&'a Tolerance>,
    /// The number of additional steps.
    pub steps: u64,
    evaluations: u64,
}

/// One end of an accepted step.
#[derive(Clone, Copy)]
pub(crate) struct StepEnd<'s, S> {
    pub time: f64,
    pub state: &'s [S],
}

impl<'a, S: Real> Within<'a, S> {
    pub fn new(again: &'a dyn Fn(&Span<'_, S>) -> Outcome<S>, tolerance: Option<&'a Tolerance>) -> Self {
        Within { again, tolerance, steps: 0, evaluations: 0 }
    }

    /// The state at a time within the step, by one step from its beginning, or by several where one does not succeed.
    ///
    /// # Errors
    /// [`Failure`] where the budget is exhausted, or the method fails within the accepted step.
    pub fn state(&mut self, run: &Span<'_, S>, begin: StepEnd<'_, S>, time: f64) -> Result<Vec<S>, Failure> {
        // the step is too short for its own checks of the clock
        if let Some(over) = clock::over() {
            return Err(over.failure(begin.time));
        }
        if run.budget.deadline.is_some_and(|deadline| Instant::now() >= deadline) {
            return Err(Failure::OutOfTime { at: begin.time });
        }
        let mut outcome = self.run(run, Span::new(begin.time, time, begin.state).within_step());
        if !outcome.reached() {
            outcome = self.run(run, Span::new(begin.time, time, begin.state));
        }
        let allowed = run.budget.evaluations;
        match outcome.failure() {
            None => Ok(outcome.state),
            Some(Failure::TooManyEvaluations { at, .. }) => Err(Failure::TooManyEvaluations { at, allowed }),
            Some(failure) => Err(failure),
        }
    }

    /// Runs with the rest of the budget: outputs may cost as much as the run.
    fn run(&mut self, run: &Span<'_, S>, mut span: Span<'_, S>) -> Outcome<S> {
        span.budget = run.budget;
        span.budget.evaluations = run.budget.evaluations.saturating_sub(self.evaluations).max(1);
        let outcome = (self.again)(&span);
        self.steps += outcome.work.steps;
        self.evaluations += outcome.work.rates;
        outcome
    }

    /// The interpolating polynomial of the step; `None` where there are too few outputs, or it does not reproduce one
    /// more state.
    ///
    /// # Errors
    /// Those of [`Self::state`].
    pub fn polynomial(
        &mut self,
        run: &Span<'_, S>,
        [begin, end]: [StepEnd<'_, S>; 2],
        outputs: usize,
    ) -> Result<Option<Polynomial<S>>, Failure> {
        if outputs <= DEGREE {
            return Ok(None);
        }
        let at = |share: f64| begin.time + (end.time - begin.time) * share;
        let nodes: Vec<f64> = (0..=DEGREE).map(|k| at(chebyshev(k))).collect();
        let mut states = vec![begin.state.to_vec()];
        for node in &nodes[1..DEGREE] {
            states.push(self.state(run, begin, *node)?);
        }
        states.push(end.state.to_vec());
        let polynomial = Polynomial { nodes, states };
        let probe = at(0.5 * (chebyshev(DEGREE / 2) + chebyshev(DEGREE / 2 + 1)));
        let (exact, met) = (self.state(run, begin, probe)?, polynomial.at(probe));
        let off = |i: usize| (exact[i] - met[i]).approx();
        let error = match self.tolerance {
            Some(tolerance) => tolerance.norm(begin.state, end.state, off),
            None => Tolerance::both(MET).norm(begin.state, end.state, off),
        };
        Ok((error <= 1.0).then_some(polynomial))
    }
}

/// An interpolating polynomial through states at the Chebyshev points of an interval.
pub(crate) struct Polynomial<S> {
    nodes: Vec<f64>,
    states: Vec<Vec<S>>,
}

impl<S: Real> Polynomial<S> {
    /// The value at a time, by the barycentric formula.
    pub fn at(&self, time: f64) -> Vec<S> {
        let Polynomial { nodes, states } = self;
        if let Some(node) = nodes.iter().position(|node| *node == time) {
            return states[node].clone();
        }
        let weight = |k: usize| {
            let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            let half = if k == 0 || k + 1 == nodes.len() { 0.5 } else { 1.0 };
            sign * half / (time - nodes[k])
        };
        let weights: Vec<f64> = (0..nodes.len()).map(weight).collect();
        let all: f64 = weights.iter().sum();
        let first = &states[0];
        let sum = |i: usize| {
            let terms = weights.iter().zip(states).map(|(weight, state)| S::lift(weight / all) * (state[i] - first[i]));
            terms.fold(first[i], |sum, term| sum + term)
        };
        (0..first.len()).map(sum).collect()
    }
}

/// The k-th Chebyshev point of the second kind on (0, 1), in ascending order.
fn chebyshev(k: usize) -> f64 {
    0.5 - 0.5 * (std::f64::consts::PI * k as f64 / DEGREE as f64).cos()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_of_the_degree_is_read_to_rounding() {
        let value = |t: f64| (0..=DEGREE).fold(0.0, |sum, k| sum * (t - 0.3) + 1.0 / (k + 1) as f64);
        let nodes: Vec<f64> = (0..=DEGREE).map(|k| 2.0 - 3.0 * chebyshev(k)).collect();
        let states: Vec<Vec<f64>> = nodes.iter().map(|node| vec![value(*node)]).collect();
        let size = states.iter().map(|state| state[0].abs()).fold(0.0, f64::max);
        let polynomial = Polynomial { nodes, states };
        for k in 0..=50 {
            let time = 2.0 - 3.0 * k as f64 / 50.0;
            let off = polynomial.at(time)[0] - value(time);
            assert!(off.abs() < 1e-14 * size, "{time}: {off:e}");
        }
    }
}
