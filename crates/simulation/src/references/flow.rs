//! The flow of a law between two times that are known to more digits than an `f64` has.

use field::{DoubleDouble, Over};
use integrators::{Dual8, Failure, Method, Ode, Span, StepBounds, System, TIGHTEST, Tolerance, Work, integrate_in};
use std::time::Instant;

/// y' = L f(t + s L, y) for s from 0 to 1: a law over an interval of time.
struct Paced<'a, L> {
    law: &'a L,
    bounds: StepBounds,
    start: DoubleDouble,
    length: DoubleDouble,
}

/// A number of two parts in any field: rounded where that is no finer.
fn lifted<S: Over<f64>>(number: DoubleDouble) -> S {
    S::lift(number.hi()) + S::lift(number.lo())
}

impl<S: Over<f64>, L: Ode<S>> Ode<S> for Paced<'_, L> {
    fn dimension(&self) -> usize {
        self.law.dimension()
    }

    fn rates(&self, s: S, y: &[S], dy: &mut [S]) {
        let length: S = lifted(self.length);
        self.law.rates(lifted::<S>(self.start) + s * length, y, dy);
        dy.iter_mut().for_each(|rate| *rate *= length);
    }
}

impl<L: Ode<f64> + Ode<Dual8> + Ode<DoubleDouble>> System for Paced<'_, L> {
    fn step_bounds(&self, _from: f64, _to: f64) -> StepBounds {
        self.bounds.clone()
    }
}

/// A method with its tolerance, and its cost so far.
pub struct Means {
    pub method: Method,
    /// The sizes of a state's components.
    pub sizes: Vec<f64>,
    pub deadline: Instant,
    pub work: Work,
}

impl Means {
    /// The state at `to` of the motion that is in `y` at `from`; the bounds of its steps belong to this way.
    ///
    /// # Errors
    /// Why the method stopped.
    pub fn flow<L>(
        &mut self,
        (law, bounds): (&L, &StepBounds),
        [from, to]: [DoubleDouble; 2],
        y: &[DoubleDouble],
    ) -> Result<Vec<DoubleDouble>, Failure>
    where
        L: Ode<f64> + Ode<Dual8> + Ode<DoubleDouble>,
    {
        if from == to {
            return Ok(y.to_vec());
        }
        let length = to - from;
        let found =
            self.run(&Paced { law, bounds: bounds.paced(1.0 / length.hi().abs()), start: from, length }, 1.0, y, &[]);
        found.map_err(|failure| failure.in_time(from.hi(), length.hi()))
    }

    /// The state at a time of a law that begins at zero. Components beyond the motion's own stand last, and bring their own
    /// sizes.
    ///
    /// # Errors
    /// Why the method stopped.
    pub fn run(
        &mut self,
        system: &dyn System,
        end: f64,
        y: &[DoubleDouble],
        others: &[f64],
    ) -> Result<Vec<DoubleDouble>, Failure> {
        let span = Span::new(0.0, end, y).with_deadline(self.deadline);
        let own = &self.sizes[..y.len() - others.len()];
        let tolerance = Tolerance::scaled(TIGHTEST, &[own, others].concat());
        let outcome = integrate_in(system, self.method, &tolerance, &span, &mut ());
        self.work = self.work + outcome.work;
        outcome.failure().map_or(Ok(outcome.state), Err)
    }
}
