//! Newton's iteration as implicit methods need it: elimination in kept buffers, when an iteration has converged, how stiff a
//! law is.

mod complex_lu;
mod convergence;
mod lu;
mod spectral;

pub(crate) use complex_lu::ComplexLu;
pub(crate) use convergence::Newton;
pub(crate) use lu::Lu;
pub(crate) use spectral::SpectralRadius;
