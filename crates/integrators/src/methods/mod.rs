//! The methods of integration, by kind, behind one entry.
//!
//! # Overview
//! * [`explicit`]: Euler and Runge-Kutta with a constant step, Dormand-Prince, Gragg-Bulirsch-Stoer;
//! * [`implicit`]: backward Euler and the midpoint rule, collocation, Rodas4, Bader-Deuflhard;
//! * [`taylor`]: Taylor's method, and state-transition matrices;
//! * [`splitting`]: compositions of the flows of the pieces of a law;
//! * [`dae`]: DAEs of index 2;
//! * [`adaptors`]: solvers of other crates.
//!
//! [`Method`] names the methods. [`integrate`](fn@integrate) runs them on an ordinary differential equation,
//! [`integrate_index2()`] on a DAE, [`Attempt`] on either.

mod adaptors;
mod constrained_run;
pub(crate) mod dae;
mod explicit;
mod extrapolation_control;
pub(crate) mod implicit;
pub(crate) mod integrate;
mod method;
mod splitting;
pub(crate) mod taylor;

pub use constrained_run::{Attempt, HybridMotion, Means};
pub use dae::{Index2Method, integrate_index2, integrate_projected};
pub use explicit::{euler_step, runge_kutta_4_step};
pub use implicit::{Collocation, Family, nodal};
pub use integrate::{integrate, integrate_in};
pub use method::{MOST_STAGES, Method, Traits};
pub use splitting::compose;
pub use taylor::{Taylor, Transition, taylor_order, transition};
