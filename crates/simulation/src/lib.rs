//! Laws of motion as they run.
//!
//! A law y' = f(t, y) is written down once, over expressions ([`TracedOde`]); all that runs are programs of these:
//!
//! * [`Program`]: the rates as straight-line code, machine code in `f64`, operation by operation over dual and double-double numbers;
//! * [`LawSeries`]: the recurrence of the Taylor coefficients;
//! * [`JacobianProgram`]: the derivatives, exact and with common parts once;
//! * [`CompiledLaw`]: all of them behind [`integrators::System`], each made when a method first asks for it;
//! * [`CompiledHeld`]: the same for a law that is held to constraints.
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

mod compiled_held;
mod compiled_law;
mod exponents;
mod jacobian;
mod program;
mod series;
mod trace;

pub use compiled_held::{CompiledHeld, SymbolicHeld};
pub use compiled_law::{CompiledLaw, Differentiable, Law, Splittable, SymbolicLaw};
pub use exponents::{Expandable, Exponents, Room};
pub use jacobian::JacobianProgram;
pub use program::{Program, Running};
pub use series::LawSeries;
pub use trace::{TracedOde, traced};
