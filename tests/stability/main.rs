//! Stability of stationary motions: against eigenvalues of the equations that run, closed forms, and runs.

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
