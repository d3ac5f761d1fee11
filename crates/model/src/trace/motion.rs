//! Positions, velocities and accelerations of points, each computed from those of the point from which it is defined.

use super::{Trace, Vector};
use crate::{BodyId, FrameId, Material, PointId};

/// The motion of a point relative to the origin of the ground.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointMotion {
    position: Vector,
    velocity: Vector,
    acceleration: Vector,
}

impl Trace<'_> {
    /// Returns the motion of a point; computes that of earlier points first.
    fn moving(&self, point: PointId) -> PointMotion {
        let rest = PointMotion { position: Vector::ZERO, velocity: Vector::ZERO, acceleration: Vector::ZERO };
        loop {
            // a point is defined from an earlier one
            let next = self.points.borrow().len();
            if let Some(known) = self.points.borrow().get(point.0) {
                return *known;
            }
            let moving = match self.model.points[next].base {
                None => rest,
                Some((base, way)) => {
                    let base = self.points.borrow()[base.0];
                    let way = self.vector(way);
                    let way_velocity = self.vector_rate(way);
                    PointMotion {
                        position: self.sum(base.position, way),
                        velocity: self.sum(base.velocity, way_velocity),
                        acceleration: self.sum(base.acceleration, self.vector_rate(way_velocity)),
                    }
                }
            };
            self.points.borrow_mut().push(moving);
        }
    }

    /// Returns the vector from the origin to a point.
    pub fn position(&self, point: PointId) -> Vector {
        self.moving(point).position
    }

    /// Returns the velocity of a point relative to the ground.
    pub fn velocity(&self, point: PointId) -> Vector {
        self.moving(point).velocity
    }

    /// Returns the acceleration of a point relative to the ground.
    pub fn acceleration(&self, point: PointId) -> Vector {
        self.moving(point).acceleration
    }

    /// Returns the vector from one point to another.
    pub fn between(&self, from: PointId, to: PointId) -> Vector {
        // displacements common to both points are omitted
        let path = |mut point: PointId| {
            let mut path = vec![point];
            while let Some((base, _)) = self.model.points[point.0].base {
                path.push(base);
                point = base;
            }
            path
        };
        let (from, to) = (path(from), path(to));
        let shared = from.iter().rev().zip(to.iter().rev()).take_while(|(a, b)| a == b).count();
        let way = |path: &[PointId]| {
            let ways = path[..path.len() - shared].iter().rev().filter_map(|point| self.model.points[point.0].base);
            ways.fold(Vector::ZERO, |sum, (_, way)| self.sum(sum, self.vector(way)))
        };
        self.sum(way(&to), way(&from).map(|component| -component))
    }

    /// Returns the angular velocity of a frame relative to another one.
    pub(crate) fn turning_beside(&self, of: FrameId, seen: FrameId) -> Vector {
        self.sum(self.frames.turning(of), self.frames.turning(seen).map(|component| -component))
    }

    /// Returns the angular velocity of a frame relative to the ground.
    pub fn turning(&self, frame: FrameId) -> Vector {
        self.frames.turning(frame)
    }

    /// Returns the rate of a vector relative to a frame.
    pub(crate) fn rate_seen(&self, vector: Vector, seen: FrameId) -> Vector {
        let carried = self.frames.cross(self.frames.turning(seen), vector);
        self.sum(self.vector_rate(vector), carried.map(|component| -component))
    }

    /// Returns the velocity of a point of a body, v_C + w x (P - C); without a body that of the point itself.
    pub fn material_velocity(&self, Material { body, point }: Material) -> Vector {
        match self.rigid(body, point) {
            Some((centre, turning, arm)) => self.sum(self.velocity(centre), self.frames.cross(turning, arm)),
            None => self.velocity(point),
        }
    }

    /// Returns the acceleration of a point of a body, a_C + w' x r + w x (w x r); without a body that of the point itself.
    pub fn material_acceleration(&self, Material { body, point }: Material) -> Vector {
        match self.rigid(body, point) {
            Some((centre, turning, arm)) => {
                let angular = self.vector_rate(turning);
                let across = self.frames.cross(turning, self.frames.cross(turning, arm));
                let around = self.sum(self.frames.cross(angular, arm), across);
                self.sum(self.acceleration(centre), around)
            }
            None => self.acceleration(point),
        }
    }

    /// Returns the centre of mass of a body, its angular velocity, and the vector from the centre to a point; `None` if the point is the
    /// centre, or there is no body. A particle carries its points without rotation.
    fn rigid(&self, body: Option<BodyId>, point: PointId) -> Option<(PointId, Vector, Vector)> {
        let body = &self.model.bodies[body?.0];
        let (frame, centre) = (body.frame.unwrap_or(FrameId::GROUND), body.centre?);
        (centre != point).then(|| (centre, self.frames.turning(frame), self.between(centre, point)))
    }

    pub(super) fn seen_velocity(&self, of: Material, seen: FrameId) -> Vector {
        let velocity = self.material_velocity(of);
        let carried = self.frames.cross(self.frames.turning(seen), self.position(of.point));
        self.sum(velocity, carried.map(|component| -component))
    }

    pub(super) fn seen_acceleration(&self, of: Material, seen: FrameId) -> Vector {
        if seen == FrameId::GROUND {
            return self.material_acceleration(of);
        }
        self.rate_seen(self.seen_velocity(of, seen), seen)
    }

    /// Returns the partial derivative of a vector by a speed. The orientations of frames depend on coordinates only.
    pub fn vector_by_speed(&self, vector: Vector, speed: usize) -> Vector {
        vector.map(|component| self.by_speed(component, speed))
    }

    /// Returns the derivative of a vector by a coordinate, relative to the ground; it includes the rotation of the vector's frame.
    pub fn vector_by_coordinate(&self, vector: Vector, coordinate: usize) -> Vector {
        let own = vector.map(|component| self.by_coordinate(component, coordinate));
        let turning = self.vector_by_speed(self.frames.turning(vector.frame), coordinate);
        self.sum(own, self.frames.cross(turning, vector))
    }

    /// Returns the displacement of a point of a body per displacement of a coordinate; it includes the rotation of the body.
    pub fn material_displacement(&self, Material { body, point }: Material, coordinate: usize) -> Vector {
        match self.rigid(body, point) {
            Some((centre, turning, arm)) => {
                let turned = self.frames.cross(self.vector_by_speed(turning, coordinate), arm);
                self.sum(self.vector_by_coordinate(self.position(centre), coordinate), turned)
            }
            None => self.vector_by_coordinate(self.position(point), coordinate),
        }
    }
}
