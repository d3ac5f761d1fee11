//! Independent rates of coordinates as quasi-velocities, the default for a file without [speeds].

use crate::arena::{Scalar, Vector};
use crate::equations::{Characteristics, constraints_of};
use crate::{FrameId, Model, QuasiVelocity, Trace};
use symbolic::{Dimension, apart};

impl Model {
    /// Returns the model with the independent speeds of its constraints as quasi-velocities.
    #[must_use]
    pub fn along_independent_rates(&self) -> Self {
        let (places, names) = apart(|| {
            let trace = Trace::of(self);
            let mut constraints = constraints_of(&trace);
            constraints.retain(|constraint| constraint.gains.is_none());
            let independent = Characteristics::of(&trace, &constraints).independent;
            let names: Vec<String> = independent.iter().map(|&place| trace.speeds[place].to_string()).collect();
            (independent, names)
        });
        let mut model = self.clone();
        model.quasi_velocities = Vec::new();
        for (speed, name) in places.into_iter().zip(names) {
            let written = model.written_speed(speed);
            model.quasi_velocities.push(QuasiVelocity { name, ..written });
        }
        model
    }

    /// Returns a speed as an expression: the rate of a coordinate, or a component of an angular velocity along its frame's own axes.
    fn written_speed(&mut self, speed: usize) -> QuasiVelocity {
        let per_second = Dimension::none() / Dimension::time();
        if let Some(coordinate) = self.coordinates.get(speed) {
            let (dimension, at) = (coordinate.dimension * per_second, coordinate.at.clone());
            let is = self.arena.scalar(Scalar::Rate { coordinate: speed, order: 1 }, Some(dimension));
            return QuasiVelocity { name: String::new(), is, dimension, at };
        }
        let free = speed - self.coordinates.len();
        let (frame, axis) = (self.free[free / 3], free % 3);
        let seen = self.frames[frame.0].parent.map_or(FrameId(0), |(parent, _)| parent);
        let turning = self.arena.vector(Vector::AngularVelocity { of: frame, seen });
        let along = self.arena.vector(Vector::Axis { frame, axis });
        let is = self.arena.scalar(Scalar::Dot(turning, along), Some(per_second));
        QuasiVelocity { name: String::new(), is, dimension: per_second, at: 0..0 }
    }
}
