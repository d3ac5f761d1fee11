//! Forces, torques and energies.

use super::Material;
use crate::{FrameId, ScalarId, VectorId};

/// A force.
#[derive(Clone, Debug, PartialEq)]
pub enum Force {
    On {
        at: Material,
        is: VectorId,
    },
    /// Equal and opposite along the line of two points, positive apart.
    Between {
        points: [Material; 2],
        is: ScalarId,
    },
}

/// A generalised force: its power is `is` times the speed, or times the part of a quasi-velocity, or of an expression, that is linear in
/// the speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralisedForce {
    pub along: Along,
    pub is: ScalarId,
}

/// The speed that a generalised force has power on, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    Speed(usize),
    QuasiVelocity(usize),
    /// An expression that is linear in the speeds.
    Expression(ScalarId),
}

/// A torque.
#[derive(Clone, Debug, PartialEq)]
pub enum Torque {
    On {
        frame: FrameId,
        is: VectorId,
    },
    /// On the second, its opposite on the first.
    Between {
        frames: [FrameId; 2],
        is: VectorId,
    },
}

/// Energies beside those of the bodies.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Energies {
    pub kinetic: Option<ScalarId>,
    pub potential: Option<ScalarId>,
    /// Rayleigh's function: forces are minus its derivatives by the speeds.
    pub dissipation: Option<ScalarId>,
    /// The co-energy W'(i, q) of magnetic fields, with currents as the rates of charges.
    pub coenergy: Option<ScalarId>,
}
