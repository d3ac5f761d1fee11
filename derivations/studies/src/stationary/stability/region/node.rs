//! All stationary motions at two values of the data, each judged as in a scene that had these data.

use super::Region;
use super::law::Ground;
use super::spot::Spot;
use crate::stationary::energies::Kept;
use crate::stationary::motor::{MotorStates, NoMotor};
use crate::stationary::stability::verdict::{Reason, StabilityVerdict};
use algebra::real::Enclosure;
use mechanics::steady_rotations::{self, Kind, Shape};
use nalgebra::Vector3;

/// What becomes of small deviations, without the count of roots.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    AsymptoticallyStable,
    Stable,
    Unstable,
    /// If it is stable, then by gyroscopic forces.
    Gyroscopic,
    /// Any other reason for which nothing is said.
    Undecided,
}

/// What is at a node.
#[derive(Clone, Debug)]
pub struct Node {
    pub values: [f64; 2],
    pub place: NodeMotions,
}

/// Motions, or why there are none.
#[derive(Clone, Debug)]
pub enum NodeMotions {
    /// Isolated ones, and families of which each is judged as a whole.
    Motions { isolated: Vec<Here>, families: Vec<Family> },
    /// The motor holds no speed or angle.
    PulledOut,
    /// No bodies have these data.
    NoBodies,
    /// More bits than are tried would be needed to tell motions apart.
    TooFine,
}

/// A connected family, and the verdicts along it, one for each stretch.
pub type Family = (Shape, Vec<StabilityVerdict>);

/// An isolated motion.
#[derive(Clone, Debug)]
pub struct Here {
    /// Which of the rotor's states it is that the motor holds, in ascending order.
    pub state: usize,
    pub kind: Kind,
    pub direction: Vector3<f64>,
    pub verdict: StabilityVerdict,
    /// (v, lambda)
    pub(super) place: steady_rotations::EnclosedPoint,
    /// W, or the rotor's own momentum.
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
    /// The isolated motions; none where nothing moves steadily.
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
    /// [`NoMotor`] where the motor has no stationary state that is known.
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
    /// Whether the rotor keeps its relative speed or its own momentum.
    pub(super) fn kept(&self, ground: &Ground) -> Kept {
        match ground.motor {
            MotorStates::Free if self.data.iter().all(|datum| !datum.is_rotor_speed()) => Kept::Momentum,
            _ => Kept::RelativeSpeed,
        }
    }
}
