//! Classification of contacts by samples of the motion: contacts with planes, and with round bodies.

use super::Wheel;
use super::figure::{Figure, Symbolic};
use super::rigid::{Link, Structure, within};
use model::Model;

/// Differences of directions, and relative differences of lengths, below this value are rounding errors.
const SAME: f64 = 1e-7;

/// For each contact: true if its surface is a plane that is fixed in the ground or in the touched body.
pub(super) fn planes(model: &Model, samples: &[Figure], symbolic: &Symbolic, structure: &Structure) -> Vec<bool> {
    let near = SAME * structure.size.max(f64::MIN_POSITIVE);
    let is_plane = |(number, (contact, _)): (usize, &(usize, usize))| {
        let body = model.contacts[*contact].with.map(|body| &model.bodies[body.0]);
        let frame = body.and_then(|body| body.frame).map_or(0, |frame| structure.turning[frame.0]);
        let base = body.and_then(|body| body.centre).map_or(0, |centre| centre.0);
        // the normal in axes of the touched body, and the distance of the plane from its centre
        let seen = |at: &Figure| {
            let touch = at.touches[number];
            let foot = at.places[touch.point] - touch.gap * touch.normal;
            (within(&at.frames[frame], touch.normal), touch.normal.dot(&(foot - at.places[base])))
        };
        let Some((normal, distance)) = samples.first().map(seen) else { return true };
        samples.iter().map(seen).all(|(n, d)| (n - normal).norm() <= SAME && (d - distance).abs() <= near)
    };
    symbolic.contacts.iter().enumerate().map(is_plane).collect()
}

/// Round bodies that are not in `known`: their contact point lies along the normal, at a constant distance from their centre.
pub(super) fn rounds(
    model: &Model,
    (samples, known): (&[Figure], &[Wheel]),
    symbolic: &Symbolic,
    structure: &Structure,
) -> Vec<Wheel> {
    let mut found: Vec<Wheel> = Vec::new();
    for (number, (contact, point)) in symbolic.contacts.iter().enumerate() {
        let with = model.contacts[*contact].with.map(|with| with.0);
        let own =
            symbolic.touched.iter().filter(|(body, at)| at == point && Some(*body) != with).map(|(body, _)| *body);
        for body in own.chain(with) {
            let Some(centre) = model.bodies[body].centre else { continue };
            // the surface of the touched body lies at the gap's distance from the point
            let share = if Some(body) == with { 1.0 } else { 0.0 };
            let arm = |at: &Figure| {
                let touch = at.touches[number];
                (at.places[*point] - share * touch.gap * touch.normal - at.places[centre.0], touch.normal)
            };
            let radius = samples.first().map_or(0.0, |at| arm(at).0.norm());
            let is_round = |at: &Figure| {
                let (arm, normal) = arm(at);
                (arm.norm() - radius).abs() <= SAME * radius && arm.cross(&normal).norm() <= SAME * radius
            };
            let turned = model.bodies[body].frame.map_or(0, |frame| structure.turning[frame.0]);
            // excludes blocks with several feet, and points that are fixed in a body
            let inside = |at: &Figure| within(&at.frames[turned], arm(at).0);
            let rests = samples.iter().all(|at| (inside(at) - inside(&samples[0])).norm() <= SAME * radius);
            let centre = structure.first[centre.0];
            let has_feet = structure
                .links
                .iter()
                .any(|link| link.frame == turned && link.places.len() > 2 && link.places.contains(&centre));
            let is_free = if turned == 0 { !has_feet } else { !rests };
            let is_known = known.iter().chain(&found).any(|wheel| wheel.body == body);
            if is_free && !is_known && radius > 0.0 && samples.iter().all(is_round) {
                found.push(Wheel { body, point: *point, radius, axis: None, turns: turned != 0 });
            }
        }
    }
    found
}

/// True if `ends` are the centre of a body and a point at which it touches, and no frame fixes both: their connection is not a bar.
pub(super) fn is_passing(model: &Model, symbolic: &Symbolic, structure: &Structure, ends: &[usize; 2]) -> bool {
    let first = &structure.first;
    let is_fixed = |link: &Link| link.frame != 0 && ends.iter().all(|end| link.places.contains(end));
    let touches = |(body, point): &(usize, usize)| {
        let centre = model.bodies[*body].centre.map(|centre| first[centre.0]);
        let is_contact = symbolic.contacts.iter().any(|(_, other)| first[*other] == first[*point]);
        is_contact && centre.is_some_and(|centre| ends.contains(&centre)) && ends.contains(&first[*point])
    };
    symbolic.touched.iter().any(touches) && !structure.links.iter().any(is_fixed)
}
