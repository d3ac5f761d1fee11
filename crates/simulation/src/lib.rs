//! Runs of laws of motion: simulation, events, references, and comparison of methods.
//!
//! For programs that run scenes. A [`Problem`] is a law with a start, its integrals of motion and its margins. It can
//! be run by any method ([`Choice`]) and across [`events`], compared with [`references`], and run by every method at
//! every tolerance ([`work_precision`]). [`IvpScene`] is a scene with such a problem.
//!
//! A law y' = f(t, y) is implemented once, over symbolic expressions ([`TracedOde`]). The following programs are
//! compiled from it:
//!
//! * [`Program`]: the rates as straight-line code: machine code in `f64`, interpreted over dual and double-double
//!   numbers;
//! * [`LawSeries`]: the recurrence of the Taylor coefficients;
//! * [`JacobianProgram`]: the exact derivatives, with common subexpressions evaluated once;
//! * [`CompiledLaw`]: all these programs as an [`integrators::System`], each compiled when a method first uses it;
//! * [`CompiledDae`]: the programs of a law with constraints and multipliers.
//!
//! ```
//! use dalembert_simulation::CompiledLaw;
//! use integrators::{Method, Ode, Span, Tolerance, integrate};
//! use symbolic::Sym;
//!
//! /// x'' = -x
//! struct Oscillator;
//!
//! impl Ode<Sym> for Oscillator {
//!     fn dimension(&self) -> usize {
//!         2
//!     }
//!
//!     fn rates(&self, _t: Sym, y: &[Sym], dy: &mut [Sym]) {
//!         dy.copy_from_slice(&[y[1], -y[0]]);
//!     }
//! }
//!
//! let law = CompiledLaw::new(Oscillator);
//! let span = Span::new(0.0, 1.0, &[1.0, 0.0]);
//! let outcome = integrate(&law, Method::Taylor, &Tolerance::both(1e-12), &span, &mut ());
//! assert!((outcome.state[0] - 1.0_f64.cos()).abs() < 1e-11);
//! ```

mod axes;
pub mod ensemble;
pub mod events;
pub mod integral_drift;
pub mod ivp_scene;
pub mod knowledge;
mod law;
pub mod methods;
pub mod models;
pub mod problem;
pub mod references;
pub mod run;
pub mod run_failure;
pub mod simulate;
mod singular_rows;
mod transition;
pub mod work_precision;

pub use axes::Axes;
pub use events::Margin;
pub use ivp_scene::{IvpScene, RunNotes};
pub use law::{
    CompiledDae, CompiledLaw, Differentiable, DirectionalProgram, Expandable, Exponents, JacobianProgram, Law,
    LawSeries, Program, ProjectedLaw, Room, Running, Splittable, SymbolicDae, SymbolicLaw, TimeScales, TracedOde,
    traced,
};
pub use problem::{Invariant, Problem};
pub use references::Stored;
pub use run::Run;
pub use run_failure::{FailureKind, RunFailure};
pub use simulate::{Choice, Trajectory};
pub use work_precision::{Atlas, Trials, judged};
