//! Newton's iteration as implicit methods need it: elimination in kept buffers, when an iteration has converged, how stiff a
//! law is.

mod convergence;
mod lu;
mod spectral;

pub(crate) use convergence::Newton;
pub(crate) use lu::Lu;
pub(crate) use spectral::SpectralRadius;
