//! The parts of a mechanism as paths, sorted from back to front.

use super::bars::{ACTUATOR, DASHPOT, DASHPOT_BESIDE, SPRING};
use super::camera::{Camera, arrow};
use super::marks::{block, circle, ellipse, polyline, quarters, segments, support};
use super::plates;
use super::pose::{Flat, Pose};
use super::rotary::{rotary_dashpot, torque, torsion_spring};
use super::surfaces::{guide, surface};
use super::timeline::Timeline;
use super::{Instant, Sketch, SketchPart};
use crate::svg::drawing::Drawing;

/// The number of colours of bodies; further bodies repeat them.
const COLOURS: usize = 6;
/// Half the width of the marks of a mass, a pin and a centre of mass, in pixels.
const MASS: f64 = 6.5;
const PIN: f64 = 3.6;
const CENTRE: f64 = 5.5;
/// The number of parts above which marks are smaller; [`LEAST`] is their least relative size.
const MANY: f64 = 60.0;
const LEAST: f64 = 0.3;
/// The length of an arrow in pixels.
const ARROW: f64 = 44.0;

/// A path with its layer, its CSS class and its motion.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    layer: u8,
    class: String,
    pub pose: Pose,
}

impl Shape {
    pub fn new(layer: u8, class: impl Into<String>, pose: Pose) -> Self {
        Shape { layer, class: class.into(), pose }
    }

    pub fn draw(&self, drawing: &mut Drawing, timeline: &Timeline) {
        self.pose.draw(drawing, &self.class, timeline);
    }
}

/// A sketch and its projection.
#[derive(Clone, Copy)]
pub(super) struct Scene<'a> {
    pub sketch: &'a Sketch,
    pub camera: &'a Camera,
}

impl Scene<'_> {
    /// The projection of a point at an instant.
    pub fn at(&self, instant: &Instant, place: usize) -> Flat {
        instant.places.get(place).map_or((0.0, 0.0), |place| self.camera.place(*place))
    }

    /// The values of a function at all instants.
    pub fn each<T>(&self, of: impl Fn(&Instant) -> T) -> Vec<T> {
        self.sketch.instants.iter().map(of).collect()
    }

    /// The components of a direction at an instant; zero for an unknown index.
    pub fn direction(instant: &Instant, number: usize) -> [f64; 3] {
        instant.directions.get(number).copied().unwrap_or_default()
    }

    /// The relative size of marks, between [`LEAST`] and 1: smaller in sketches with many parts.
    pub fn mark_size(&self) -> f64 {
        (MANY / self.sketch.parts.len().max(1) as f64).clamp(LEAST, 1.0)
    }

    fn mark(&self, place: usize, path: impl Fn(Flat) -> String) -> Pose {
        Pose::through(&self.each(|instant| vec![self.at(instant, place)]), |points| path(points[0]))
    }

    fn line(&self, ends: [usize; 2]) -> Pose {
        Pose::through(&self.each(|instant| ends.map(|end| self.at(instant, end)).to_vec()), polyline)
    }

    fn bar(&self, ends: [usize; 2], path: &str) -> Pose {
        Pose::between(&self.each(|instant| ends.map(|end| self.at(instant, end))), path)
    }

    /// The path that `path` returns for a point and a second point at a distance of [`ARROW`] in a given direction.
    fn towards(&self, place: usize, along: usize, path: impl Fn(Flat, Flat) -> String) -> Pose {
        let points = self.each(|instant| {
            let (from, way) = (self.at(instant, place), self.camera.share(Scene::direction(instant, along)));
            vec![from, (from.0 + ARROW * way.0, from.1 + ARROW * way.1)]
        });
        Pose::through(&points, |points| path(points[0], points[1]))
    }
}

/// The paths of all parts of a sketch, from back to front.
pub(super) fn shapes(sketch: &Sketch, camera: &Camera) -> Vec<Shape> {
    let scene = Scene { sketch, camera };
    let mut all: Vec<Shape> = sketch.parts.iter().flat_map(|part| strokes(scene, part)).collect();
    all.sort_by_key(|shape| shape.layer);
    all
}

fn strokes(scene: Scene<'_>, part: &SketchPart) -> Vec<Shape> {
    let size = scene.mark_size();
    let coloured = |class: &str, colour: usize| format!("{class} b{}", colour % COLOURS);
    match part {
        SketchPart::Plate { corners, colour } => plates::plate(scene, corners, &coloured("", *colour)),
        SketchPart::Rod(ends) => vec![Shape::new(3, "rod", scene.line(*ends))],
        SketchPart::Strand(ends) => vec![Shape::new(1, "strand", scene.line(*ends))],
        SketchPart::Telescope(ends) => vec![Shape::new(3, "telescope", scene.line(*ends))],
        SketchPart::Spring(ends) => vec![Shape::new(4, "spring", scene.bar(*ends, SPRING))],
        SketchPart::Dashpot(ends) => {
            let has_spring = scene.sketch.parts.contains(&SketchPart::Spring(*ends));
            vec![Shape::new(4, "dashpot", scene.bar(*ends, if has_spring { DASHPOT_BESIDE } else { DASHPOT }))]
        }
        SketchPart::Actuator(ends) => vec![Shape::new(4, "force", scene.bar(*ends, ACTUATOR))],
        SketchPart::Field(ends) => vec![Shape::new(0, "field", scene.line(*ends))],
        SketchPart::Particle { at, colour } => {
            vec![Shape::new(7, coloured("mass", *colour), scene.mark(*at, |at| circle(at, size * MASS)))]
        }
        SketchPart::Centre(at) => vec![
            Shape::new(6, "centre", scene.mark(*at, |at| circle(at, size * CENTRE))),
            Shape::new(6, "quarters", scene.mark(*at, |at| quarters(at, size * CENTRE))),
        ],
        SketchPart::Pin(at) => vec![Shape::new(8, "pin", scene.mark(*at, |at| circle(at, size * PIN)))],
        SketchPart::Support(at) => vec![Shape::new(1, "surface", scene.mark(*at, support))],
        SketchPart::Block { at, along, colour } => {
            let path = |from: Flat, to: Flat| block(from, (to.0 - from.0, to.1 - from.1));
            vec![Shape::new(5, coloured("block", *colour), scene.towards(*at, *along, path))]
        }
        SketchPart::Guide { at, along } => vec![Shape::new(0, "guide", guide(scene, *at, *along))],
        SketchPart::Ring { at, axes, colour, spoke } => {
            let points = scene.each(|instant| {
                let place = instant.places.get(*at).copied().unwrap_or_default();
                let end = |axis: usize| {
                    let axis = Scene::direction(instant, axis);
                    scene.camera.place(std::array::from_fn(|k| place[k] + axis[k]))
                };
                vec![scene.camera.place(place), end(axes[0]), end(axes[1])]
            });
            let path = |points: &[Flat]| ellipse(points[0], points[1], points[2]);
            let class = if *spoke { "disc" } else { "curve" };
            let mut strokes = vec![Shape::new(2, coloured(class, *colour), Pose::through(&points, path))];
            if *spoke {
                let path = |points: &[Flat]| polyline(&points[..2]);
                strokes.push(Shape::new(2, coloured("curve", *colour), Pose::through(&points, path)));
            }
            strokes
        }
        SketchPart::Triad { at, axes, colour } => {
            let of_axis = |axis: usize| {
                let points = scene.each(|instant| {
                    let place = instant.places.get(*at).copied().unwrap_or_default();
                    let axis = Scene::direction(instant, axis);
                    vec![scene.camera.place(place), scene.camera.place(std::array::from_fn(|k| place[k] + axis[k]))]
                });
                Pose::through(&points, |points| arrow(points[0], points[1], 6.0))
            };
            axes.iter().map(|axis| Shape::new(6, coloured("triad", *colour), of_axis(*axis))).collect()
        }
        SketchPart::Surface { at, normal, kind } => surface(scene, *at, *normal, *kind),
        SketchPart::TorsionSpring { at, axes } => vec![torsion_spring(scene, *at, *axes)],
        SketchPart::RotaryDashpot { at, axes } => rotary_dashpot(scene, *at, *axes),
        SketchPart::Torque { at, along } => vec![torque(scene, *at, *along)],
        SketchPart::Arrow { at, along } => {
            vec![Shape::new(9, "force", scene.towards(*at, *along, |from, to| arrow(from, to, 8.0)))]
        }
    }
}

/// Segments between pairs of points, over all instants.
pub(super) fn segments_between(scene: Scene<'_>, ends: &[usize]) -> Pose {
    Pose::through(&scene.each(|instant| ends.iter().map(|end| scene.at(instant, *end)).collect()), segments)
}
