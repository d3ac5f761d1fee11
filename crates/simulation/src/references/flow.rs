//! The flow of a law between two times in double-double.

use field::{DoubleDouble, Over};
use integrators::{Dual8, Failure, Method, Ode, Span, StepBounds, System, TIGHTEST, Tolerance, Work, integrate_in};
use std::time::Instant;

/// The law y' = L f(t + s L, y) for s from 0 to 1, which integrates f over the time interval L.
struct Paced<'a, L> {
    law: &'a L,
    bounds: StepBounds,
    start: DoubleDouble,
    length: DoubleDouble,
}

/// A double-double number in any scalar type, rounded if necessary.
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

/// A method with its tolerance, and its work so far.
pub struct Means {
    pub method: Method,
    /// The size of each component of the state.
    pub sizes: Vec<f64>,
    pub deadline: Instant,
    pub work: Work,
}

impl Means {
    /// The state at the time `to` (s) of the motion with the state `y` at the time `from`. `bounds` are the bounds of the
    /// step size over this interval.
    ///
    /// # Errors
    /// [`Failure`] where the method fails.
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

    /// The state at the time `end` of a motion that begins at zero. Further components may follow those of the motion;
    /// `others` has their sizes.
    ///
    /// # Errors
    /// [`Failure`] where the method fails.
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
