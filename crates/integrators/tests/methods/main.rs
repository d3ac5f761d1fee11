//! The methods applied to nonlinear problems with known solutions; one program, so that the tests share the problems.

mod allocations;
mod branches;
mod events;
mod failures;
mod held;
mod jacobians;
mod observing;
mod orders;
mod problems;
mod references;
mod regret;
mod splittings;
mod taylor;
mod zeros;
