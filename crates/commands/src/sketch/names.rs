//! Names in a sketch: of bodies, of points with parts, of contacts.

use super::parts::Parts;
use charts::SketchPart;

pub fn name(parts: &mut Parts<'_>) {
    let geometry = parts.geometry;
    let model = &geometry.model;
    let bodies: Vec<(usize, String)> =
        model.bodies.iter().zip(&parts.bodies).filter_map(|(body, at)| Some(((*at)?, body.name.clone()))).collect();
    let stands: Vec<usize> = parts.parts.iter().flat_map(stands_at).collect();
    let points = geometry
        .names
        .iter()
        .enumerate()
        .filter(|(place, name)| !name.is_empty() && geometry.first[*place] == *place && stands.contains(place));
    let points: Vec<(usize, String)> = points.map(|(place, name)| (place, name.clone())).collect();
    parts.names.extend(bodies);
    parts.names.extend(points);
}

/// The points of the model that a part joins, by their indices.
fn stands_at(part: &SketchPart) -> Vec<usize> {
    match part {
        SketchPart::Plate { corners, .. } => corners.clone(),
        SketchPart::Rod(ends)
        | SketchPart::Telescope(ends)
        | SketchPart::Spring(ends)
        | SketchPart::Dashpot(ends)
        | SketchPart::Actuator(ends) => ends.to_vec(),
        SketchPart::Pin(at)
        | SketchPart::Support(at)
        | SketchPart::Particle { at, .. }
        | SketchPart::TorsionSpring { at, .. }
        | SketchPart::RotaryDashpot { at, .. }
        | SketchPart::Torque { at, .. }
        | SketchPart::Arrow { at, .. } => {
            vec![*at]
        }
        _ => Vec::new(),
    }
}
