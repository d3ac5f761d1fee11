//! Points, described by the displacements that lead to them from the origin. Each displacement is a vector in the axes of one frame. Points of several
//! bodies that coincide have one `Place`.

use crate::arena::{Part, Vector as Form};
use crate::trace::{Trace, Vector};
use crate::{FrameId, PointId, VectorId};
use std::collections::HashMap;
use symbolic::Sym;

/// A point, by its index; the origin has the index 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Place(usize);

/// The displacement `way` from a point `from` to the next.
#[derive(Clone, Copy)]
pub(super) struct Step {
    pub from: Place,
    pub way: Vector,
}

/// All points, with their displacements.
pub(super) struct Places<'t, 'm> {
    trace: &'t Trace<'m>,
    steps: Vec<Option<Step>>,
    known: HashMap<(Place, FrameId, [Sym; 3]), Place>,
    points: Vec<Place>,
}

impl<'t, 'm> Places<'t, 'm> {
    pub const ORIGIN: Place = Place(0);

    pub fn of(trace: &'t Trace<'m>) -> Self {
        let mut places = Places { trace, steps: vec![None], known: HashMap::new(), points: Vec::new() };
        for point in &trace.model.points {
            let place = match point.base {
                None => Self::ORIGIN,
                Some((base, way)) => places.by_way(places.points[base.0], way),
            };
            places.points.push(place);
        }
        places
    }

    /// Returns the place of a point of the model.
    pub fn of_point(&self, point: PointId) -> Place {
        self.points[point.0]
    }

    /// Returns the displacement that leads to a place; `None` for the origin.
    pub fn step(&self, place: Place) -> Option<Step> {
        self.steps[place.0]
    }

    /// Returns the place and its predecessors, down to the origin.
    pub fn path(&self, place: Place) -> impl Iterator<Item = Place> {
        std::iter::successors(Some(place), |place| self.step(*place).map(|step| step.from))
    }

    /// Returns the vector from one place to another, along the displacements that they do not share.
    pub fn between(&self, from: Place, to: Place) -> Vector {
        let [one, other] = [from, to].map(|end| self.path(end).collect::<Vec<Place>>());
        let shared = one.iter().rev().zip(other.iter().rev()).take_while(|(a, b)| a == b).count();
        let way = |path: &[Place]| {
            let steps = path[..path.len() - shared].iter().rev().filter_map(|place| self.step(*place));
            steps.fold(Vector::ZERO, |sum, step| self.trace.sum(sum, step.way))
        };
        self.trace.sum(way(&other), way(&one).map(|component| -component))
    }

    /// Returns the place at the end of a vector. Its terms are grouped by frames; frames nearer to the ground come first.
    fn by_way(&mut self, from: Place, way: VectorId) -> Place {
        let mut terms: Vec<Vector> = Vec::new();
        for term in self.terms(way) {
            match terms.iter_mut().find(|known| known.frame == term.frame) {
                Some(known) => *known = self.trace.sum(*known, term),
                None => terms.push(term),
            }
        }
        terms.sort_by_key(|term| self.depth(term.frame));
        terms.into_iter().filter(|term| !term.is_zero()).fold(from, |from, way| self.after(from, way))
    }

    fn after(&mut self, from: Place, way: Vector) -> Place {
        let new = Place(self.steps.len());
        let place = *self.known.entry((from, way.frame, way.components)).or_insert(new);
        if place == new {
            self.steps.push(Some(Step { from, way }));
        }
        place
    }

    /// Splits a vector into the terms of its sum.
    fn terms(&self, vector: VectorId) -> Vec<Vector> {
        let opposite = |all: Vec<Vector>| -> Vec<Vector> {
            all.into_iter().map(|term| term.map(|component| -component)).collect()
        };
        match &self.trace.model.arena.parts[vector.0] {
            Part::Vector(Form::Sum(a, b)) => [self.terms(*a), self.terms(*b)].concat(),
            Part::Vector(Form::Difference(a, b)) => [self.terms(*a), opposite(self.terms(*b))].concat(),
            Part::Vector(Form::Negation(a)) => opposite(self.terms(*a)),
            Part::Vector(Form::Scaled(scale, a)) => {
                let scale = self.trace.scalar(*scale);
                self.terms(*a).into_iter().map(|term| term.map(|component| scale * component)).collect()
            }
            _ => vec![self.trace.vector(vector)],
        }
    }

    fn depth(&self, frame: FrameId) -> usize {
        std::iter::successors(Some(frame), |frame| self.trace.model.frames[frame.0].parent.map(|(parent, _)| parent))
            .count()
    }
}
