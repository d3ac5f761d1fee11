//! Rigid bodies drawn through points fixed in them: a bar through two points, a plate through several points of a plane, a frame of bars through
//! points in space.

use super::Instant;
use super::marks::polygon;
use super::pose::{Flat, Pose, distance};
use super::shapes::{Scene, Shape, segments_between};

/// The largest value of [`width`] with which a convex hull is drawn as a bar.
const THIN: f64 = 0.02;

pub(super) fn plate(scene: Scene<'_>, corners: &[usize], colour: &str) -> Vec<Shape> {
    let Some(first) = scene.sketch.instants.first() else { return Vec::new() };
    let flat: Vec<Flat> = corners.iter().map(|corner| scene.at(first, *corner)).collect();
    let hull = hull(&flat);
    let is_wide =
        hull.len() > 2 && is_flat(scene, corners) && width(&hull.iter().map(|k| flat[*k]).collect::<Vec<_>>()) > THIN;
    if is_wide {
        let outline: Vec<usize> = hull.iter().map(|k| corners[*k]).collect();
        let points = scene.each(|instant| outline.iter().map(|corner| scene.at(instant, *corner)).collect());
        return vec![Shape::new(2, format!("plate{colour}"), Pose::through(&points, polygon))];
    }
    let bars = spanning(first, corners);
    vec![Shape::new(3, format!("bar{colour}"), segments_between(scene, &bars))]
}

/// Whether all corners keep one depth along the line of sight, so that the outline of the body does not change.
fn is_flat(scene: Scene<'_>, corners: &[usize]) -> bool {
    let mut deepest: f64 = 0.0;
    let mut widest: f64 = 0.0;
    for instant in &scene.sketch.instants {
        let place = |corner: usize| instant.places.get(corner).copied().unwrap_or_default();
        let Some(first) = corners.first().map(|corner| place(*corner)) else { return false };
        for corner in corners {
            let way: [f64; 3] = std::array::from_fn(|k| place(*corner)[k] - first[k]);
            let (right, down) = scene.camera.along(way);
            let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
            deepest = deepest.max(length * scene.camera.depth(way).abs());
            widest = widest.max(right.hypot(down) / scene.camera.scale);
        }
    }
    deepest <= 1e-6 * widest
}

/// The indices of the corners of the convex hull, in order, by the monotone chain of Andrew (1979).
fn hull(points: &[Flat]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|a, b| points[*a].0.total_cmp(&points[*b].0).then(points[*a].1.total_cmp(&points[*b].1)));
    let turns = |a: usize, b: usize, c: usize| {
        let (a, b, c) = (points[a], points[b], points[c]);
        (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)
    };
    let chain = |order: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for next in order {
            while chain.len() > 1 && turns(chain[chain.len() - 2], chain[chain.len() - 1], next) <= 0.0 {
                chain.pop();
            }
            chain.push(next);
        }
        chain.pop();
        chain
    };
    let lower = chain(&mut order.iter().copied());
    let upper = chain(&mut order.iter().rev().copied());
    [lower, upper].concat()
}

/// The roundness of a polygon, 8 area / perimeter²: zero for a segment, 1/2 for a square.
fn width(corners: &[Flat]) -> f64 {
    let next = |k: usize| corners[(k + 1) % corners.len()];
    let area: f64 = corners.iter().enumerate().map(|(k, a)| a.0 * next(k).1 - next(k).0 * a.1).sum();
    let perimeter: f64 = corners.iter().enumerate().map(|(k, a)| distance(*a, next(k))).sum();
    4.0 * area.abs() / (perimeter * perimeter).max(f64::MIN_POSITIVE)
}

/// Pairs of corners, one after the other, that are the edges of a minimum spanning tree, by Prim's algorithm.
fn spanning(instant: &Instant, corners: &[usize]) -> Vec<usize> {
    let place = |corner: usize| instant.places.get(corner).copied().unwrap_or_default();
    let apart = |a: usize, b: usize| {
        let (a, b) = (place(a), place(b));
        (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>()
    };
    let (mut joined, mut bars) = (corners[..corners.len().min(1)].to_vec(), Vec::new());
    while joined.len() < corners.len() {
        let left = corners.iter().filter(|corner| !joined.contains(corner));
        let pairs = left.flat_map(|corner| joined.iter().map(move |known| (*known, *corner)));
        let Some((from, to)) = pairs.min_by(|a, b| apart(a.0, a.1).total_cmp(&apart(b.0, b.1))) else { break };
        bars.extend([from, to]);
        joined.push(to);
    }
    bars
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_a_square_leaves_its_middle_out() {
        let points = [(0.0, 0.0), (2.0, 0.0), (1.0, 1.0), (2.0, 2.0), (0.0, 2.0)];
        let mut found = hull(&points);
        found.sort_unstable();
        assert_eq!(found, [0, 1, 3, 4]);
        assert!(width(&[points[0], points[1], points[3], points[4]]) > 0.2);
    }

    #[test]
    fn three_corners_of_a_line_are_two_bars() {
        let places = vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
        assert_eq!(spanning(&Instant { places, ..Instant::default() }, &[0, 1, 2]), [0, 2, 2, 1]);
    }
}
