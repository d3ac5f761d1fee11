//! Derivations of the equations of motion by several principles.
//!
//! Each principle gives the residual of one equation for each speed: linear in the accelerations, zero along every motion, of the
//! form
//!
//!   M u' + h - Q  (inertia minus forces; constraints add - J^T lambda)
//!
//! The principles share only the kinematics of the trace, hence their agreement is a nontrivial statement, which is decided for
//! every model.

pub(crate) mod appell;
mod gauss;
mod hamel;
pub(crate) mod hamilton;
pub(crate) mod lagrange;
pub(crate) mod loads;
mod newton_euler;
mod projections;
mod virtual_power;

pub(crate) use projections::linear;
pub use projections::{Operator, Projection, operator};

use crate::Trace;
use std::fmt;
use symbolic::Sym;

/// A principle of mechanics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Principle {
    /// d/dt dT/du - dT/dq = Q: forces by virtual displacements, weights by their potential.
    Lagrange,
    /// The Newton-Euler equations of every body, projected onto the partial velocities (Jourdain; Kane).
    VirtualPower,
    /// dS/du' = Q with the energy of accelerations S (Gibbs, Appell).
    Appell,
    /// Gauss' principle of least constraint, dZ/du' = 0: forces by the accelerations of their points.
    Gauss,
    /// The Newton-Euler equations of every body with its joint loads, solved recursively; then the power of the joint loads on the
    /// motions that the joints admit.
    NewtonEuler,
    /// The Boltzmann-Hamel equations; the quasi-velocities are components of the velocity and angular velocity of every body.
    Hamel,
    /// Hamilton's canonical equations, expressed by the speeds.
    Hamilton,
}

/// The reason why a principle does not apply to a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotApplicable(pub String);

impl fmt::Display for NotApplicable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

impl std::error::Error for NotApplicable {}

impl Principle {
    pub const ALL: [Principle; 7] = [
        Principle::Lagrange,
        Principle::VirtualPower,
        Principle::Appell,
        Principle::Gauss,
        Principle::NewtonEuler,
        Principle::Hamel,
        Principle::Hamilton,
    ];

    /// Returns the name in commands.
    pub fn name(self) -> &'static str {
        match self {
            Principle::Lagrange => "lagrange",
            Principle::VirtualPower => "virtual-power",
            Principle::Appell => "appell",
            Principle::Gauss => "gauss",
            Principle::NewtonEuler => "newton-euler",
            Principle::Hamel => "hamel",
            Principle::Hamilton => "hamilton",
        }
    }

    /// Returns inertia minus forces for each speed, without the reactions of constraints.
    ///
    /// # Errors
    /// The model gives a kinetic energy, and the principle requires bodies; or the momenta do not determine the speeds (Hamilton).
    pub fn residual(self, trace: &Trace<'_>) -> Result<Vec<Sym>, NotApplicable> {
        let has_energy = trace.model.energies.kinetic.is_some();
        if has_energy && !matches!(self, Principle::Lagrange | Principle::Hamilton) {
            return Err(NotApplicable(
                "a kinetic energy is given: the motion of its bodies is not known to this principle".to_owned(),
            ));
        }
        let residual = match self {
            Principle::Lagrange => lagrange::residual(trace),
            Principle::VirtualPower => virtual_power::residual(trace),
            Principle::Appell => appell::residual(trace),
            Principle::Gauss => gauss::residual(trace),
            Principle::NewtonEuler => newton_euler::residual(trace),
            Principle::Hamel => hamel::residual(trace),
            Principle::Hamilton => hamilton::residual(trace)?,
        };
        Ok(trace.with_masses(&residual))
    }
}
