//! Equations of motion in quasi-velocities by several principles, and the decision whether these agree.

use super::{QuasiVelocities, appell, hamel, maggi, shulgin, virtual_power};
use crate::agreement::{Agreement, decided};
use crate::principles::NotApplicable;
use symbolic::Sym;

/// A principle that gives one equation per quasi-velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuasiPrinciple {
    /// Lagrange's equations, projected onto du/dw.
    Maggi,
    /// The Newton-Euler equations, projected onto partial velocities (Jourdain; Kane).
    VirtualPower,
    /// dS/dw' = Q, with the energy of accelerations S (Gibbs, Appell).
    Appell,
    /// The kinetic energy in quasi-velocities, with three-index symbols (Boltzmann, Hamel).
    Hamel,
    /// The kinetic energy with substituted constraints, plus the term that the substitution loses; for independent speeds only.
    Shulgin,
}

impl QuasiPrinciple {
    /// The principles that apply to arbitrary quasi-velocities.
    pub const ALONG_ANY: [QuasiPrinciple; 4] =
        [QuasiPrinciple::Maggi, QuasiPrinciple::VirtualPower, QuasiPrinciple::Appell, QuasiPrinciple::Hamel];

    /// Returns the name in commands.
    pub fn name(self) -> &'static str {
        match self {
            QuasiPrinciple::Maggi => "maggi",
            QuasiPrinciple::VirtualPower => "virtual-power",
            QuasiPrinciple::Appell => "appell",
            QuasiPrinciple::Hamel => "hamel",
            QuasiPrinciple::Shulgin => "shulgin",
        }
    }

    /// Returns inertia minus forces along each quasi-velocity, as functions of q, w and w', without reactions of stabilised constraints.
    ///
    /// # Errors
    /// A kinetic energy or co-energy is given, and the principle requires bodies; or the quasi-velocities are not independent rates (Shulgin).
    pub fn residual(self, quasi: &QuasiVelocities<'_, '_>) -> Result<Vec<Sym>, NotApplicable> {
        let trace = quasi.trace;
        let asks_for_bodies = matches!(self, QuasiPrinciple::VirtualPower | QuasiPrinciple::Appell);
        if asks_for_bodies && trace.model.energies.kinetic.is_some() {
            return Err(NotApplicable(
                "a kinetic energy is given: the motion of its bodies is not known to this principle".to_owned(),
            ));
        }
        if asks_for_bodies && trace.model.energies.coenergy.is_some() {
            return Err(NotApplicable("a co-energy is given, which is no motion of bodies".to_owned()));
        }
        let residual = match self {
            QuasiPrinciple::Maggi => maggi::residual(quasi, trace)?,
            QuasiPrinciple::VirtualPower => virtual_power::residual(quasi, trace),
            QuasiPrinciple::Appell => appell::residual(quasi, trace),
            QuasiPrinciple::Hamel => hamel::residual(quasi, trace),
            QuasiPrinciple::Shulgin => shulgin::residual(quasi, trace)?,
        };
        Ok(quasi.by_quasi_velocities(&residual))
    }
}

/// Compares the equations of two principles in quasi-velocities, at states that satisfy the constraints of speeds.
///
/// # Errors
/// One of the principles does not apply to the model.
pub fn quasi_agreement(
    quasi: &QuasiVelocities<'_, '_>,
    one: QuasiPrinciple,
    other: QuasiPrinciple,
) -> Result<Agreement, NotApplicable> {
    let subject = format!("{} = {} in quasi-velocities", one.name(), other.name());
    let (one, other) = (one.residual(quasi)?, other.residual(quasi)?);
    Ok(decided(quasi.trace, &subject, &one.into_iter().zip(other).collect::<Vec<_>>()))
}
