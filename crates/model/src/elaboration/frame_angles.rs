//! Free frames described by three angles, for methods that require as many coordinates as speeds.

use super::Elaborator;
use super::value::Value;
use crate::arena::{Scalar, Vector};
use crate::source::FrameAngles;
use crate::{Coordinate, FrameId, Text, Turn};
use symbolic::Dimension;

impl Elaborator<'_> {
    /// Adds a frame that results from three successive rotations about the given axes.
    pub(super) fn turned_by_angles(&mut self, name: &Text, parent: FrameId, angles: &FrameAngles) -> FrameId {
        let none = Some(Dimension::none());
        let mut frame = parent;
        for (place, (&axis, angle)) in angles.axes.iter().zip(&angles.names).enumerate() {
            let (coordinate, unit) = (format!("{}.{angle}", name.text), "rad".to_owned());
            self.model.coordinates.push(Coordinate {
                name: coordinate.clone(),
                dimension: Dimension::none(),
                unit,
                at: name.span(),
            });
            let angle = self.scalar(Scalar::Coordinate(self.model.coordinates.len() - 1), none);
            let own = if place + 1 < angles.axes.len() { &coordinate } else { &name.text };
            frame = self.new_frame(own, frame, Turn::About { axis, angle });
        }
        self.by_angles.push(frame);
        frame
    }

    /// Returns a component of the angular velocity of a frame described by angles, relative to its parent, along its own axis.
    pub(super) fn turning_by_angles(&mut self, frame: FrameId, axis: usize) -> Value {
        let per_second = Some(Dimension::none() / Dimension::time());
        let seen = self.parent_before_angles(frame);
        let turning = self.vector(Vector::AngularVelocity { of: frame, seen }, per_second);
        let along = self.vector(Vector::Axis { frame, axis }, Some(Dimension::none()));
        Value::Scalar(self.scalar(Scalar::Dot(turning, along), per_second))
    }

    /// Returns whether a start value called `name` belongs to a frame described by angles, or to its angular velocity. Such start values
    /// are replaced by start values of the angles.
    pub(super) fn places_by_angles(&self, name: &str) -> bool {
        let frame = name.rsplit_once('.').map_or(name, |(frame, _)| frame);
        self.by_angles.iter().any(|FrameId(own)| self.model.frames[*own].name == frame)
    }

    /// Returns the parent frame before the three rotations.
    pub(super) fn parent_before_angles(&self, frame: FrameId) -> FrameId {
        let parent =
            |FrameId(own): FrameId| self.model.frames[own].parent.map_or(FrameId::GROUND, |(parent, _)| parent);
        (0..3).fold(frame, |own, _| parent(own))
    }
}
