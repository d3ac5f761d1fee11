//! Accelerations by a linear solve with pivoting at each evaluation. Used if the symbolic elimination would be too long, or if
//! constraints determine coordinates without inertia.
//!
//! One list of expressions of the matrix A and the right side b serves all methods: rates in machine code or over any field, Taylor
//! series with one factorisation per step, and the Jacobian by directional derivatives
//!
//!   A z' = b' - A' z .

mod equations;
mod inertia;
mod law;
mod series;
mod slopes;

pub(crate) use self::series::{recurrence, recurrence_of, recurrence_with};
pub(crate) use equations::{linear_equations, unknown_letters};
pub(crate) use inertia::Inertia;
pub(crate) use law::ImplicitLaw;

use crate::compiled_system::NotCompiled;
use crate::letters::Letters;
use crate::program::recorded;
use algebra::linear::{Factors, Magnitude, NotSolved, Pattern};
use field::DoubleDouble;
use integrators::{Dual8, Ode, System};
use model::{Model, Trace};
use simulation::{Program, Running};
use std::sync::{Arc, Mutex, PoisonError};
use symbolic::linear::Solve;

/// The linear equations for accelerations and multipliers of a model, with numbers for its parameters.
#[derive(Debug)]
pub(crate) struct Implicit {
    model: Arc<Model>,
    /// The program for the entries of the matrix A, then the right side b.
    terms: Program,
    pattern: Pattern,
    plain: Pool<f64>,
    directed: Pool<Dual8>,
    exact: Pool<DoubleDouble>,
}

/// Work space for concurrent evaluations.
#[derive(Debug)]
struct Pool<S>(Mutex<Vec<Room<S>>>);

impl<S> Default for Pool<S> {
    fn default() -> Self {
        Pool(Mutex::new(Vec::new()))
    }
}

/// Work space for one evaluation.
#[derive(Debug)]
struct Room<S> {
    terms: Vec<S>,
    factors: Factors<S>,
}

impl<S: Magnitude> Room<S> {
    fn new(pattern: &Pattern) -> Self {
        Room { terms: vec![S::zero(); pattern.places().len() + pattern.size()], factors: Factors::new(pattern) }
    }
}

impl Implicit {
    /// The equations of a model without conditions, with values for all parameters.
    ///
    /// # Errors
    /// An expression has no value, or the equations are too long.
    pub fn of(model: &Arc<Model>) -> Result<Self, NotCompiled> {
        let mut pattern = None;
        let terms = recorded(model.positions() + model.speeds(), |time, state| {
            let Solve { pattern: own, entries, right, .. } =
                linear_equations(&Trace::of(model), Letters::with_data(time, state));
            pattern = Some(own);
            [entries, right].concat()
        })?;
        let pattern = pattern.ok_or(NotCompiled::TooLong)?;
        let (plain, directed, exact) = (Pool::default(), Pool::default(), Pool::default());
        Ok(Implicit { model: Arc::clone(model), terms, pattern, plain, directed, exact })
    }

    /// True if the expressions are compiled to machine code.
    pub fn is_code(&self) -> bool {
        self.terms.is_code()
    }

    /// The length of the result of [`Self::extend`].
    pub fn extended(&self) -> usize {
        self.model.positions() + self.model.speeds() + self.pattern.size()
    }

    /// The state, then accelerations and multipliers; these are NaN where they are not determined.
    pub fn extend(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut extended = state.to_vec();
        extended.resize(self.extended(), f64::NAN);
        let speeds = self.model.speeds();
        let shown = self.solve(&self.plain, time, state, |found| {
            let (accelerations, multipliers) = extended[state.len()..].split_at_mut(speeds);
            accelerations.copy_from_slice(&found[..speeds]);
            multipliers.iter_mut().zip(&found[speeds..]).for_each(|(lambda, less)| *lambda = -less);
        });
        shown.unwrap_or(());
        extended
    }

    /// Solves for the accelerations, then the negative multipliers, and passes them to `show`.
    ///
    /// # Errors
    /// An expression has no value, or the matrix is singular; `show` is then not called.
    fn solve<S: Magnitude + Running>(
        &self,
        pool: &Pool<S>,
        t: S,
        y: &[S],
        show: impl FnOnce(&[S]),
    ) -> Result<(), NotSolved> {
        let taken = pool.0.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut room = taken.unwrap_or_else(|| Room::new(&self.pattern));
        let made = self.terms.run(t, y, &mut room.terms);
        let (entries, right) = room.terms.split_at_mut(self.pattern.places().len());
        let factored = made.ok_or(NotSolved::NotANumber).and_then(|()| room.factors.factor(entries));
        if factored.is_ok() {
            room.factors.solve(right);
            show(right);
        }
        pool.0.lock().unwrap_or_else(PoisonError::into_inner).push(room);
        factored
    }
}

macro_rules! runs {
    ($($field:ty: $pool:ident),*) => {$(
        impl Ode<$field> for Implicit {
            fn dimension(&self) -> usize {
                self.model.positions() + self.model.speeds()
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                let (rates, accelerations) = dy.split_at_mut(self.model.positions());
                self.model.position_rates(y, rates);
                accelerations.fill(<$field>::from(f64::NAN));
                let count = accelerations.len();
                let shown = self.solve(&self.$pool, t, y, |found| accelerations.copy_from_slice(&found[..count]));
                shown.unwrap_or(());
            }
        }
    )*};
}
runs!(f64: plain, Dual8: directed, DoubleDouble: exact);

impl System for Implicit {}
