//! Equations of motion in quasi-velocities by every principle that uses them, and whether these agree.

use super::{QuasiVelocities, appell, hamel, maggi, shulgin, virtual_power};
use crate::agreement::{Agreement, decided};
use crate::principles::NotApplicable;
use symbolic::Sym;

/// A principle whose equations stand along quasi-velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuasiPrinciple {
    /// Lagrange's equations along du/dw.
    Maggi,
    /// Newton's and Euler's along partial velocities (Jourdain; Kane).
    VirtualPower,
    /// dS/dw' = Q (Gibbs, Appell).
    Appell,
    /// From the kinetic energy in quasi-velocities, with three-index symbols (Boltzmann, Hamel).
    Hamel,
    /// From the kinetic energy with inserted constraints, with the term that this loses; along independent speeds alone.
    Shulgin,
}

impl QuasiPrinciple {
    /// Those whose equations stand along any quasi-velocities.
    pub const ALONG_ANY: [QuasiPrinciple; 4] =
        [QuasiPrinciple::Maggi, QuasiPrinciple::VirtualPower, QuasiPrinciple::Appell, QuasiPrinciple::Hamel];

    /// The name in commands.
    pub fn name(self) -> &'static str {
        match self {
            QuasiPrinciple::Maggi => "maggi",
            QuasiPrinciple::VirtualPower => "virtual-power",
            QuasiPrinciple::Appell => "appell",
            QuasiPrinciple::Hamel => "hamel",
            QuasiPrinciple::Shulgin => "shulgin",
        }
    }

    /// Inertia less forces along each quasi-velocity, over q, w and w'; reactions of programmed constraints left out.
    ///
    /// # Errors
    /// Where a kinetic energy is given to a principle that asks for bodies.
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

/// Compares the equations of two principles in quasi-velocities: at points where the rates of all constraints that hold vanish.
///
/// # Errors
/// Where one of them does not apply to the model.
pub fn quasi_agreement(
    quasi: &QuasiVelocities<'_, '_>,
    one: QuasiPrinciple,
    other: QuasiPrinciple,
) -> Result<Agreement, NotApplicable> {
    let subject = format!("{} = {} in quasi-velocities", one.name(), other.name());
    let (one, other) = (one.residual(quasi)?, other.residual(quasi)?);
    Ok(decided(quasi.trace, &subject, &one.into_iter().zip(other).collect::<Vec<_>>()))
}
