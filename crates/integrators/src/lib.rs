//! Integrators of ordinary differential equations y' = f(t, y).
//!
//! # Overview
//! A law is written once ([`Ode`], [`System`]) and run by any [`Method`] through one entry, [`integrate`]: adaptors to
//! well-kept crates, and the methods that no crate has, over `f64` and double-double alike ([`integrate_in`]). A run has
//! a budget, is shown to an [`Observer`], and ends in an [`Outcome`] that either reached its end or names one of a closed
//! set of failures, with the last good state. What a method is measured by is a [`reference()`]: two methods of different
//! families in double-double, with the digits they share; [`judge`] finds errors, [`measure`] times.
//!
//! | method | order | stiff | double-double | from |
//! |---|---|---|---|---|
//! | Euler, Runge-Kutta 4 (constant step) | 1, 4 | | yes | own |
//! | Backward Euler, implicit midpoint (constant step) | 1, 2 | yes | yes | own |
//! | Dormand-Prince 5(4), 8(5,3) | 5, 8 | says so | | own |
//! | Verner 6(5), 9(8) | 6, 9 | | | `differential-equations` |
//! | Gragg-Bulirsch-Stoer | varies | | yes | own |
//! | Taylor, for systems with a series | varies | | yes | own |
//! | Gauss, Radau IIA with s stages | 2s, 2s - 1 | yes | yes | own |
//! | Radau5, Kvaerno 5(4) | 5 | yes | | `differential-equations` |
//! | Rodas4 | 4 | yes | | own |
//! | Bader-Deuflhard | varies | yes | | own |
//! | Strang, Blanes-Moan, Kahan-Li splittings, for systems with pieces (constant step) | 2, 4, 6, 8 | | 2, 8 | own |
//!
//! Laws that are held to constraints by multipliers ([`Held`], index 2) have an entry and methods of their own, [`hold()`];
//! [`integrate_projected`] brings any method with a constant step onto the constraint after each step.
//!
//! [`clock`] ends every integration of a process at one moment, or when the user asks.
//!
//! [`beside()`] judges a run with constant steps by shorter ones; [`follow`] goes along curves of equilibria and of motions that repeat, over a parameter.
//!
//! Key results: every method has its order on nonlinear laws (`tests/methods/orders.rs`), outputs change no step and are as accurate as the end,
//! the own inner loops do not allocate, and Gauss collocation with Jacobians in `f64` and residuals in double-double
//! gives 26 digits at any stiffness in milliseconds.

mod adaptors;
mod attempt;
mod bader_deuflhard;
#[cfg(test)]
mod bell;
mod beside;
mod branches;
mod classical;
pub mod clock;
mod collocation;
mod columns;
mod composition;
mod dormand_prince;
mod drive;
mod ensemble;
mod events;
mod failure;
mod front;
mod gragg;
mod held;
mod implicit;
mod integrate;
mod jacobian;
mod linearised;
mod lu;
mod meter;
mod method;
mod newton;
mod observer;
mod ode;
mod outcome;
mod real;
mod reference;
mod regret;
mod rosenbrock;
mod side_by_side;
mod span;
mod spectral;
mod splitting;
mod taylor;
mod theta;
mod tolerance;
mod transition;
mod turns;
mod watch;
mod within;
mod work_precision;

pub use attempt::{Across, Attempt, Means};
pub use beside::{Beside, Parting, Shorter, beside};
pub use branches::{Branch, Curve, Equilibria, Last, Place, Repeating, Walk, follow, spectrum};
pub use classical::{euler_step, runge_kutta_4_step};
pub use collocation::{Collocation, Family, nodal};
pub use composition::Splitting;
pub use ensemble::{Ensemble, LaneSeries, LaneStep, Members, lanes_order};
pub use events::{Event, Happening, Signal, Switches, integrate_to_event};
pub use failure::{Failure, Refusal};
pub use front::{excess, front};
pub use held::{Held, HeldSystem, Holding, hold, integrate_projected};
pub use integrate::{integrate, integrate_in};
pub use jacobian::{Jacobian, slope, variable};
pub use method::{MOST_STAGES, Method, Traits};
pub use observer::{Observer, Progress, Record, Samples, Sizes};
pub use ode::{DIRECTIONS, Directions, Ode, Slopes, System, Working};
pub use outcome::{Deviation, End, Outcome, Work};
pub use real::Real;
pub use reference::{ENOUGH_DIGITS, Reference, TIGHTEST, difference, reference, shared_digits, survey};
pub use regret::{Regrets, Trial, cost};
pub use side_by_side::{SideBySide, fuses};
pub use span::{Budget, Monitor, Quantity, Span};
pub use splitting::{Composed, Pieces, compose};
pub use taylor::{Taylor, TaylorSeries, taylor_order};
pub use tolerance::{Absolute, Tolerance};
pub use transition::{Transition, transition};
pub use turns::{Median, taking_turns};
pub use work_precision::{Course, Point, Timed, judge, measure};
