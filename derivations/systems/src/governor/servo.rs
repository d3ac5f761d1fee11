//! The programme as a servo constraint: the force along the axle of the wheel makes the speed of the second shaft
//! constant.
//!
//! The gradient of the condition omega2 - omega = 0 points along the rotation of the second shaft, on which no control
//! acts. A multiplier there would describe another machine, one with a motor on that shaft. The control force affects
//! omega2' only through rho' and the lever arms; it is determined from omega2'' = 0.

use super::{Governor, turning};
use field::{Base, Over};
use mechanics::constrained::servo::Servo;
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};
use mechanics::differentiate::unit;

/// A governor with a prescribed speed of its second shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kept<P> {
    pub governor: Governor<P>,
    /// The speed omega, rad/s.
    pub speed: P,
}

impl<P: Base> PointSystem<7> for Kept<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 7] {
        self.governor.masses()
    }

    fn force<S: Over<P>>(&self, at: &State<S, 7>) -> [S; 7] {
        self.governor.force(at)
    }
}

impl<P: Base> Constrained<7, 5> for Kept<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 7>) -> [Constraint<S>; 5] {
        self.governor.constraints(at)
    }
}

impl<P: Base> Servo<7, 5, 1> for Kept<P> {
    fn kept<S: Over<P>>(&self, at: &State<S, 7>) -> [S; 1] {
        [turning(at, 1) - S::lift(self.speed)]
    }

    fn directions<S: Over<P>>(&self, _at: &State<S, 7>) -> [[S; 7]; 1] {
        [unit(6)]
    }
}
