//! Sample points of everything drawn, by which names avoid covering strokes, and the bounding boxes of names.

use super::camera::Camera;
use super::pose::Flat;
use super::surfaces::BEYOND;
use super::{Instant, Sketch, SketchPart};

/// A box in pixels: left, top, right, bottom.
pub(super) type Box4 = [f64; 4];

/// Sample points of the strokes at one instant, a few pixels apart.
pub(super) fn ink(sketch: &Sketch, instant: &Instant, camera: &Camera) -> Vec<Flat> {
    let mut points = Vec::new();
    for part in sketch.parts.iter().filter(|part| !matches!(part, SketchPart::Field(_))) {
        let stands: Vec<Flat> = part
            .stands_at()
            .iter()
            .filter_map(|place| instant.places.get(*place))
            .map(|place| camera.place(*place))
            .collect();
        points.extend(&stands);
        for pair in stands.windows(2) {
            points.extend(along(pair[0], pair[1]));
        }
        let directions = |numbers: &[usize]| -> Vec<[f64; 3]> {
            numbers.iter().filter_map(|number| instant.directions.get(*number).copied()).collect()
        };
        let Some(&(x, y)) = stands.first() else { continue };
        match part {
            SketchPart::Triad { axes, .. } => {
                let ends = directions(axes).into_iter().map(|axis| camera.along(axis));
                points.extend(ends.flat_map(|(right, down)| along((x, y), (x + right, y + down))));
            }
            SketchPart::Ring { axes, .. } => {
                let axes: Vec<Flat> = directions(axes).into_iter().map(|axis| camera.along(axis)).collect();
                let &[a, b] = axes.as_slice() else { continue };
                points.extend((0..36).map(|k| {
                    let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 36.0).sin_cos();
                    (x + cos * a.0 + sin * b.0, y + cos * a.1 + sin * b.1)
                }));
            }
            SketchPart::Surface { normal, .. } => {
                let normal = instant.directions.get(*normal).copied().unwrap_or_default();
                let (right, down) = camera.share(normal);
                let end = |side: f64| (x - side * BEYOND * down, y + side * BEYOND * right);
                points.extend(along(end(-1.0), end(1.0)));
            }
            SketchPart::Support(_) => {
                points.extend([(-9.0, 15.0), (9.0, 15.0), (0.0, 12.0)].map(|(a, b)| (x + a, y + b)))
            }
            SketchPart::Block { .. } => {
                points.extend([(-14.0, -8.0), (14.0, -8.0), (-14.0, 8.0), (14.0, 8.0)].map(|(a, b)| (x + a, y + b)))
            }
            SketchPart::TorsionSpring { .. } | SketchPart::RotaryDashpot { .. } => points.extend(ring((x, y), 15.0)),
            SketchPart::Torque { .. } => points.extend(ring((x, y), 24.0)),
            _ => {}
        }
    }
    points
}

/// 36 points of a circle.
fn ring((x, y): Flat, radius: f64) -> impl Iterator<Item = Flat> {
    (0..36).map(move |k| {
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 36.0).sin_cos();
        (x + radius * cos, y + radius * sin)
    })
}

/// Points of a segment, at most 5 pixels apart.
fn along(from: Flat, to: Flat) -> impl Iterator<Item = Flat> {
    let count = ((to.0 - from.0).hypot(to.1 - from.1) / 5.0).ceil().clamp(1.0, 400.0) as usize;
    (0..=count).map(move |k| {
        let share = k as f64 / count as f64;
        (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1))
    })
}

pub(super) fn holds(rim: &Box4, (x, y): Flat) -> bool {
    rim[0] - 1.0 < x && x < rim[2] + 1.0 && rim[1] - 1.0 < y && y < rim[3] + 1.0
}

pub(super) fn meets(one: &Box4, other: &Box4) -> bool {
    one[0] < other[2] + 2.0 && other[0] < one[2] + 2.0 && one[1] < other[3] + 2.0 && other[1] < one[3] + 2.0
}
