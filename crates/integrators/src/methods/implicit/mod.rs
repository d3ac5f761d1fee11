//! Methods that solve equations in a step: for stiff laws, and for the most digits.

pub(super) mod bader_deuflhard;
pub(crate) mod collocation;
pub(super) mod collocation_step;
mod linearisation;
pub(super) mod rosenbrock;
pub(super) mod theta;

pub use collocation::{Collocation, Family, nodal};
