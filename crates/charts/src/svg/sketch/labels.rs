//! Labels: each name is placed on the first side of its point where it covers nothing, and left out if there is no such side.

use super::camera::Camera;
use super::pose::Flat;
use super::surfaces::BEYOND;
use super::timeline::Timeline;
use super::{Instant, Sketch, SketchPart};
use crate::svg::drawing::{Anchor, Drawing, WIDTH};
use crate::svg::number::coordinate;

/// The width of a letter, and the height of a line, in pixels.
const LETTER: f64 = 7.4;
const HEIGHT: f64 = 14.0;
/// The largest number of names.
const MOST: usize = 40;
const FEW: usize = 16;
/// The largest number of letters of a name.
const LONGEST: usize = 24;

/// A box on the paper: left, top, right, bottom.
type Box4 = [f64; 4];

/// Names with their sides.
pub(super) struct Labels {
    placed: Vec<Label>,
}

struct Label {
    text: String,
    /// The vector from its point to the left end of its base line.
    beside: Flat,
    places: Vec<Flat>,
}

impl Labels {
    /// The labels of a sketch; their sides are chosen at the first instant.
    pub fn of(sketch: &Sketch, camera: &Camera, first: &Instant) -> Self {
        let at = |instant: &Instant, place: usize| instant.places.get(place).map(|place| camera.place(*place));
        let ink = ink(sketch, first, camera);
        let mut taken: Vec<Box4> = Vec::new();
        let mut placed = Vec::new();
        let count = sketch.names.len();
        let step = if count > MOST { count.div_ceil(FEW) } else { 1 };
        for (place, name) in sketch.names.iter().step_by(step) {
            let Some(here) = at(first, *place) else { continue };
            let text = crate::svg::drawing::shorten(name, LONGEST);
            let width = LETTER * text.chars().count() as f64;
            let side = |(right, down): &(f64, f64)| -> (Flat, Box4) {
                let left = match *right {
                    right if right > 0.0 => right,
                    right if right < 0.0 => right - width,
                    _ => -0.5 * width,
                };
                let base = down + 0.36 * HEIGHT;
                let place = (here.0 + left, here.1 + base);
                ((left, base), [place.0, place.1 - 0.8 * HEIGHT, place.0 + width, place.1 + 0.2 * HEIGHT])
            };
            let cost = |rim: &Box4| -> usize {
                let beyond = rim[0] < 2.0 || rim[2] > WIDTH - 2.0 || rim[1] < 2.0 || rim[3] > camera.height + 4.0;
                let covered = ink.iter().filter(|point| holds(rim, **point)).count();
                let names = taken.iter().filter(|other| meets(rim, other)).count();
                covered + 1000 * names + if beyond { 500 } else { 0 }
            };
            let sides: Vec<(Flat, Box4)> = SIDES.iter().map(side).collect();
            let best = sides.into_iter().enumerate().min_by_key(|(order, (_, rim))| (cost(rim), *order));
            let Some((_, (beside, rim))) = best.filter(|(_, (_, rim))| cost(rim) < 500) else { continue };
            taken.push(rim);
            let places = sketch.instants.iter().filter_map(|instant| at(instant, *place)).collect();
            placed.push(Label { text, beside, places });
        }
        Labels { placed }
    }

    pub fn draw(&self, drawing: &mut Drawing, timeline: &Timeline) {
        for Label { text, beside, places } in &self.placed {
            let Some(first) = places.first() else { continue };
            let rests = places.iter().all(|place| (place.0 - first.0).hypot(place.1 - first.1) < 0.35);
            if rests {
                drawing.text((first.0 + beside.0, first.1 + beside.1), Anchor::Start, "name", text);
                continue;
            }
            let values: Vec<String> =
                places.iter().map(|(x, y)| format!("{} {}", coordinate(*x), coordinate(*y))).collect();
            let start = format!(" transform=\"translate({})\"", values[0]);
            drawing.text_with(*beside, "name", text, &start, &timeline.transform("translate", &values));
        }
    }
}

/// Sides, to the right and down from a point, the best first.
const SIDES: [(f64, f64); 12] = [
    (10.0, 0.0),
    (9.0, -11.0),
    (9.0, 12.0),
    (-10.0, 0.0),
    (-9.0, -11.0),
    (-9.0, 12.0),
    (0.0, -17.0),
    (0.0, 19.0),
    (20.0, -20.0),
    (20.0, 22.0),
    (-20.0, -20.0),
    (-20.0, 22.0),
];

/// Points that strokes cover, some pixels apart.
fn ink(sketch: &Sketch, first: &Instant, camera: &Camera) -> Vec<Flat> {
    let mut points = Vec::new();
    for part in sketch.parts.iter().filter(|part| !matches!(part, SketchPart::Field(_))) {
        let stands: Vec<Flat> = part
            .stands_at()
            .iter()
            .filter_map(|place| first.places.get(*place))
            .map(|place| camera.place(*place))
            .collect();
        points.extend(&stands);
        for pair in stands.windows(2) {
            points.extend(along(pair[0], pair[1]));
        }
        let directions = |numbers: &[usize]| -> Vec<[f64; 3]> {
            numbers.iter().filter_map(|number| first.directions.get(*number).copied()).collect()
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
                let normal = first.directions.get(*normal).copied().unwrap_or_default();
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
            _ => {}
        }
    }
    points
}

/// Points of a segment.
fn along(from: Flat, to: Flat) -> impl Iterator<Item = Flat> {
    let count = ((to.0 - from.0).hypot(to.1 - from.1) / 5.0).ceil().clamp(1.0, 400.0) as usize;
    (0..=count).map(move |k| {
        let share = k as f64 / count as f64;
        (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1))
    })
}

fn holds(rim: &Box4, (x, y): Flat) -> bool {
    rim[0] - 1.0 < x && x < rim[2] + 1.0 && rim[1] - 1.0 < y && y < rim[3] + 1.0
}

fn meets(one: &Box4, other: &Box4) -> bool {
    one[0] < other[2] && other[0] < one[2] && one[1] < other[3] && other[1] < one[3]
}
