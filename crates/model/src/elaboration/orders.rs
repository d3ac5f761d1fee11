//! The highest time derivative of a coordinate in each node, determined as the nodes are added.

use crate::arena::{Scalar, Vector};
use crate::{FrameId, Material, Model, PointId, ScalarId, Turn, VectorId};

/// The order of speeds.
pub(super) const SPEEDS: usize = 1;

/// The order of accelerations, and of reactions, which depend on accelerations.
pub(super) const ACCELERATIONS: usize = 2;

/// The highest order of a coordinate's time derivative in each node; `None` for nodes that depend on no coordinate.
#[derive(Default)]
pub(super) struct Orders {
    of_parts: Vec<Option<usize>>,
}

impl Orders {
    /// Returns the highest order in an existing node.
    pub fn of(&self, part: usize) -> Option<usize> {
        self.of_parts[part]
    }

    /// Adds the order of the next node.
    pub fn push(&mut self, order: Option<usize>) {
        self.of_parts.push(order);
    }

    /// Returns the highest order in a scalar node, from those of its operands.
    pub fn of_scalar(&self, model: &Model, scalar: &Scalar) -> Option<usize> {
        let of = |id: &ScalarId| self.of_parts[id.0];
        match scalar {
            Scalar::Number(_) | Scalar::Parameter(_) | Scalar::Time | Scalar::Switch(..) | Scalar::Pi => None,
            Scalar::Reaction { .. } | Scalar::Contact { .. } => Some(ACCELERATIONS),
            Scalar::Coordinate(_) | Scalar::PotentialEnergy => Some(0),
            Scalar::KineticEnergy | Scalar::Momentum { .. } | Scalar::Law { .. } => Some(1),
            Scalar::Rate { order, .. } => Some(*order),
            Scalar::Input(input) => model.inputs[*input].value.as_ref().and_then(of),
            Scalar::Negation(a) | Scalar::Power(a, _) | Scalar::Function(_, a) | Scalar::Step(a, _) => of(a),
            Scalar::Sum(a, b) | Scalar::Difference(a, b) | Scalar::Product(a, b) | Scalar::Quotient(a, b) => {
                of(a).max(of(b))
            }
            Scalar::Elementary(_, a, b) => of(a).max(of(b)),
            Scalar::Dot(a, b) => self.of_parts[a.0].max(self.of_parts[b.0]),
            Scalar::Norm(a) => self.of_parts[a.0],
            Scalar::RateOf(a) => of(a).map(|order| order + 1),
        }
    }

    /// Returns the highest order in a vector node, from those of its operands.
    pub fn of_vector(&self, model: &Model, vector: &Vector) -> Option<usize> {
        let of = |id: &VectorId| self.of_parts[id.0];
        let rate = |order: Option<usize>| order.map(|order| order + 1);
        match vector {
            Vector::Zero => None,
            Vector::Reaction { .. } | Vector::JointForce(_) | Vector::JointTorque(_) => Some(ACCELERATIONS),
            Vector::Axis { frame, .. } => self.of_frame(model, *frame),
            Vector::Negation(a) => of(a),
            Vector::Sum(a, b) | Vector::Difference(a, b) | Vector::Cross(a, b) => of(a).max(of(b)),
            Vector::Scaled(a, b) => self.of_parts[a.0].max(of(b)),
            Vector::Between { from, to } => self.of_point(model, *from).max(self.of_point(model, *to)),
            Vector::Velocity { of, seen } => rate(self.of_material(model, *of).max(self.of_frame(model, *seen))),
            Vector::Acceleration { of, seen } => {
                rate(rate(self.of_material(model, *of).max(self.of_frame(model, *seen))))
            }
            Vector::AngularVelocity { of, seen } => rate(self.of_frame(model, *of).max(self.of_frame(model, *seen))),
            Vector::RateOf { of: vector, seen } => rate(of(vector).max(self.of_frame(model, *seen))),
        }
    }

    fn of_frame(&self, model: &Model, frame: FrameId) -> Option<usize> {
        let mut order = None;
        let mut at = frame;
        while let Some((parent, turn)) = model.frames[at.0].parent {
            let own = match turn {
                Turn::About { angle, .. } => self.of_parts[angle.0],
                Turn::Free { .. } => Some(0),
            };
            (order, at) = (order.max(own), parent);
        }
        order
    }

    pub fn of_point(&self, model: &Model, point: PointId) -> Option<usize> {
        let mut order = None;
        let mut at = point;
        while let Some((base, way)) = model.points[at.0].base {
            (order, at) = (order.max(self.of_parts[way.0]), base);
        }
        order
    }

    fn of_material(&self, model: &Model, at: Material) -> Option<usize> {
        let body = at.body.map(|body| &model.bodies[body.0]);
        let frame = body.and_then(|body| body.frame).and_then(|frame| self.of_frame(model, frame));
        let centre = body.and_then(|body| body.centre).and_then(|centre| self.of_point(model, centre));
        self.of_point(model, at.point).max(frame).max(centre)
    }
}
