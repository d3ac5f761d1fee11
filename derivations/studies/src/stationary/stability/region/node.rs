//! All steady motions at two values of the data, each with its verdict.

use super::Region;
use super::law::Ground;
use super::spot::Spot;
use crate::stationary::energies::Kept;
use crate::stationary::motor::{MotorStates, NoMotor};
use crate::stationary::stability::verdict::{Reason, StabilityVerdict};
use algebra::real::Enclosure;
use mechanics::steady_rotations::{self, Kind, Shape};
use nalgebra::Vector3;

/// The class of a verdict: the verdict without the number of unstable eigenvalues.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    AsymptoticallyStable,
    Stable,
    Unstable,
    /// If stable, then by gyroscopic forces only.
    Gyroscopic,
    /// Undecided for another reason.
    Undecided,
}

/// A node of the map.
#[derive(Clone, Debug)]
pub struct Node {
    pub values: [f64; 2],
    pub place: NodeMotions,
}

/// The motions at a node, or the reason why there are none.
#[derive(Clone, Debug)]
pub enum NodeMotions {
    /// Isolated motions, and connected families of motions.
    Motions { isolated: Vec<Here>, families: Vec<Family> },
    /// The motor has no stable steady speed or angle.
    PulledOut,
    /// No bodies with these data exist.
    NoBodies,
    /// The motions cannot be separated with the precisions that are tried.
    TooFine,
}

/// A connected family of motions, and the verdicts that occur along it.
pub type Family = (Shape, Vec<StabilityVerdict>);

/// An isolated motion.
#[derive(Clone, Debug)]
pub struct Here {
    /// The index of the rotor's steady state, in ascending order of its value.
    pub state: usize,
    pub kind: Kind,
    pub direction: Vector3<f64>,
    pub verdict: StabilityVerdict,
    /// The point (v, lambda).
    pub(super) place: steady_rotations::EnclosedPoint,
    /// The rotor's relative speed W, rad/s, or its own momentum, N m s.
    pub(super) value: Enclosure,
}

impl Class {
    pub const ALL: [Class; 5] =
        [Class::AsymptoticallyStable, Class::Stable, Class::Unstable, Class::Gyroscopic, Class::Undecided];
}

impl From<StabilityVerdict> for Class {
    fn from(verdict: StabilityVerdict) -> Self {
        match verdict {
            StabilityVerdict::Stable => Class::Stable,
            StabilityVerdict::AsymptoticallyStableModuloIntegrals => Class::AsymptoticallyStable,
            StabilityVerdict::Unstable { .. } => Class::Unstable,
            StabilityVerdict::CannotTell(Reason::Gyroscopic { .. }) => Class::Gyroscopic,
            StabilityVerdict::CannotTell(_) => Class::Undecided,
        }
    }
}

impl Node {
    /// The isolated motions; empty if there are none.
    pub fn isolated(&self) -> &[Here] {
        match &self.place {
            NodeMotions::Motions { isolated, .. } => isolated,
            _ => &[],
        }
    }
}

impl Region<'_> {
    /// All nodes with one value of the first datum, from the lowest.
    ///
    /// # Errors
    /// [`NoMotor`] if the motor's steady states are not known.
    pub fn column(&self, column: usize) -> Result<Vec<Node>, NoMotor> {
        let first = self.values[0][column];
        let ground = self.ground(first)?;
        Ok(self.values[1].iter().map(|&second| self.node(&ground, [first, second])).collect())
    }

    fn node(&self, ground: &Ground, values: [f64; 2]) -> Node {
        let place = match Spot::of(self, ground, values) {
            None => NodeMotions::NoBodies,
            Some(spot) => spot.place().unwrap_or(NodeMotions::TooFine),
        };
        Node { values, place }
    }
}

impl Region<'_> {
    /// The rotor's constant quantity: its relative speed or its own momentum.
    pub(super) fn kept(&self, ground: &Ground) -> Kept {
        match ground.motor {
            MotorStates::Free if self.data.iter().all(|datum| !datum.is_rotor_speed()) => Kept::Momentum,
            _ => Kept::RelativeSpeed,
        }
    }
}
