//! The two classical gyrostats in a steady motion, with symbols as data.

use super::alphabet;
use nalgebra::Matrix3;
use papers::konosevich2022::Letters;
use studies::stationary::energies::Energies;
use studies::stationary::stability::reduced::Reduced;
use symbolic::{Hypotheses, Sym};

/// The gyrostat whose rotor has constant relative speed, in the axes of A*.
pub fn kept(s: &Letters) -> Reduced<Sym> {
    Reduced {
        tensor: Matrix3::from_diagonal(&s.a_star),
        spin: s.l * (s.axial * s.omega_field),
        speed: s.omega0,
        vertical: s.nu,
        multiplier: alphabet::letter("λ"),
    }
}

/// The gyrostat with a free rotor, in the same axes and with the same speed.
pub fn free(s: &Letters) -> Reduced<Sym> {
    Reduced {
        tensor: Matrix3::from_diagonal(&s.a_star) - s.l * s.l.transpose() * s.axial,
        spin: s.l * (s.axial * (s.omega_field + s.omega0 * s.l.dot(&s.nu))),
        ..kept(s)
    }
}

/// The gyrostat in the axes of A* with the weight for which nu is a steady motion with the multiplier lambda. Every
/// steady motion of every gyrostat has this form.
pub fn stationary(s: &Letters) -> Energies<Sym> {
    let kept = kept(s);
    let momentum = kept.tensor * s.nu * s.omega0 + kept.spin;
    Energies {
        tensor: kept.tensor,
        mixed: s.l * s.axial,
        axial: s.axial,
        weight: s.nu * kept.multiplier - momentum * s.omega0,
    }
}

/// The hypotheses |nu| = 1 and |l| = 1.
pub fn unit_vectors(s: &Letters) -> Hypotheses {
    s.unit_vertical.clone().unit_vector(s.l.into())
}
