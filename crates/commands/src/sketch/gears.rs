//! Gears in a sketch, as two circles in contact, and belts, as two circles with a band.

use super::bodies::ring;
use super::parts::Parts;
use ::scenes::geometry::{Figure, GearPair, GearWheel};
use charts::SketchPart;
use nalgebra::Vector3;

/// Draws all gears and belts; returns the bodies whose circles are drawn.
pub fn draw(parts: &mut Parts<'_>) -> Vec<usize> {
    let geometry = parts.geometry;
    let mut geared = Vec::new();
    for GearPair { wheels, is_belt } in &geometry.gears {
        for wheel in wheels {
            let is_of = |body: &usize| {
                let frame = geometry.model.bodies[*body].frame.map(|frame| frame.0);
                geometry.centre(*body) == Some(wheel.centre)
                    && frame.is_some_and(|own| geometry.turn_together(own, wheel.frame))
            };
            let body = (0..geometry.model.bodies.len()).find(is_of);
            circle(parts, *wheel, body.unwrap_or(geared.len()));
            geared.extend(body);
        }
        if *is_belt {
            [1.0, -1.0].into_iter().for_each(|side| strand(parts, *wheels, side));
        }
    }
    geared
}

fn circle(parts: &mut Parts<'_>, GearWheel { centre, radius, frame, axis }: GearWheel, colour: usize) {
    let mut half = |k: usize| parts.direction(move |figure| radius * figure.frames[frame][k]);
    let axes = [half(0), half(1), half(2)];
    ring(parts, centre, axes, axis, (colour, true));
}

/// Draws a straight part of a belt, an outer common tangent of both circles, on the side `side` (1 or -1).
fn strand(parts: &mut Parts<'_>, wheels: [GearWheel; 2], side: f64) {
    let normal = move |figure: &Figure| -> Vector3<f64> {
        let [first, second] = wheels;
        let way = figure.places[second.centre] - figure.places[first.centre];
        let share = (first.radius - second.radius) / way.norm();
        let across = figure.frames[first.frame][first.axis].cross(&way).normalize();
        share * way.normalize() + side * (1.0 - share * share).max(0.0).sqrt() * across
    };
    let ends =
        wheels.map(|wheel| parts.place(move |figure| figure.places[wheel.centre] + wheel.radius * normal(figure)));
    parts.add(SketchPart::Strand(ends));
}
