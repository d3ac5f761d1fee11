//! The tangents along which a contact slides: one in the plane N.x, N.y; two perpendicular ones if the contact leaves this plane.

use super::Elaborator;
use super::value::Value;
use crate::arena::{Scalar, Vector};
use crate::equations::vanishes;
use crate::{FrameId, ScalarId, Trace, VectorId};
use symbolic::{Dimension, Sym, apart};

/// Components of a vector in general position, used as an auxiliary direction.
const ASLANT: [f64; 3] = [211.0, 373.0, 541.0];

impl Elaborator<'_> {
    /// Returns the tangents for a unit normal and a sliding velocity.
    pub(super) fn tangents(&mut self, is_rough: bool, normal: VectorId, velocity: VectorId) -> Vec<VectorId> {
        if !(is_rough && self.leaves_the_plane(&[normal, velocity])) {
            let up = self.axis(FrameId::GROUND, 2);
            return vec![self.across(normal, up)];
        }
        let own = match self.model.arena.vector_at(normal) {
            Some(Vector::Negation(of)) => *of,
            _ => normal,
        };
        // tangents along the axes of a frame have no singular position
        if let Some(Vector::Axis { frame, axis }) = self.model.arena.vector_at(own) {
            let (frame, axis) = (*frame, *axis);
            return [1, 2].map(|next| self.axis(frame, (axis + next) % 3)).to_vec();
        }
        let across = (0..3).find(|&axis| !self.has_component(&[normal], &[axis]));
        let first = match across {
            // an axis of the ground that is perpendicular to the normal in every position
            Some(axis) => self.axis(FrameId::GROUND, axis),
            None => {
                let beside = self.aslant();
                let first = self.across(beside, normal);
                self.unit_of(first)
            }
        };
        vec![first, self.across(normal, first)]
    }

    /// Returns an auxiliary direction to which no usual normal is parallel: tangents formed with it are undefined where the normal is parallel to it.
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

    /// Returns the linear combination of axes with the given factors.
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

    /// Returns the unit vector along a vector; axes of frames are unchanged.
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

    /// Returns whether any of the vectors has a component along N.z.
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
