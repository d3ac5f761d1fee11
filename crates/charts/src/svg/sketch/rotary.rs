//! Elements about an axis: torsion springs as spirals, rotary dashpots as a vane in a housing, torques as curved arrows.

use super::camera::{Camera, cross, dot, unit};
use super::marks::{polyline, segments};
use super::pose::{Flat, Pose};
use super::shapes::{Scene, Shape};
use super::{Instant, SketchPart};
use std::f64::consts::{PI, TAU};

/// The radii of the ends of a spiral in pixels; [`TURNS`] is its number of turns.
const SPIRAL: (f64, f64) = (4.5, 15.0);
const TURNS: f64 = 2.0;
/// The radius of a housing and the radii of the ends of a vane, in pixels; [`ABOUT_SPRING`] applies about a torsion spring.
const ALONE: [f64; 3] = [13.0, 4.0, 10.0];
const ABOUT_SPRING: [f64; 3] = [21.0, 16.5, 20.0];
/// Half the angle of the gap of a housing, in radians.
const GAP: f64 = 0.6;
/// The radius of a curved arrow in pixels; [`SWEEP`] is its angle in radians and [`HEAD`] the length of its head in pixels.
const ARC: f64 = 24.0;
const SWEEP: f64 = 1.4 * PI;
const HEAD: f64 = 8.0;
/// The number of points of a spiral, and of an arc ([`OF_ARC`]). It is constant, so that the path of one instant can turn into the next.
const POINTS: usize = 44;
const OF_ARC: usize = 20;

/// A circle about a point in the plane normal to an axis.
struct Circle {
    centre: [f64; 3],
    /// Two orthogonal unit vectors of its plane.
    axes: [[f64; 3]; 2],
    /// The factor of all radii, smaller in sketches with many parts.
    size: f64,
}

impl Circle {
    /// The projection of the point at this radius in pixels and this angle in radians.
    fn point(&self, camera: &Camera, radius: f64, angle: f64) -> Flat {
        let (sin, cos) = angle.sin_cos();
        let r = self.size * radius / camera.scale;
        camera.place(std::array::from_fn(|k| self.centre[k] + r * (cos * self.axes[0][k] + sin * self.axes[1][k])))
    }

    /// The projections of points of an arc whose radius in pixels and angle in radians change linearly.
    fn arc(&self, camera: &Camera, count: usize, radii: (f64, f64), angles: (f64, f64)) -> Vec<Flat> {
        let at = |k: usize| {
            let share = k as f64 / count as f64;
            self.point(camera, radii.0 + share * (radii.1 - radii.0), angles.0 + share * (angles.1 - angles.0))
        };
        (0..=count).map(at).collect()
    }
}

/// The circle of each instant, with the angle in radians from the first direction to `arm`, continued without jumps of whole turns.
fn circles(scene: Scene<'_>, at: usize, [first, second, arm]: [usize; 3]) -> Vec<(Circle, f64)> {
    let (mut last, size) = (0.0, scene.mark_size());
    let one = |instant: &Instant| {
        let direction = |number: usize| unit(Scene::direction(instant, number)).unwrap_or([1.0, 0.0, 0.0]);
        let axes = [direction(first), direction(second)];
        let arm = direction(arm);
        let angle = dot(arm, axes[1]).atan2(dot(arm, axes[0]));
        last += (angle - last + PI).rem_euclid(TAU) - PI;
        (Circle { centre: instant.places.get(at).copied().unwrap_or_default(), axes, size }, last)
    };
    scene.sketch.instants.iter().map(one).collect()
}

/// A spiral whose inner end is fixed in the second frame and whose outer end is fixed in the first.
pub(super) fn torsion_spring(scene: Scene<'_>, at: usize, axes: [usize; 3]) -> Shape {
    let spiral = |(circle, angle): (Circle, f64)| circle.arc(scene.camera, POINTS, SPIRAL, (angle, TURNS * TAU));
    let points: Vec<Vec<Flat>> = circles(scene, at, axes).into_iter().map(spiral).collect();
    Shape::new(6, "spring", Pose::through(&points, polyline))
}

/// A housing fixed in the first frame, and a vane fixed in the second.
pub(super) fn rotary_dashpot(scene: Scene<'_>, at: usize, axes: [usize; 3]) -> Vec<Shape> {
    let is_about = |part: &SketchPart| matches!(part, SketchPart::TorsionSpring { at: other, .. } if *other == at);
    let [housing, from, to] = if scene.sketch.parts.iter().any(is_about) { ABOUT_SPRING } else { ALONE };
    let (mut housings, mut vanes) = (Vec::new(), Vec::new());
    for (circle, angle) in circles(scene, at, axes) {
        housings.push(circle.arc(scene.camera, OF_ARC, (housing, housing), (GAP, TAU - GAP)));
        let point = |radius: f64, turn: f64| circle.point(scene.camera, radius, angle + turn);
        vanes.push([0.0, PI].iter().flat_map(|turn| [point(from, *turn), point(to, *turn)]).collect());
    }
    let shape =
        |points: &[Vec<Flat>], path: &dyn Fn(&[Flat]) -> String| Shape::new(6, "dashpot", Pose::through(points, path));
    vec![shape(&housings, &polyline), shape(&vanes, &segments)]
}

/// A curved arrow about a torque by the right-hand rule; an empty path where the torque is zero.
pub(super) fn torque(scene: Scene<'_>, at: usize, along: usize) -> Shape {
    let arrow = |instant: &Instant| {
        let Some(axis) = unit(Scene::direction(instant, along)) else { return Vec::new() };
        let right = scene.camera.right();
        // the arc lies on the side of the axis that faces the viewer
        let first = unit(cross(axis, scene.camera.towards())).unwrap_or(right);
        let centre = instant.places.get(at).copied().unwrap_or_default();
        let circle = Circle { centre, axes: [first, cross(axis, first)], size: scene.mark_size() };
        let ends = (0.5 * (PI - SWEEP), 0.5 * (PI + SWEEP));
        let mut points = circle.arc(scene.camera, OF_ARC, (ARC, ARC), ends);
        let barb = |out: f64| circle.point(scene.camera, ARC + out * 0.5 * HEAD, ends.1 - HEAD / ARC);
        let tip = circle.point(scene.camera, ARC, ends.1);
        points.extend([barb(1.0), tip, barb(-1.0)]);
        points
    };
    let points = scene.each(arrow);
    let path = |points: &[Flat]| if points.is_empty() { String::new() } else { polyline(points) };
    let pose = match points.iter().any(Vec::is_empty) {
        true if points.iter().any(|points| !points.is_empty()) => {
            Pose::Bent(points.iter().map(|all| path(all)).collect())
        }
        _ => Pose::through(&points, path),
    };
    Shape::new(9, "force", pose)
}
