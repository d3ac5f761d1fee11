//! Equations of motion by every principle, at a size known when the program runs.
//!
//! Each principle gives the residual of one equation for each speed: linear in the accelerations, zero along every motion, of the
//! form
//!
//!   M u' + h - Q  (inertia less the forces; constraints add - J^T lambda)
//!
//! The principles share the kinematics of the trace and nothing else: their agreement is a statement that is decided for
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
    /// Newton's and Euler's equations of every body, projected onto the partial velocities (Jourdain; Kane).
    VirtualPower,
    /// dS/du' = Q with the energy of accelerations S (Gibbs, Appell).
    Appell,
    /// The least constraint: dZ/du' = 0, forces by the accelerations of the points that they act on.
    Gauss,
    /// Newton's and Euler's equations of every body with the loads of joints, recursively; then the power of these loads on the
    /// motions that the joints leave.
    NewtonEuler,
    /// Boltzmann's and Hamel's equations in the quasi-velocities of every body: its velocity and angular velocity by components.
    Hamel,
    /// Hamilton's canonical equations, back along the speeds.
    Hamilton,
}

/// Why a principle does not apply to a model.
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

    /// The name in commands.
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

    /// Inertia less forces, for each speed; reactions of constraints left out.
    ///
    /// # Errors
    /// Where the model gives an energy whose bodies are not known to a principle that asks for bodies.
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
