//! Implicit methods, for stiff laws and for results with many digits.

pub(super) mod bader_deuflhard;
pub(crate) mod collocation;
pub(super) mod collocation_step;
mod defect_spread;
mod linearisation;
pub(super) mod rosenbrock;
mod stage_matrix;
mod stage_modes;
pub(super) mod theta;

pub use collocation::{Collocation, Family, nodal};
