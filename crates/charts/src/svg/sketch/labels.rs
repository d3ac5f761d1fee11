//! Names next to the points of a sketch. Each name has one position relative to its point, chosen such that it covers least over the whole motion;
//! a name that is farther away is joined to its point by a line. A name is left out where every position is taken.

use super::camera::Camera;
use super::ink::{Box4, holds, ink, meets};
use super::marks::polyline;
use super::pose::Flat;
use super::timeline::Timeline;
use super::{Instant, Sketch};
use crate::svg::drawing::{Anchor, Drawing, WIDTH};
use crate::svg::number::coordinate;

/// The width of a letter in pixels; [`HEIGHT`] is the height of a line.
const LETTER: f64 = 7.9;
const HEIGHT: f64 = 14.0;
/// The largest number of names.
const MOST: usize = 40;
const FEW: usize = 16;
/// The largest number of letters of a name.
const LONGEST: usize = 24;
/// The number of instants at which the cost of a position is computed.
const INSTANTS: usize = 6;
/// The cost of a covered sample point of a stroke; [`LINE`]: of a line to a name; [`BEYOND`]: outside the picture; [`TAKEN`]: over a name.
const COVERED: usize = 4;
const LINE: usize = 10;
const BEYOND: usize = 2_000;
const TAKEN: usize = 10_000;

/// The names of a sketch with their positions.
pub(super) struct Labels {
    placed: Vec<Label>,
}

struct Label {
    text: String,
    /// The vector from the point to the left end of the base line of the text, in pixels.
    beside: Flat,
    /// The ends of the line from the point to the name; `None` for a name that is close.
    line: Option<[Flat; 2]>,
    places: Vec<Flat>,
}

/// A candidate position of a name relative to its point.
struct Side {
    beside: Flat,
    /// The box of the name relative to its point.
    rim: Box4,
    line: Option<[Flat; 2]>,
}

impl Side {
    /// The position in a direction (right, down) at a distance, for a name of this width; all in pixels.
    fn of((right, down): (f64, f64), distance: f64, width: f64) -> Self {
        let (x, y) = (distance * right, distance * down);
        let left = match right {
            right if right > 0.1 => x,
            right if right < -0.1 => x - width,
            _ => x - 0.5 * width,
        };
        let base = y + 0.36 * HEIGHT;
        let rim = [left, base - 0.8 * HEIGHT, left + width, base + 0.2 * HEIGHT];
        let line = (distance > CLOSE).then_some([(6.0 * right, 6.0 * down), (x - 2.0 * right, y - 2.0 * down)]);
        Side { beside: (left, base), rim, line }
    }

    fn rim_at(&self, (x, y): Flat) -> Box4 {
        [self.rim[0] + x, self.rim[1] + y, self.rim[2] + x, self.rim[3] + y]
    }
}

impl Labels {
    pub fn of(sketch: &Sketch, camera: &Camera) -> Self {
        let at = |instant: &Instant, place: usize| instant.places.get(place).map(|place| camera.place(*place));
        let every = sketch.instants.len().div_ceil(INSTANTS).max(1);
        let instants: Vec<&Instant> = sketch.instants.iter().step_by(every).collect();
        let inks: Vec<Vec<Flat>> = instants.iter().map(|instant| ink(sketch, instant, camera)).collect();
        let mut taken: Vec<Vec<Box4>> = vec![Vec::new(); instants.len()];
        let mut placed = Vec::new();
        let count = sketch.names.len();
        let step = if count > MOST { count.div_ceil(FEW) } else { 1 };
        for (place, name) in sketch.names.iter().step_by(step) {
            let here: Option<Vec<Flat>> = instants.iter().map(|instant| at(instant, *place)).collect();
            let Some(here) = here else { continue };
            let text = crate::svg::drawing::shorten(name, LONGEST);
            let width = LETTER * text.chars().count() as f64;
            let cost_at = |side: &Side, number: usize| {
                let rim = side.rim_at(here[number]);
                let beyond = rim[0] < 2.0 || rim[2] > WIDTH - 2.0 || rim[1] < 2.0 || rim[3] > camera.height + 4.0;
                let covered = inks[number].iter().filter(|point| holds(&rim, **point)).count();
                let names = taken[number].iter().filter(|other| meets(&rim, other)).count();
                COVERED * covered + TAKEN * names + if beyond { BEYOND } else { 0 }
            };
            let cost = |side: &Side| -> usize {
                let line = if side.line.is_some() { LINE * instants.len() } else { 0 };
                line + (0..instants.len()).map(|number| cost_at(side, number)).sum::<usize>()
            };
            let sides = DISTANCES.iter().flat_map(|distance| SIDES.map(|side| Side::of(side, *distance, width)));
            let best =
                sides.enumerate().map(|(order, side)| (cost(&side), order, side)).min_by_key(|one| (one.0, one.1));
            // a printed picture shows the first instant, at which the name must lie inside
            let Some((_, _, side)) = best.filter(|(_, _, side)| cost_at(side, 0) < BEYOND) else { continue };
            for (taken, here) in taken.iter_mut().zip(&here) {
                taken.push(side.rim_at(*here));
            }
            let places = sketch.instants.iter().filter_map(|instant| at(instant, *place)).collect();
            placed.push(Label { text, beside: side.beside, line: side.line, places });
        }
        Labels { placed }
    }

    pub fn draw(&self, drawing: &mut Drawing, timeline: &Timeline) {
        for Label { text, beside, line, places } in &self.placed {
            let Some(first) = places.first() else { continue };
            let rests = places.iter().all(|place| (place.0 - first.0).hypot(place.1 - first.1) < 0.35);
            if rests {
                if let Some([from, to]) = line {
                    let end = |point: &Flat| (first.0 + point.0, first.1 + point.1);
                    drawing.line(end(from), end(to), "leader");
                }
                drawing.text((first.0 + beside.0, first.1 + beside.1), Anchor::Start, "name", text);
                continue;
            }
            let values: Vec<String> =
                places.iter().map(|(x, y)| format!("{} {}", coordinate(*x), coordinate(*y))).collect();
            let start = format!(" transform=\"translate({})\"", values[0]);
            let moved = timeline.transform("translate", &values);
            if let Some([from, to]) = line {
                drawing.path_with(&polyline(&[*from, *to]), "leader", &start, &moved);
            }
            drawing.text_with(*beside, "name", text, &start, &moved);
        }
    }
}

/// Directions of candidate positions (right, down), the preferred ones first.
const SIDES: [(f64, f64); 8] =
    [(1.0, 0.0), (0.8, -1.0), (0.8, 1.0), (-1.0, 0.0), (-0.8, -1.0), (-0.8, 1.0), (0.0, -1.5), (0.0, 1.7)];

/// Distances of candidate positions in pixels; beyond [`CLOSE`] a name needs a line.
const DISTANCES: [f64; 4] = [10.5, 17.0, 30.0, 52.0];
const CLOSE: f64 = 20.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::svg::sketch::SketchPart;

    #[test]
    fn names_of_close_places_cover_neither_each_other_nor_the_body() {
        let places = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.05, 0.0, 0.0], [1.1, 0.0, 0.0], [3.0, 0.0, 0.0]];
        let names = ["shoulder_of_the_robot", "elbow_of_the_robot", "wrist_of_the_robot", "finger_of_the_robot", "tip"];
        let sketch = Sketch {
            parts: vec![SketchPart::Plate { corners: vec![0, 1, 2, 3, 4], colour: 0 }],
            names: names.into_iter().enumerate().map(|(place, name)| (place, name.to_owned())).collect(),
            instants: vec![Instant { places, ..Instant::default() }],
            ..Sketch::default()
        };
        let camera = Camera::of(&sketch);
        let labels = Labels::of(&sketch, &camera);
        assert_eq!(labels.placed.len(), names.len());
        let rim = |label: &Label| {
            let (x, y) = (label.places[0].0 + label.beside.0, label.places[0].1 + label.beside.1);
            [x, y - 0.8 * HEIGHT, x + LETTER * label.text.chars().count() as f64, y + 0.2 * HEIGHT]
        };
        let rims: Vec<Box4> = labels.placed.iter().map(rim).collect();
        for (number, one) in rims.iter().enumerate() {
            assert!(rims[..number].iter().all(|other| !meets(one, other)), "{rims:?}");
            let bar = camera.place([0.0; 3]).1;
            assert!(one[1] > bar || one[3] < bar || one[0] > camera.place([3.0, 0.0, 0.0]).0, "{one:?}");
        }
    }
}
