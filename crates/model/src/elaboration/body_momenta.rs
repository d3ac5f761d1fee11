//! Momenta of one body in outputs: m v of the centre of mass C, and I w + (C - P) x m v about a point P.

use super::expressions::Meaning;
use super::loads::joule;
use super::value::Value;
use super::{Elaborator, Sound, mismatch};
use crate::arena::{Scalar, Vector};
use crate::expression::usage;
use crate::{BodyId, Fault, FrameId, Inertia, Material, VectorId};
use std::ops::Range;
use symbolic::Dimension;

/// The axes (row, column) of the six entries of an inertia tensor.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl Elaborator<'_> {
    /// Reads `momentum(bob)`: the mass times the velocity of the centre of mass.
    pub(super) fn momentum_of_body(&mut self, span: &Range<usize>, body: BodyId) -> Sound<Value> {
        let Some(momentum) = self.linear_momentum(span, body)? else {
            let name = &self.model.bodies[body.0].name;
            let title = format!("the body `{name}` has no mass");
            return Err(Box::new(Fault::at(span.clone(), title, "no momentum", "`mass` with `centre`")));
        };
        Ok(Value::Vector(momentum))
    }

    /// Reads `angular_momentum(top)` about the centre of mass, or `angular_momentum(top, P)` about a point.
    pub(super) fn angular_momentum(&mut self, span: &Range<usize>, arguments: &[Meaning]) -> Sound<Value> {
        let (body, about) = match arguments {
            [Meaning::Body(body)] => (*body, None),
            [Meaning::Body(body), Meaning::Value(Value::Point { base, way })] => {
                (*body, Some(self.point_of(*base, *way)))
            }
            [Meaning::Body(_), Meaning::Value(other)] => {
                return Err(mismatch(span, "the second argument", "a point", other));
            }
            _ => {
                let accepted = usage("angular_momentum");
                return Err(Box::new(Fault::at(span.clone(), "a body has an angular momentum", "here", accepted)));
            }
        };
        let mut whole = self.spin(body);
        if let Some(about) = about
            && let Some(momentum) = self.linear_momentum(span, body)?
        {
            let centre = self.centre(body, span)?;
            let arm = self.between(about, centre);
            let moment = self.vector(Vector::Cross(arm, momentum), Some(angular()));
            whole = self.vector(Vector::Sum(whole, moment), Some(angular()));
        }
        Ok(Value::Vector(whole))
    }

    fn linear_momentum(&mut self, span: &Range<usize>, body: BodyId) -> Sound<Option<VectorId>> {
        let Some(mass) = self.model.bodies[body.0].mass else { return Ok(None) };
        let of = Material { body: Some(body), point: self.centre(body, span)? };
        let speed = Dimension::length() / Dimension::time();
        let velocity = self.vector(Vector::Velocity { of, seen: FrameId::GROUND }, Some(speed));
        Ok(Some(self.vector(Vector::Scaled(mass, velocity), Some(Dimension::mass() * speed))))
    }

    /// Returns the angular momentum of a body about its centre of mass.
    fn spin(&mut self, body: BodyId) -> VectorId {
        let none = self.vector(Vector::Zero, Some(angular()));
        let known = &self.model.bodies[body.0];
        let (Some(inertia), Some(of)) = (known.inertia.clone(), known.frame) else { return none };
        let per_second = Dimension::none() / Dimension::time();
        let turning = self.vector(Vector::AngularVelocity { of, seen: FrameId::GROUND }, Some(per_second));
        let (axes, parts) = match inertia {
            Inertia::Axial(moment) => return self.vector(Vector::Scaled(moment, turning), Some(angular())),
            Inertia::OfShaft { moment, axis } => (of, vec![(moment, axis, axis)]),
            Inertia::Tensor { axes, entries } => {
                let known = entries.into_iter().zip(ENTRIES);
                let known = known.filter_map(|(entry, (i, j))| entry.map(|entry| (entry, i, j)));
                (
                    axes,
                    known
                        .flat_map(|(entry, i, j)| [Some((entry, i, j)), (i != j).then_some((entry, j, i))])
                        .flatten()
                        .collect(),
                )
            }
        };
        parts.into_iter().fold(none, |sum, (moment, i, j)| {
            let [along, across] =
                [i, j].map(|axis| self.vector(Vector::Axis { frame: axes, axis }, Some(Dimension::none())));
            let speed = self.scalar(Scalar::Dot(turning, across), Some(per_second));
            let amount = self.scalar(Scalar::Product(moment, speed), Some(angular()));
            let part = self.vector(Vector::Scaled(amount, along), Some(angular()));
            self.vector(Vector::Sum(sum, part), Some(angular()))
        })
    }
}

fn angular() -> Dimension {
    joule() * Dimension::time()
}
