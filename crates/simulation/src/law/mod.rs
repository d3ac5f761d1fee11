//! Compilation of a symbolic law to programs: rates, Jacobian, Taylor series, divisors.

mod compiled_dae;
mod compiled_law;
mod directions;
mod divisors;
mod exponents;
mod jacobian;
mod program;
mod projected_law;
mod series;
mod time_scales;
mod trace;

pub use compiled_dae::{CompiledDae, SymbolicDae};
pub use compiled_law::{CompiledLaw, Differentiable, Law, Splittable, SymbolicLaw};
pub use directions::DirectionalProgram;
pub use exponents::{Expandable, Exponents, Room};
pub use jacobian::JacobianProgram;
pub use program::{Program, Running};
pub use projected_law::ProjectedLaw;
pub use series::LawSeries;
pub use time_scales::TimeScales;
pub use trace::{TracedOde, traced};
