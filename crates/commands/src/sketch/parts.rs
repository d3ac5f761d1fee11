//! The parts of a sketch as they are gathered, with the places and directions that they need.

use super::instants;
use ::scenes::geometry::{Figure, Geometry};
use charts::{Instant, SketchPart};

/// A vector along the axes of the ground.
pub type Vector = [f64; 3];

/// A sketch under construction.
pub struct Parts<'a> {
    pub geometry: &'a Geometry,
    pub figures: &'a [Figure],
    pub parts: Vec<SketchPart>,
    pub names: Vec<(usize, String)>,
    pub instants: Vec<Instant>,
    /// Places of bodies, by their numbers, where their names stand.
    pub bodies: Vec<Option<usize>>,
}

impl<'a> Parts<'a> {
    pub fn of(geometry: &'a Geometry, figures: &'a [Figure]) -> Self {
        let bodies = vec![None; geometry.model.bodies.len()];
        Parts { geometry, figures, parts: Vec::new(), names: Vec::new(), instants: instants(figures), bodies }
    }

    pub fn add(&mut self, part: SketchPart) {
        if !self.parts.contains(&part) {
            self.parts.push(part);
        }
    }

    /// A place beside those of the model.
    pub fn place(&mut self, of: impl Fn(&Figure) -> Vector) -> usize {
        for (instant, figure) in self.instants.iter_mut().zip(self.figures) {
            instant.places.push(of(figure));
        }
        self.instants.first().map_or(0, |instant| instant.places.len() - 1)
    }

    pub fn direction(&mut self, of: impl Fn(&Figure) -> Vector) -> usize {
        for (instant, figure) in self.instants.iter_mut().zip(self.figures) {
            instant.directions.push(of(figure));
        }
        self.instants.first().map_or(0, |instant| instant.directions.len() - 1)
    }

    /// Where two places are one at all times.
    pub fn coincide(&self, a: usize, b: usize) -> bool {
        let near = 1e-6 * self.geometry.size;
        self.instants.iter().all(|instant| distance(instant.places[a], instant.places[b]) <= near)
    }
}

pub fn scaled(vector: Vector, by: f64) -> Vector {
    vector.map(|part| by * part)
}

pub fn sum(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] + b[k])
}

pub fn distance(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}
