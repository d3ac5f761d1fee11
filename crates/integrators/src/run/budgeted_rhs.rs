//! The right-hand side for the methods: with counters and a budget, and with a time that always increases.

use std::cell::Cell;
use std::time::Instant;

use crate::run::clock::{self, Over};
use crate::{Failure, Ode, Real, Span, StepBounds, Work};

/// The number of evaluations between two readings of the clock; a reading costs as much as the rates of a small system.
const CLOCK_EVERY: u64 = 64;

/// The exhausted resource of a budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Spent {
    Evaluations,
    Clock(Over),
}

/// The law as a function of the run's own time tau = |t - start|. Once the budget is exhausted, every rate is NaN:
/// methods then stop without knowing of budgets.
pub(crate) struct BudgetedRhs<'a, S> {
    law: &'a dyn Ode<S>,
    pub start: S,
    pub direction: S,
    backwards: bool,
    /// See [`Span`].
    pub within_step: bool,
    pub longest_first: Option<f64>,
    bounds: Option<StepBounds>,
    allowed: u64,
    deadline: Option<Instant>,
    rates: Cell<u64>,
    jacobians: Cell<u64>,
    factorisations: Cell<u64>,
    constraints: Cell<u64>,
    spent: Cell<Option<Spent>>,
    undefined: Cell<bool>,
}

impl<'a, S: Real> BudgetedRhs<'a, S> {
    pub fn new(law: &'a dyn Ode<S>, span: &Span<'_, S>) -> Self {
        BudgetedRhs {
            law,
            start: S::lift(span.start),
            direction: S::lift(span.direction()),
            backwards: span.direction() < 0.0,
            within_step: span.within_step,
            longest_first: span.longest_first,
            bounds: None,
            allowed: span.budget.evaluations,
            deadline: span.budget.deadline,
            rates: Cell::new(0),
            jacobians: Cell::new(0),
            factorisations: Cell::new(0),
            constraints: Cell::new(0),
            spent: Cell::new(None),
            undefined: Cell::new(false),
        }
    }

    /// The right-hand side with upper bounds of the step size.
    pub fn bounded(self, bounds: StepBounds) -> Self {
        BudgetedRhs { bounds: Some(bounds).filter(|bounds| !bounds.is_empty()), ..self }
    }

    /// The largest step size allowed at tau, at most `most`.
    #[inline]
    pub fn longest(&self, tau: S, most: f64) -> f64 {
        self.bounds.as_ref().map_or(most, |bounds| bounds.longest(tau.approx(), most))
    }

    pub fn dimension(&self) -> usize {
        self.law.dimension()
    }

    /// Writes dy/dtau at tau.
    #[inline]
    pub fn rates(&self, tau: S, y: &[S], dy: &mut [S]) {
        let count = self.rates.get() + 1;
        if self.over(count) {
            dy.fill(S::lift(f64::NAN));
            return;
        }
        self.rates.set(count);
        self.law.rates(self.time(tau), y, dy);
        if self.backwards {
            dy.iter_mut().for_each(|rate| *rate = -*rate);
        }
        if !dy.iter().all(|rate| rate.finite()) {
            self.undefined.set(true);
        }
    }

    /// The time t at tau, s.
    #[inline]
    pub fn time(&self, tau: S) -> S {
        self.start + self.direction * tau
    }

    fn over(&self, count: u64) -> bool {
        if self.spent.get().is_none() {
            if count > self.allowed {
                self.spent.set(Some(Spent::Evaluations));
            } else if count / CLOCK_EVERY != self.rates.get() / CLOCK_EVERY
                && let Some(over) = self.clock()
            {
                self.spent.set(Some(Spent::Clock(over)));
            }
        }
        self.spent.get().is_some()
    }

    /// The reason of a stop by the clock of the run or of the process; `None` while neither has stopped.
    fn clock(&self) -> Option<Over> {
        clock::over().or_else(|| self.deadline.filter(|end| Instant::now() >= *end).map(|_| Over::Time))
    }

    /// Counts several evaluations at once, for a series of that cost. Returns false if the budget is exhausted.
    pub fn charge(&self, evaluations: u64) -> bool {
        let count = self.rates.get() + evaluations;
        let allowed = !self.over(count);
        if allowed {
            self.rates.set(count);
        }
        allowed
    }

    /// Counts one evaluation of the whole Jacobian.
    pub fn count_jacobian(&self) {
        self.jacobians.set(self.jacobians.get() + 1);
    }

    /// Counts one factorisation.
    pub fn count_factorisation(&self) {
        self.factorisations.set(self.factorisations.get() + 1);
    }

    /// Counts one evaluation of the constraints with their derivatives.
    pub fn count_constraints(&self) {
        self.constraints.set(self.constraints.get() + 1);
    }

    /// Whether a rate was not finite since the last call of [`Self::was_undefined`].
    pub fn is_undefined(&self) -> bool {
        self.undefined.get()
    }

    /// Whether a rate was not finite since the last call; resets the mark.
    pub fn was_undefined(&self) -> bool {
        self.undefined.replace(false)
    }

    /// The failure at the time `at` (s) due to an exhausted budget; `None` while the budget lasts.
    pub fn exhausted(&self, at: f64) -> Option<Failure> {
        self.spent.get().map(|spent| match spent {
            Spent::Evaluations => Failure::TooManyEvaluations { at, allowed: self.allowed },
            Spent::Clock(over) => over.failure(at),
        })
    }

    /// The work so far, without the number of steps.
    pub fn work(&self) -> Work {
        Work {
            rates: self.rates.get(),
            jacobians: self.jacobians.get(),
            factorisations: self.factorisations.get(),
            constraints: self.constraints.get(),
            ..Work::default()
        }
    }
}
