//! Methods that solve equations in a step: for stiff laws, and for the most digits.

pub(super) mod bader_deuflhard;
pub(super) mod collocated;
pub(crate) mod collocation;
mod linearised;
pub(super) mod rosenbrock;
pub(super) mod theta;

pub use collocation::{Collocation, Family, nodal};
