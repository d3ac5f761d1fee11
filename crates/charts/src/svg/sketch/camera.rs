//! The parallel projection of a mechanism onto the picture.

use super::Sketch;
use super::extent::Extent;
use crate::svg::drawing::WIDTH;

/// A direction of view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The direction from the mechanism to the viewer, a vector of any length.
    pub towards: [f64; 3],
    /// The direction whose projection points upwards in the picture.
    pub up: [f64; 3],
}

impl Default for View {
    /// The view along the axis z, with y upwards.
    fn default() -> Self {
        View { towards: [0.0, 0.0, 1.0], up: [0.0, 1.0, 0.0] }
    }
}

/// A parallel projection with its scale, from metres to pixels.
#[derive(Clone, Debug)]
pub(super) struct Camera {
    /// The unit vectors to the right, upwards, and towards the viewer.
    right: [f64; 3],
    up: [f64; 3],
    towards: [f64; 3],
    /// Pixels per metre.
    pub scale: f64,
    /// The coordinates of the middle of the picture, to the right and upwards, in metres.
    middle: (f64, f64),
    /// The height of the picture in pixels.
    pub height: f64,
}

/// The largest width and height of the mechanism, in pixels.
const ROOM: (f64, f64) = (WIDTH - 130.0, 300.0);
/// The fraction of `ROOM` that the mechanism fills in a picture without a scale.
const SCHEMATIC: f64 = 0.55;
/// The margin above and below, in pixels.
const MARGIN: f64 = 48.0;
/// The least height of the picture, in pixels.
const LEAST: f64 = 120.0;

impl Camera {
    pub fn of(sketch: &Sketch) -> Self {
        let towards = unit(sketch.view.towards).unwrap_or([0.0, 0.0, 1.0]);
        let candidates = [sketch.view.up, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
        let across = |up: [f64; 3]| unit(cross(up, towards)).filter(|_| unit(up).is_some());
        let right = candidates.into_iter().find_map(across).unwrap_or([1.0, 0.0, 0.0]);
        let up = cross(towards, right);
        let mut camera = Camera { right, up, towards, scale: 1.0, middle: (0.0, 0.0), height: LEAST };
        let extent = Extent::of(sketch, |place| camera.flat(place));
        let (width, height) = extent.size();
        let least = f64::MIN_POSITIVE.sqrt();
        let part = if sketch.has_scale { 1.0 } else { SCHEMATIC };
        camera.scale = part * (ROOM.0 / width.max(least)).min(ROOM.1 / height.max(least));
        camera.middle = extent.middle();
        camera.height = (height * camera.scale + 2.0 * MARGIN).clamp(LEAST, ROOM.1 + 2.0 * MARGIN).round();
        camera
    }

    /// The projection of a point, in metres to the right and upwards.
    fn flat(&self, place: [f64; 3]) -> (f64, f64) {
        (dot(self.right, place), dot(self.up, place))
    }

    /// The projection of a point, in pixels.
    pub fn place(&self, place: [f64; 3]) -> (f64, f64) {
        let (x, y) = self.flat(place);
        (0.5 * WIDTH + self.scale * (x - self.middle.0), 0.5 * self.height - self.scale * (y - self.middle.1))
    }

    /// The projection of a vector, in pixels.
    pub fn along(&self, direction: [f64; 3]) -> (f64, f64) {
        let (x, y) = self.flat(direction);
        (self.scale * x, -self.scale * y)
    }

    /// The projection of the unit vector of a direction, to the right and downwards.
    pub fn share(&self, direction: [f64; 3]) -> (f64, f64) {
        let (x, y) = self.flat(unit(direction).unwrap_or_default());
        (x, -y)
    }

    /// The unit vector in space that points to the right in the picture.
    pub fn right(&self) -> [f64; 3] {
        self.right
    }

    /// The unit vector from the mechanism to the viewer.
    pub fn towards(&self) -> [f64; 3] {
        self.towards
    }

    /// The component towards the viewer of the unit vector of a direction.
    pub fn depth(&self, direction: [f64; 3]) -> f64 {
        dot(self.towards, unit(direction).unwrap_or_default())
    }
}

/// The SVG path of an arrow: its shaft and two strokes of its head.
pub(super) fn arrow((x, y): (f64, f64), (to_x, to_y): (f64, f64), head: f64) -> String {
    use crate::svg::number::coordinate as n;
    let (along, down) = (to_x - x, to_y - y);
    let length = along.hypot(down);
    if length == 0.0 {
        return String::new();
    }
    let (along, down) = (along / length, down / length);
    let barb = |side: f64| (to_x - head * (along - 0.5 * side * down), to_y - head * (down + 0.5 * side * along));
    let (left, right) = (barb(1.0), barb(-1.0));
    let point = |(x, y): (f64, f64)| format!("{} {}", n(x), n(y));
    format!("M{}L{}M{}L{}L{}", point((x, y)), point((to_x, to_y)), point(left), point((to_x, to_y)), point(right))
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The unit vector of a direction; `None` for the zero vector.
pub(super) fn unit(direction: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(direction, direction).sqrt();
    (length > 1e-9 && length.is_finite()).then(|| direction.map(|part| part / length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::svg::sketch::Instant;

    #[test]
    fn the_scale_is_one_along_all_directions_and_the_middle_stands_in_the_middle() {
        let places = vec![[0.0, 0.0, 0.0], [2.0, 1.0, 0.0]];
        let instants = vec![Instant { places, ..Instant::default() }];
        let parts = vec![super::super::SketchPart::Rod([0, 1])];
        let camera = Camera::of(&Sketch { instants, parts, ..Sketch::default() });
        let (a, b) = (camera.place([0.0; 3]), camera.place([2.0, 1.0, 0.0]));
        assert!((a.0 + b.0 - WIDTH).abs() < 1e-9 && (a.1 + b.1 - camera.height).abs() < 1e-9);
        assert!(b.0 > a.0 && b.1 < a.1 && ((b.0 - a.0) - 2.0 * (a.1 - b.1)).abs() < 1e-9);
    }

    #[test]
    fn a_view_along_its_own_upright_has_another_upright() {
        let view = View { towards: [0.0, 0.0, 1.0], up: [0.0, 0.0, 1.0] };
        let camera = Camera::of(&Sketch { view, instants: vec![Instant::default()], ..Sketch::default() });
        assert!(dot(camera.right, camera.up).abs() < 1e-12 && dot(camera.up, camera.up) > 0.99);
    }
}
