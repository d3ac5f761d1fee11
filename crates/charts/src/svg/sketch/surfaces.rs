//! Surfaces of contacts, and guides of sliding blocks. They are long enough for the positions at all instants.

use super::SurfaceKind;
use super::camera::{cross, dot, unit};
use super::marks::{polygon, segments};
use super::pose::{Flat, Pose};
use super::shapes::{Scene, Shape};

/// The length beyond the points of contact, in pixels.
pub(super) const BEYOND: f64 = 42.0;
/// Half the length of a tangent, in pixels.
const TANGENT: f64 = 11.0;
/// The length of the strokes of hatching and the distance between them, in pixels.
const HATCH: f64 = 8.0;

/// A surface at a point of contact: a hatched line where the surface is seen edge-on, otherwise a quadrilateral patch.
pub(super) fn surface(scene: Scene<'_>, at: usize, normal: usize, kind: SurfaceKind) -> Vec<Shape> {
    let of_ground = kind == SurfaceKind::Ground;
    let normals = scene.each(|instant| unit(Scene::direction(instant, normal)).unwrap_or([0.0, 1.0, 0.0]));
    let Some(first) = normals.first().copied() else { return Vec::new() };
    let rests = of_ground && normals.iter().all(|normal| dot(*normal, first) > 1.0 - 1e-9);
    let places = scene.each(|instant| instant.places.get(at).copied().unwrap_or_default());
    // the points of contact of all instants lie along a surface at rest
    let reach = |along: [f64; 3], here: [f64; 3]| -> (f64, f64) {
        if !rests {
            return (0.0, 0.0);
        }
        let offsets = places.iter().map(|place| dot(along, *place) - dot(along, here));
        offsets.fold((0.0, 0.0), |(low, high): (f64, f64), offset| (low.min(offset), high.max(offset)))
    };
    let is_edge = normals.iter().all(|normal| scene.camera.depth(*normal).abs() < 1e-6);
    let beyond = if kind == SurfaceKind::Curve { TANGENT } else { BEYOND } / scene.camera.scale;
    let corner = |here: [f64; 3], ways: &[([f64; 3], f64)]| {
        let place = std::array::from_fn(|k| ways.iter().fold(here[k], |sum, (way, length)| sum + way[k] * length));
        scene.camera.place(place)
    };
    let drawn = if rests { 1 } else { places.len() };
    let frames = places.iter().zip(&normals).take(drawn);
    if is_edge {
        let points: Vec<Vec<Flat>> = frames
            .map(|(place, normal)| {
                // the free side is to the left of this direction, so that the hatching lies inside the solid
                let along = unit(cross(*normal, scene.camera.towards())).unwrap_or([1.0, 0.0, 0.0]);
                let (low, high) = reach(along, *place);
                [low - beyond, high + beyond].map(|length| corner(*place, &[(along, length)])).to_vec()
            })
            .collect();
        let path = |ends: &[Flat]| hatched([ends[0], ends[1]], of_ground);
        return vec![Shape::new(0, "surface", Pose::through(&points, path))];
    }
    let points: Vec<Vec<Flat>> = frames
        .map(|(place, normal)| {
            let other = if normal[0].abs() < 0.8 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
            let first = unit(cross(cross(*normal, other), *normal)).unwrap_or(other);
            let second = cross(*normal, first);
            let (a, b) = (reach(first, *place), reach(second, *place));
            let corners = [(a.0, b.0, -1.0, -1.0), (a.1, b.0, 1.0, -1.0), (a.1, b.1, 1.0, 1.0), (a.0, b.1, -1.0, 1.0)];
            corners
                .map(|(x, y, right, up)| corner(*place, &[(first, x + right * beyond), (second, y + up * beyond)]))
                .to_vec()
        })
        .collect();
    vec![Shape::new(0, "patch", Pose::through(&points, polygon))]
}

/// A line between two ends, with hatching to the right of the direction from the first to the second.
fn hatched([from, to]: [Flat; 2], of_ground: bool) -> String {
    let mut ends = vec![from, to];
    let length = (to.0 - from.0).hypot(to.1 - from.1);
    if of_ground && length > 0.0 {
        let (ux, uy) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
        let count = (length / HATCH).floor() as usize;
        for k in 1..=count {
            let (x, y) = (from.0 + k as f64 * HATCH * ux, from.1 + k as f64 * HATCH * uy);
            ends.extend([(x, y), (x - 6.0 * (ux + uy), y - 6.0 * (uy - ux))]);
        }
    }
    segments(&ends)
}

/// The guide of a sliding block: a segment through all its positions.
pub(super) fn guide(scene: Scene<'_>, at: usize, along: usize) -> Pose {
    let beyond = BEYOND / scene.camera.scale;
    let Some(first) = scene.sketch.instants.first() else { return Pose::Still(String::new()) };
    let along = unit(Scene::direction(first, along)).unwrap_or([1.0, 0.0, 0.0]);
    let place = first.places.get(at).copied().unwrap_or_default();
    let offsets = scene.each(|instant| instant.places.get(at).map_or(0.0, |now| dot(along, *now) - dot(along, place)));
    let (low, high) = offsets.iter().fold((0.0, 0.0), |(low, high): (f64, f64), x| (low.min(*x), high.max(*x)));
    let end = |length: f64| scene.camera.place(std::array::from_fn(|k| place[k] + length * along[k]));
    Pose::Still(segments(&[end(low - beyond), end(high + beyond)]))
}
