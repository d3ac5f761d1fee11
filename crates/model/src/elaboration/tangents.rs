//! The tangents along which a contact slides: one in the plane of N.x and N.y, two at right angles where it leaves that plane.

use super::Elaborator;
use super::value::Value;
use crate::arena::{Scalar, Vector};
use crate::equations::vanishes;
use crate::{FrameId, ScalarId, Trace, VectorId};
use symbolic::{Dimension, Sym, apart};

/// Components of a direction that is no axis, and in no plane or cone about one that has a short name.
const ASLANT: [f64; 3] = [211.0, 373.0, 541.0];

impl Elaborator<'_> {
    /// The tangents of a normal of length one, for a velocity of sliding.
    pub(super) fn tangents(&mut self, is_rough: bool, normal: VectorId, velocity: VectorId) -> Vec<VectorId> {
        if !(is_rough && self.leaves_the_plane(&[normal, velocity])) {
            let up = self.axis(FrameId::GROUND, 2);
            return vec![self.across(normal, up)];
        }
        let own = match self.model.arena.vector_at(normal) {
            Some(Vector::Negation(of)) => *of,
            _ => normal,
        };
        // axes of one frame have no singular position
        if let Some(Vector::Axis { frame, axis }) = self.model.arena.vector_at(own) {
            let (frame, axis) = (*frame, *axis);
            return [1, 2].map(|next| self.axis(frame, (axis + next) % 3)).to_vec();
        }
        let across = (0..3).find(|&axis| !self.has_component(&[normal], &[axis]));
        let first = match across {
            // an axis to which the normal is perpendicular in every position
            Some(axis) => self.axis(FrameId::GROUND, axis),
            None => {
                let beside = self.aslant();
                let first = self.across(beside, normal);
                self.unit_of(first)
            }
        };
        vec![first, self.across(normal, first)]
    }

    /// A direction in which no normal of a surface that somebody writes down points: tangents that are perpendicular to it have no value there.
    fn aslant(&mut self) -> VectorId {
        let mut sum = None;
        for (axis, part) in ASLANT.into_iter().enumerate() {
            let part = crate::arena::Number { value: part, times: 1.0, per: 1.0 };
            let part = self.scalar(Scalar::Number(part), Some(Dimension::none()));
            let axis = self.axis(FrameId::GROUND, axis);
            let along = self.vector(Vector::Scaled(part, axis), Some(Dimension::none()));
            sum = Some(sum.map_or(along, |sum| self.vector(Vector::Sum(sum, along), Some(Dimension::none()))));
        }
        sum.unwrap_or_else(|| self.vector(Vector::Zero, None))
    }

    /// The sum of axes by factors.
    pub(super) fn along_axes(
        &mut self,
        factors: &[ScalarId],
        axes: &[VectorId],
        dimension: Option<Dimension>,
    ) -> VectorId {
        let mut sum = None;
        for (&factor, &axis) in factors.iter().zip(axes) {
            let part = self.vector(Vector::Scaled(factor, axis), dimension);
            sum = Some(sum.map_or(part, |sum| self.vector(Vector::Sum(sum, part), dimension)));
        }
        sum.unwrap_or_else(|| self.vector(Vector::Zero, dimension))
    }

    fn axis(&mut self, frame: FrameId, axis: usize) -> VectorId {
        self.vector(Vector::Axis { frame, axis }, Some(Dimension::none()))
    }

    fn across(&mut self, one: VectorId, other: VectorId) -> VectorId {
        self.vector(Vector::Cross(one, other), Some(Dimension::none()))
    }

    /// A vector over its length; an axis as it is.
    pub(super) fn unit_of(&mut self, vector: VectorId) -> VectorId {
        let is_axis = |of: VectorId| matches!(self.model.arena.vector_at(of), Some(Vector::Axis { .. }));
        let is_unit = match self.model.arena.vector_at(vector) {
            Some(Vector::Negation(of)) => is_axis(*of),
            _ => is_axis(vector),
        };
        if is_unit {
            return vector;
        }
        match self.length(&(0..0), true, Value::Vector(vector)) {
            Ok(Value::Vector(unit)) => unit,
            _ => vector,
        }
    }

    /// Whether one of some vectors has a component along N.z.
    fn leaves_the_plane(&self, vectors: &[VectorId]) -> bool {
        self.faults.is_empty() && self.has_component(vectors, &[2])
    }

    fn has_component(&self, vectors: &[VectorId], axes: &[usize]) -> bool {
        let model = &self.model;
        apart(|| {
            let trace = Trace::of(model);
            let along = |vector: VectorId, axis: usize| {
                trace.dot(trace.vector(vector), crate::trace::Vector::axis(FrameId::GROUND, axis))
            };
            let mut all = vectors.iter().flat_map(|&vector| axes.iter().map(move |&axis| (vector, axis)));
            all.any(|(vector, axis)| {
                let component = along(vector, axis);
                component != Sym::ZERO && !vanishes(component)
            })
        })
    }
}
