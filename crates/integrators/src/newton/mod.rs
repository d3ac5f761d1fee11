//! Linear algebra and convergence control of Newton's iteration in implicit methods, and the spectral radius as a
//! measure of stiffness.

mod complex_lu;
mod condensation;
mod convergence;
mod lu;
mod shifted_matrix;
mod spectral;

pub(crate) use complex_lu::ComplexLu;
pub(crate) use condensation::Condensation;
pub(crate) use convergence::Newton;
pub(crate) use lu::Lu;
pub(crate) use shifted_matrix::Shifted;
pub(crate) use spectral::SpectralRadius;
