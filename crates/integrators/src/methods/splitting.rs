//! Splitting methods: a step is a composition of the flows of the pieces of a law.

use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Composed, Pieces, Real, Splitting};

/// The composition of the flows of pieces in the order of a splitting.
pub fn compose<'a, S: Real, G: Pieces<S> + 'a>(pieces: G, splitting: Splitting) -> Box<dyn Composed<S> + 'a> {
    let schedule = splitting.schedule(pieces.pieces());
    Box::new(Composition { pieces, schedule, flows: Vec::new(), point: None })
}

struct Composition<S, G: Pieces<S>> {
    pieces: G,
    /// The sub-flows of a step in order: the piece, and its fraction of the step.
    schedule: Vec<(usize, S)>,
    flows: Vec<(usize, G::Substep)>,
    point: Option<G::Point>,
}

impl<S: Real, G: Pieces<S>> Composed<S> for Composition<S, G> {
    fn prepare(&mut self, step: S) {
        self.flows.clear();
        let flow = |(piece, share): &(usize, S)| (*piece, self.pieces.substep(*piece, *share * step));
        self.flows.extend(self.schedule.iter().map(flow));
    }

    fn enter(&mut self, y: &[S]) {
        self.point = Some(self.pieces.enter(y));
    }

    fn decay_rate(&self) -> f64 {
        self.point.as_ref().map_or(0.0, |point| self.pieces.decay_rate(point))
    }

    fn advance(&mut self) -> bool {
        let Some(point) = &mut self.point else { return false };
        self.flows.iter().all(|(piece, substep)| self.pieces.flow(*piece, substep, point))
    }

    fn leave(&self, y: &mut [S]) {
        if let Some(point) = &self.point {
            self.pieces.leave(point, y);
        }
    }
}

/// The largest allowed logarithm of the growth of a decaying component over a negative sub-step. Friction is then wrong
/// by the factor exp of it at most; from exp(4) on the component grows from step to step.
const MOST_GROWTH: f64 = 2.0;

impl Splitting {
    /// The largest step size (s) for a decay rate of the first piece (1/s); infinite where nothing decays, or no
    /// sub-step is negative.
    pub fn longest_step(self, rate: f64) -> f64 {
        longest(self.most_negative_substep(), rate)
    }
}

fn longest(back: f64, rate: f64) -> f64 {
    MOST_GROWTH / (rate * back)
}

/// A splitting method with a constant step. The state remains in the coordinates of the pieces between steps, which
/// avoids rounding errors by conversion.
pub(crate) struct Split<'a, S> {
    composed: Box<dyn Composed<S> + 'a>,
    stages: u64,
    /// The length of the most negative sub-step of the first piece, as a fraction of the step.
    back: f64,
    fixed: S,
    /// The step size for which the composition is prepared, and the state at the end of its last step.
    step: Option<S>,
    left: Vec<S>,
}

impl<'a, S: Real> Split<'a, S> {
    pub fn new(composed: Box<dyn Composed<S> + 'a>, splitting: Splitting, fixed: S) -> Self {
        let (stages, back) = (splitting.stages(), splitting.most_negative_substep());
        Split { composed, stages, back, fixed, step: None, left: Vec::new() }
    }

    /// The cause of rejection for a step whose negative sub-steps would amplify a decaying component too much.
    fn too_far_back(&self, step: f64) -> Option<Cause> {
        if self.back == 0.0 {
            return None;
        }
        let rate = self.composed.decay_rate();
        let most = longest(self.back, rate);
        (step > most).then_some(Cause::GoesBack { back: self.back, rate, most })
    }
}

impl<S: Real> Stepper<S> for Split<'_, S> {
    fn attempt(&mut self, _tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        let failed = |cause| Attempt::Rejected { next: 0.0, cause };
        // a stage costs about as much as an evaluation of the law
        if !meter.charge(self.stages) {
            return failed(Cause::Error);
        }
        if self.step != Some(step) {
            self.composed.prepare(step * meter.direction);
            self.step = Some(step);
        }
        if self.left != before {
            self.composed.enter(before);
        }
        if let Some(cause) = self.too_far_back(step.approx()) {
            return failed(cause);
        }
        if !self.composed.advance() {
            return failed(Cause::Newton);
        }
        self.composed.leave(after);
        self.left.clear();
        self.left.extend_from_slice(after);
        Attempt::Accepted { next: 0.0 }
    }

    fn fixed(&self) -> Option<S> {
        Some(self.fixed)
    }
}
