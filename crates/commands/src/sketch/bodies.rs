//! Bodies in a sketch: links through points fixed in them, wheels, sliding blocks, particles, and ellipsoids of inertia.

use super::gears;
use super::parts::Parts;
use ::scenes::geometry::{Ellipsoid, Figure, Wheel};
use charts::SketchPart;
use nalgebra::Vector3;

/// The result of drawing the bodies.
pub struct Drawn {
    /// Whether lengths in the sketch are those of the model.
    pub is_to_scale: bool,
    pub note: &'static str,
}

/// The radius of a body of unknown size, as a fraction of the size of the sketch.
const UNTOLD: f64 = 0.16;

const NOT_TO_SCALE: &str = "The model gives these bodies no places: they are drawn beside each other, not to scale.";
const UNTOLD_SIZE: &str = "The model gives no sizes: bodies have the shape of their moments of inertia.";

pub fn draw(parts: &mut Parts<'_>) -> Drawn {
    let geometry = parts.geometry;
    let mut linked = vec![false; parts.bodies.len()];
    for (number, link) in geometry.links.iter().enumerate() {
        let colour = link.bodies.first().copied().unwrap_or(number);
        parts.add(SketchPart::Plate { corners: link.places.clone(), colour });
        for &body in &link.bodies {
            linked[body] = true;
            let middle = link.places.clone();
            let centre = geometry.centre(body);
            let at = centre.unwrap_or_else(|| parts.place(move |figure| mean(figure, &middle)));
            (parts.bodies[body], parts.middles[body]) = (Some(at), Some(at));
        }
    }
    let geared = gears::draw(parts);
    let mut untold = Vec::new();
    let mut is_to_scale = geometry.size > 0.0;
    for (body, is_linked) in linked.into_iter().enumerate() {
        let model = &geometry.model.bodies[body];
        let centre = geometry.centre(body);
        let wheel = geometry.wheels.iter().find(|wheel| wheel.body == body);
        if let Some(at) = centre {
            (parts.bodies[body], parts.middles[body]) = (Some(at), Some(at));
        }
        match (centre, wheel) {
            (Some(at), Some(wheel)) => {
                is_to_scale = true;
                round(parts, at, *wheel);
            }
            (Some(at), None) if geared.contains(&body) => {
                is_to_scale = true;
                parts.add(SketchPart::Centre(at));
            }
            (Some(at), None) if model.frame.is_none() && slides(parts, at) => block(parts, body, at),
            (Some(at), None) => {
                match model.frame.is_some() && !is_outlined(parts, body) {
                    true if ellipsoid(parts, body, at) => is_to_scale = true,
                    _ => parts.add(SketchPart::Particle { at, colour: body }),
                }
                if model.frame.is_some() && model.inertia.is_some() {
                    parts.parts.retain(|part| *part != SketchPart::Particle { at, colour: body });
                    parts.add(SketchPart::Centre(at));
                }
            }
            (None, _) if !is_linked => untold.push(body),
            (None, _) => {}
        }
    }
    let is_flat = geometry.plane.is_some();
    let beside = is_flat && untold.len() > 1;
    let largest = untold.iter().filter_map(|body| shape(parts, *body)).map(|shape| longest(&shape)).fold(0.0, f64::max);
    for (number, &body) in untold.iter().enumerate() {
        let whole = if geometry.size > 0.0 { UNTOLD * geometry.size } else { 1.0 };
        let shift = if beside { 2.7 * whole * number as f64 } else { 0.0 };
        let right = right(parts);
        let at = parts.place(move |figure| figure.places[0] + shift * right);
        let share = shape(parts, body).map_or(1.0, |shape| (longest(&shape) / largest).clamp(0.45, 1.0));
        schematic(parts, body, at, whole * share);
        let below = -1.12 * whole * share * up(parts);
        let shifted = move |figure: &Figure| figure.places[0] + shift * right + below;
        parts.bodies[body] = Some(if is_flat { parts.place(shifted) } else { at });
        parts.middles[body] = Some(at);
    }
    let note = match (untold.is_empty(), beside, is_to_scale) {
        (true, ..) => "",
        (false, true, false) => NOT_TO_SCALE,
        (false, ..) => UNTOLD_SIZE,
    };
    frames_alone(parts);
    Drawn { is_to_scale, note }
}

/// Whether the drawn points of a body show its rotation: two points in a plane, three points in space that are not collinear.
fn is_outlined(parts: &Parts<'_>, body: usize) -> bool {
    let Some(figure) = parts.figures.first() else { return false };
    let mut links = parts.geometry.links.iter().filter(|link| link.bodies.contains(&body));
    let is_line = |places: &[usize]| {
        let way = |place: usize| figure.places[place] - figure.places[places[0]];
        let far = places.iter().map(|place| way(*place)).max_by(|a, b| a.norm().total_cmp(&b.norm()));
        let far = far.unwrap_or_default();
        places.iter().all(|place| far.cross(&way(*place)).norm() <= 1e-6 * far.norm_squared())
    };
    links.any(|link| parts.geometry.plane.is_some() || !is_line(&link.places))
}

/// The direction along which bodies without a position are placed side by side.
fn right(parts: &Parts<'_>) -> Vector3<f64> {
    match parts.geometry.plane {
        Some(normal) if normal.x.abs() > 0.5 => Vector3::y(),
        _ => Vector3::x(),
    }
}

/// The direction from a body to its name.
fn up(parts: &Parts<'_>) -> Vector3<f64> {
    match parts.geometry.plane {
        Some(normal) if normal.z.abs() < 0.5 => Vector3::z(),
        _ => Vector3::y(),
    }
}

fn mean(figure: &Figure, places: &[usize]) -> Vector3<f64> {
    let all: Vector3<f64> = places.iter().map(|place| figure.places[*place]).sum();
    all / places.len().max(1) as f64
}

/// Whether a body is drawn as a sliding block: a body on a line, without contacts, that does not fall freely along the line.
fn slides(parts: &Parts<'_>, at: usize) -> bool {
    let geometry = parts.geometry;
    let Some((_, along)) = geometry.slides.iter().find(|(place, _)| *place == at) else { return false };
    let gravity = parts.figures.first().map_or_else(Vector3::zeros, |figure| figure.gravity);
    let share = gravity.dot(along);
    let falls = share.abs() > 0.99 * gravity.norm() && share != 0.0;
    let is_held =
        geometry.elements.iter().map(|element| &element.ends).chain(&geometry.rods).any(|ends| ends.contains(&at))
            || geometry.links.iter().any(|link| link.places.contains(&at));
    let mut contacts = geometry.model.contacts.iter().filter(|contact| !contact.is_line);
    (is_held || !falls) && !contacts.any(|contact| geometry.first[contact.point.0] == at)
}

fn block(parts: &mut Parts<'_>, body: usize, at: usize) {
    let known = parts.geometry.slides.iter().find(|(place, _)| *place == at);
    let Some(&(_, along)) = known else { return };
    let along = parts.direction(move |_| along);
    parts.add(SketchPart::Guide { at, along });
    parts.add(SketchPart::Block { at, along, colour: body });
}

/// Draws a wheel as a circle about its axis, or a ball.
fn round(parts: &mut Parts<'_>, at: usize, wheel: Wheel) {
    let Wheel { body, radius, axis, turns, .. } = wheel;
    let frame = parts.geometry.model.bodies[body].frame.map_or(0, |frame| frame.0);
    let mut half = |k: usize| parts.direction(move |figure| radius * figure.frames[frame][k]);
    let axes = [half(0), half(1), half(2)];
    match (axis, parts.geometry.plane) {
        (Some(axis), _) => ring(parts, at, axes, axis, (body, turns)),
        (None, Some(normal)) => {
            let across = across(parts, frame, normal);
            ring(parts, at, axes, across, (body, turns));
        }
        (None, None) => (0..3).for_each(|axis| ring(parts, at, axes, axis, (body, turns && axis == 2))),
    }
    parts.add(SketchPart::Centre(at));
}

/// The index of the axis of a frame that is closest to the normal of the plane.
fn across(parts: &Parts<'_>, frame: usize, normal: Vector3<f64>) -> usize {
    let share =
        |axis: &usize| parts.figures.first().map_or(0.0, |figure| figure.frames[frame][*axis].dot(&normal).abs());
    (0..3).max_by(|a, b| share(a).total_cmp(&share(b))).unwrap_or(2)
}

/// Draws the section of an ellipsoid normal to one of its three half-axes.
pub fn ring(parts: &mut Parts<'_>, at: usize, axes: [usize; 3], across: usize, (colour, spoke): (usize, bool)) {
    let axes = [axes[(across + 1) % 3], axes[(across + 2) % 3]];
    parts.add(SketchPart::Ring { at, axes, colour, spoke });
}

/// The ellipsoid of inertia of a body at the first instant.
fn shape(parts: &Parts<'_>, body: usize) -> Option<Ellipsoid> {
    parts.geometry.ellipsoid(parts.figures.first()?, body)
}

fn longest(shape: &Ellipsoid) -> f64 {
    shape.lengths.iter().copied().fold(0.0, f64::max)
}

/// Draws the ellipsoid of inertia of a body with mass; returns false, and draws nothing, for other bodies.
fn ellipsoid(parts: &mut Parts<'_>, body: usize, at: usize) -> bool {
    let Some(shape) = shape(parts, body).filter(|shape| shape.has_mass) else { return false };
    rings(parts, body, at, shape, 1.0);
    true
}

/// Draws a body of unknown size with the shape of its ellipsoid of inertia.
fn schematic(parts: &mut Parts<'_>, body: usize, at: usize, size: f64) {
    let whole =
        Ellipsoid { axes: [Vector3::x(), Vector3::y(), Vector3::z()], lengths: [1.0, 1.0, 0.0], has_mass: false };
    let shape = shape(parts, body).unwrap_or(whole);
    let by = size / longest(&shape);
    rings(parts, body, at, shape, by);
}

/// Draws sections of an ellipsoid normal to its axes, scaled by the factor `by`, and for a motion in space the axes of its frame.
fn rings(parts: &mut Parts<'_>, body: usize, at: usize, shape: Ellipsoid, by: f64) {
    let Some(frame) = parts.geometry.model.bodies[body].frame.map(|frame| frame.0) else { return };
    let axes_frame = parts.geometry.inertia_frame(body).unwrap_or(frame);
    let Ellipsoid { axes, lengths, .. } = shape;
    let mut half = |k: usize| {
        let (axis, length) = (axes[k], by * lengths[k]);
        parts.direction(move |figure| {
            let along = (0..3).map(|j| axis[j] * figure.frames[axes_frame][j]).sum::<Vector3<f64>>();
            length * along
        })
    };
    let half_axes = [half(0), half(1), half(2)];
    match lengths.iter().position(|length| *length == 0.0) {
        Some(thin) => ring(parts, at, half_axes, thin, (body, true)),
        None => match parts.geometry.plane {
            Some(normal) => {
                let across = across(parts, axes_frame, normal);
                ring(parts, at, half_axes, across, (body, true));
            }
            None => (0..3).for_each(|axis| ring(parts, at, half_axes, axis, (body, false))),
        },
    }
    if parts.geometry.plane.is_none() {
        triad(parts, frame, at, (1.35 * by * longest(&shape), body));
    }
}

fn triad(parts: &mut Parts<'_>, frame: usize, at: usize, (length, colour): (f64, usize)) {
    let mut axis = |k: usize| parts.direction(move |figure| length * figure.frames[frame][k]);
    let axes = [axis(0), axis(1), axis(2)];
    parts.add(SketchPart::Triad { at, axes, colour });
}

/// Draws the frames of a system without other visible parts; only frames to which no other frame is attached.
fn frames_alone(parts: &mut Parts<'_>) {
    if !parts.parts.is_empty() {
        return;
    }
    let frames = &parts.geometry.model.frames;
    let is_parent = |frame: usize| frames.iter().any(|other| other.parent.is_some_and(|(parent, _)| parent.0 == frame));
    let last: Vec<usize> = (1..frames.len()).filter(|frame| !is_parent(*frame)).collect();
    for (colour, frame) in last.into_iter().enumerate() {
        let name = parts.geometry.model.frames[frame].name.clone();
        triad(parts, frame, 0, (1.0, colour));
        let beyond = parts.place(move |figure| figure.places[0] + 1.08 * figure.frames[frame][0]);
        parts.names.push((beyond, name));
    }
}
