//! The points of a model, and intermediate points of their displacements.
//!
//! A point defined by displacements in several frames passes an intermediate point where the frame changes: `O + r*A.x + l*B.x` passes the
//! pin at `O + r*A.x`.

use super::elements::vector_terms;
use crate::{FrameId, Trace, Vector, VectorId};
use symbolic::Sym;

/// A point of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The name of the point; empty if it has none.
    pub name: String,
    /// The position relative to the origin, along the axes of the ground, in metres.
    pub position: [Sym; 3],
    /// The preceding point, and the frame of the displacement from it; `None` for the origin.
    pub base: Option<(usize, FrameId)>,
}

/// Returns the points by index, followed by the intermediate points.
pub(super) fn places(trace: &Trace<'_>) -> Vec<Place> {
    let model = trace.model;
    let ground = |vector: Vector| trace.express(vector, FrameId::GROUND);
    let mut between: Vec<Place> = Vec::new();
    let mut places: Vec<Place> = Vec::new();
    for (number, point) in model.points.iter().enumerate() {
        let name = if number == 0 && point.name.is_empty() { "O".to_owned() } else { point.name.clone() };
        let position = ground(trace.position(crate::PointId(number)));
        let base = point.base.map(|(base, way)| {
            let parts = parts(trace, way);
            let (mut from, mut at) = (base.0, trace.position(base));
            for part in parts.iter().take(parts.len().saturating_sub(1)) {
                at = trace.sum(at, *part);
                between.push(Place { name: String::new(), position: ground(at), base: Some((from, part.frame)) });
                from = model.points.len() + between.len() - 1;
            }
            (from, parts.last().map_or(FrameId::GROUND, |part| part.frame))
        });
        places.push(Place { name, position, base });
    }
    places.extend(between);
    places
}

/// Splits a displacement into displacements in one frame each.
fn parts(trace: &Trace<'_>, way: VectorId) -> Vec<Vector> {
    let mut found: Vec<Vector> = Vec::new();
    for vector in vector_terms(trace, way) {
        match found.last_mut() {
            Some(last) if last.frame == vector.frame => *last = trace.sum(*last, vector),
            _ => found.push(vector),
        }
    }
    found
}
