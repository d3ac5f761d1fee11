//! A sketch under construction: its parts, with the points and directions to which they refer.

use super::instants;
use ::scenes::geometry::{Figure, Geometry};
use charts::{Instant, SketchPart};
use nalgebra::Vector3;

/// A sketch under construction.
pub struct Parts<'a> {
    pub geometry: &'a Geometry,
    pub figures: &'a [Figure],
    pub parts: Vec<SketchPart>,
    /// The points with names, by their indices, the more important ones first.
    pub names: Vec<(usize, String)>,
    pub instants: Vec<Instant>,
    /// For each body, the index of the point at which its name stands.
    pub bodies: Vec<Option<usize>>,
    /// For each body, the index of the point about which it is drawn.
    pub middles: Vec<Option<usize>>,
}

impl<'a> Parts<'a> {
    pub fn of(geometry: &'a Geometry, figures: &'a [Figure]) -> Self {
        let bodies = vec![None; geometry.model.bodies.len()];
        let middles = bodies.clone();
        Parts { geometry, figures, parts: Vec::new(), names: Vec::new(), instants: instants(figures), bodies, middles }
    }

    pub fn add(&mut self, part: SketchPart) {
        if !self.parts.contains(&part) {
            self.parts.push(part);
        }
    }

    /// Adds a point to those of the model and returns its index.
    pub fn place(&mut self, of: impl Fn(&Figure) -> Vector3<f64>) -> usize {
        for (instant, figure) in self.instants.iter_mut().zip(self.figures) {
            instant.places.push(of(figure).into());
        }
        self.instants.first().map_or(0, |instant| instant.places.len() - 1)
    }

    /// Adds the midpoint of two points and returns its index.
    pub fn between(&mut self, one: usize, other: usize) -> usize {
        for Instant { places, .. } in &mut self.instants {
            let (one, other) = (places[one], places[other]);
            places.push(std::array::from_fn(|k| 0.5 * (one[k] + other[k])));
        }
        self.instants.first().map_or(0, |instant| instant.places.len() - 1)
    }

    pub fn direction(&mut self, of: impl Fn(&Figure) -> Vector3<f64>) -> usize {
        for (instant, figure) in self.instants.iter_mut().zip(self.figures) {
            instant.directions.push(of(figure).into());
        }
        self.instants.first().map_or(0, |instant| instant.directions.len() - 1)
    }

    /// Whether two points of the model coincide at all instants.
    pub fn coincide(&self, a: usize, b: usize) -> bool {
        let near = 1e-6 * self.geometry.size;
        self.figures.iter().all(|figure| (figure.places[a] - figure.places[b]).norm() <= near)
    }
}
