//! Detection of rolling bodies: the contact point has a constant distance from the centre and is not fixed in the body.

use super::Wheel;
use super::figure::{Figure, Symbolic};
use super::rigid::{Structure, within};
use model::Model;

/// Relative differences of lengths below this value are rounding errors.
const SAME: f64 = 1e-7;

/// All bodies that roll in the samples. The axis of rotation is the axis of the body's frame that is normal to the radius.
pub(super) fn wheels(model: &Model, samples: &[Figure], symbolic: &Symbolic, structure: &Structure) -> Vec<Wheel> {
    let mut found: Vec<Wheel> = Vec::new();
    for &(body, point) in &symbolic.touched {
        let (Some(frame), Some(centre)) = (model.bodies[body].frame, model.bodies[body].centre) else { continue };
        let arm = |at: &Figure| at.places[point] - at.places[centre.0];
        let radius = samples.first().map_or(0.0, |at| arm(at).norm());
        let keeps = samples.iter().all(|at| (arm(at).norm() - radius).abs() <= SAME * radius);
        let turned = structure.turning[frame.0];
        let inside = |at: &Figure| within(&at.frames[turned], arm(at));
        let is_fixed = samples.iter().all(|at| (inside(at) - inside(&samples[0])).norm() <= SAME * radius);
        let is_known = found.iter().any(|wheel| wheel.body == body);
        if radius <= 0.0 || !keeps || is_fixed || is_known {
            continue;
        }
        let across = |axis: &usize| samples.iter().all(|at| inside(at)[*axis].abs() <= SAME * radius);
        found.push(Wheel { body, point, radius, axis: (0..3).find(across), turns: true });
    }
    found
}
