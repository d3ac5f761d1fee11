//! Stability of steady motions, compared with eigenvalues of the compiled equations, closed forms, and runs.

mod closed;
mod drawn;
mod families;
mod identities;
mod numerical_stability;
#[path = "../physical/mod.rs"]
mod physical;
mod plane;
mod region;
mod running;
mod runs;
mod stabilisation;
mod stationary;
mod tops;
