//! Coordinates whose rates are combinations of speeds: each quasi-velocity becomes the rate of an additional coordinate on which nothing depends.
//!
//! The constraint s' = w(q, u) determines the new coordinate s, so that methods for coordinates also apply to quasi-velocities.

use crate::arena::Scalar;
use crate::arena::Vector as VectorPart;
use crate::{Along, Constraint, Coordinate, FrameId, Material, Model, QuasiVelocity, Trace, Zero};
use symbolic::{Dimension, Sym};

/// The prefix of the names of added coordinates. Names in files contain no spaces.
pub const INTEGRAL: &str = "integral of ";

impl Model {
    /// Returns the components of the velocities of all centres of mass along the axes of the bodies' frames and of the parents of these.
    pub fn body_velocities(&mut self) -> Vec<QuasiVelocity> {
        let mut all = Vec::new();
        for place in 0..self.bodies.len() {
            let (Some(frame), Some(centre)) = (self.bodies[place].frame, self.bodies[place].centre) else { continue };
            let of = Material { body: None, point: centre };
            let velocity = self.arena.vector(VectorPart::Velocity { of, seen: FrameId::GROUND });
            let above = |frame: &FrameId| self.frames[frame.0].parent.map(|(parent, _)| parent);
            let frames: Vec<FrameId> =
                std::iter::successors(Some(frame), above).filter(|frame| *frame != FrameId::GROUND).collect();
            for frame in frames {
                for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
                    let along = self.arena.vector(VectorPart::Axis { frame, axis });
                    let is = self.arena.scalar(Scalar::Dot(velocity, along), None);
                    let name =
                        format!("velocity({}).{}.{letter}", self.points[centre.0].name, self.frames[frame.0].name);
                    let dimension = Dimension::length() / Dimension::time();
                    if all.iter().all(|known: &QuasiVelocity| known.is != is) {
                        all.push(QuasiVelocity { name, is, dimension, at: self.bodies[place].at.clone() });
                    }
                }
            }
        }
        all
    }

    /// Returns the model with an additional coordinate for each given combination of speeds, its rate, and without quasi-velocities.
    #[must_use]
    pub fn with_integrals(&self, speeds: &[QuasiVelocity]) -> Self {
        let mut whole = self.clone();
        // a force along a quasi-velocity becomes a force along its expression
        for force in &mut whole.generalised {
            if let Along::QuasiVelocity(place) = force.along {
                force.along = Along::Expression(self.quasi_velocities[place].is);
            }
        }
        whole.quasi_velocities.clear();
        whole.start_speeds.clear();
        for QuasiVelocity { name, is, dimension, at } in speeds {
            let coordinate = whole.coordinates.len();
            let integral = *dimension * Dimension::time();
            let own = Coordinate {
                name: format!("{INTEGRAL}{name}"),
                dimension: integral,
                unit: units::Dimension::of(&integral.to_string()).coherent(),
                at: at.clone(),
            };
            whole.coordinates.push(own);
            let rate = whole.arena.scalar(Scalar::Rate { coordinate, order: 1 }, None);
            let zero = whole.arena.scalar(Scalar::Difference(*is, rate), None);
            whole.constraints.push(Constraint {
                name: None,
                zero: Zero::Scalar(zero),
                dimension: *dimension,
                gains: None,
                gains_at: at.clone(),
                at: at.clone(),
            });
        }
        whole
    }
}

impl Trace<'_> {
    /// Returns a quasi-velocity as an affine combination of speeds; `None` if it is not affine, or the rate of a single coordinate.
    pub fn combination(&self, speed: &QuasiVelocity) -> Option<Sym> {
        let own = self.scalar(speed.is);
        let slopes: Vec<Sym> = (0..self.speeds.len()).map(|k| self.by_speed(own, k)).collect();
        let is_affine = slopes.iter().all(|slope| slope.symbols_of().iter().all(|own| !self.speeds.contains(own)));
        let moves = slopes.iter().any(|slope| !crate::equations::vanishes(*slope));
        (is_affine && moves && !self.speeds.contains(&own)).then_some(own)
    }
}
