//! Forces, torques and energies.

use super::Material;
use crate::{FrameId, ScalarId, VectorId};

/// A force on one point, or between two.
#[derive(Clone, Debug, PartialEq)]
pub enum Force {
    On {
        at: Material,
        is: VectorId,
    },
    /// Opposite forces along the line between two points; a positive value is repulsive.
    Between {
        points: [Material; 2],
        is: ScalarId,
    },
}

/// A generalised force. Its power is `is` times a speed, or times the part of a quasi-velocity or expression that is linear in
/// the speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralisedForce {
    pub along: Along,
    /// The value in SI units: N along a length, N m along an angle.
    pub is: ScalarId,
}

/// The speed along which a generalised force acts, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    Speed(usize),
    QuasiVelocity(usize),
    /// An expression that is linear in the speeds.
    Expression(ScalarId),
}

/// A torque on one frame, or between two.
#[derive(Clone, Debug, PartialEq)]
pub enum Torque {
    On {
        frame: FrameId,
        is: VectorId,
    },
    /// A torque on the second frame, with the opposite torque on the first.
    Between {
        frames: [FrameId; 2],
        is: VectorId,
    },
}

/// Energies that are given directly, in addition to those of the bodies.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Energies {
    /// The kinetic energy in J.
    pub kinetic: Option<ScalarId>,
    /// The potential energy in J.
    pub potential: Option<ScalarId>,
    /// Rayleigh's dissipation function in W; generalised forces are its negative derivatives with respect to the speeds.
    pub dissipation: Option<ScalarId>,
    /// The co-energy W'(i, q) of magnetic fields; currents i are rates of charges.
    pub coenergy: Option<ScalarId>,
}
