//! Integrators of ordinary differential equations y' = f(t, y).
//!
//! # Overview
//! For programs that need accurate runs with measured errors. One implementation of a law ([`Ode`], [`System`]) serves
//! all methods: [`integrate`] runs it by any [`Method`], some from maintained crates and others of this crate, over
//! `f64` and double-double numbers ([`integrate_in`]). A run has a budget and reports its steps to an [`Observer`]. Its
//! [`Outcome`] is the state at the end of the span, or a failure with the last valid state. Errors are measured against
//! a [`reference()`]: the digits of the motion on which two methods of different families agree in double-double.
//! [`judge`] computes errors, [`measure`] times.
//!
//! | method | order | stiff | double-double | from |
//! |---|---|---|---|---|
//! | Euler, Runge-Kutta 4 (constant step) | 1, 4 | | yes | own |
//! | Backward Euler, implicit midpoint (constant step) | 1, 2 | yes | yes | own |
//! | Dormand-Prince 5(4), 8(5,3) | 5, 8 | detected | | own |
//! | Verner 6(5), 9(8) | 6, 9 | | | `differential-equations` |
//! | Gragg-Bulirsch-Stoer | varies | | yes | own |
//! | Taylor, for systems with a series | varies | | yes | own |
//! | Gauss, Radau IIA with s stages | 2s, 2s - 1 | yes | yes | own |
//! | Radau5, Kvaerno 5(4) | 5 | yes | | `differential-equations` |
//! | Rodas4 | 4 | yes | | own |
//! | Bader-Deuflhard | varies | yes | | own |
//! | Strang, Blanes-Moan, Kahan-Li splittings, for systems with pieces (constant step) | 2, 4, 6, 8 | | 2, 8 | own |
//!
//! Laws with constraints and multipliers ([`Index2Dae`], differential-algebraic equations of index 2) have methods of
//! their own: [`integrate_index2()`]. [`integrate_projected`] projects the steps of any method with a constant step
//! size onto the constraint.
//!
//! [`clock`] ends every integration of a process at a deadline, or on the user's request.
//!
//! [`check_by_step_halving`] checks a run with constant steps by runs with shorter steps. [`continue_branch`] continues
//! equilibria and periodic motions over a parameter.
//!
//! Tested properties: every method has its order on nonlinear laws (`tests/methods/orders.rs`); outputs do not affect
//! the steps and are as accurate as the state at the end; the inner loops of this crate's methods do not allocate.
//! Gauss collocation with Jacobians in `f64` and residuals in double-double gives 26 digits at any stiffness.
//!
//! # Example
//! ```
//! use dalembert_integrators::{Method, Ode, Span, System, Tolerance, integrate};
//! use field::Scalar;
//!
//! /// y'' = -y as two equations of the first order.
//! struct Oscillator;
//!
//! impl<S: Scalar> Ode<S> for Oscillator {
//!     fn dimension(&self) -> usize {
//!         2
//!     }
//!
//!     fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
//!         (dy[0], dy[1]) = (y[1], -y[0]);
//!     }
//! }
//!
//! impl System for Oscillator {}
//!
//! let span = Span::new(0.0, 10.0, &[1.0, 0.0]);
//! let outcome = integrate(&Oscillator, Method::DormandPrince8, &Tolerance::both(1e-10), &span, &mut ());
//! assert!(outcome.reached());
//! assert!((outcome.state[0] - 10_f64.cos()).abs() < 1e-8);
//! ```

mod batch;
mod branches;
mod events;
mod law;
mod methods;
mod newton;
mod references;
mod run;
mod work_precision;

pub use batch::{BatchRungeKutta4, BatchSeries, BatchStep, Ensemble, Members, batch_order, fuses};
pub use branches::{
    Branch, BranchEnd, ContinuationSettings, Curve, CurvePoint, Equilibria, PeriodicMotions, continue_branch,
    eigenvalues, spectrum,
};
pub use events::{Event, Happening, Pace, Signal, Switches, integrate_to_event};
pub use law::{
    Composed, DIRECTIONS, Divisors, Dual8, FastInterval, Index2Dae, Index2DaeSystem, Jacobian, JacobianFn, Ode, Pieces,
    Projection, Real, Splitting, StepBounds, System, TaylorSeries, Variations, Working, slope, variable,
};
pub use methods::{
    Attempt, Collocation, Family, HybridMotion, Index2Method, MOST_STAGES, Means, Method, Taylor, Traits, Transition,
    compose, euler_step, integrate, integrate_in, integrate_index2, integrate_projected, nodal, runge_kutta_4_step,
    taylor_order, transition,
};
pub use references::{
    ENOUGH_DIGITS, Reference, ShorterRun, StepHalvingCheck, StepHalvingVerdict, TIGHTEST, check_by_step_halving,
    difference, reference, shared_digits, survey,
};
pub use run::{
    Absolute, Budget, Deviation, End, Failure, LOST, Lost, Monitor, Observer, Outcome, Progress, Quantity, Record,
    Refusal, Samples, Sizes, Span, Tolerance, Work, clock,
};
pub use work_precision::{
    Benchmark, Median, Point, Regrets, Timed, Trial, cost, excess, front, interleaved, judge, measure,
};
