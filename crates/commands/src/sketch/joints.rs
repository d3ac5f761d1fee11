//! Joints and loads in a sketch: pins, supports, rods, springs, dashpots, contact surfaces, forces.

use super::parts::Parts;
use ::scenes::geometry::{Joint, Rotary};
use charts::{SketchPart, SurfaceKind};
use model::geometry::Action;
use nalgebra::Vector3;

pub fn draw(parts: &mut Parts<'_>) {
    let geometry = parts.geometry;
    for element in &geometry.elements {
        parts.add(match element.action {
            Action::Elastic => SketchPart::Spring(element.ends),
            Action::Viscous => SketchPart::Dashpot(element.ends),
            Action::Field => SketchPart::Field(element.ends),
            Action::Given => SketchPart::Actuator(element.ends),
        });
    }
    geometry.rods.iter().for_each(|ends| parts.add(SketchPart::Rod(*ends)));
    for ends in &geometry.telescopes {
        parts.add(SketchPart::Telescope(*ends));
    }
    joined(parts);
    for touch in 0..parts.figures.first().map_or(0, |figure| figure.touches.len()) {
        let contact = &geometry.model.contacts[parts.figures[0].touches[touch].contact];
        let foot = parts.place(move |figure| {
            let touch = figure.touches[touch];
            figure.places[touch.point] - touch.gap * touch.normal
        });
        let normal = parts.direction(move |figure| figure.touches[touch].normal);
        let kind = match (geometry.planes[touch], contact.with) {
            (false, _) => SurfaceKind::Curve,
            (true, None) => SurfaceKind::Ground,
            (true, Some(_)) => SurfaceKind::Body,
        };
        if !contact.is_line {
            parts.add(SketchPart::Surface { at: foot, normal, kind });
        }
        rubbed(parts, touch);
    }
    rolled_on(parts);
    about_axes(parts);
    for force in 0..parts.figures.first().map_or(0, |figure| figure.forces.len()) {
        let acts = |figure: &scenes::geometry::Figure| is_seen(figure.forces[force].1);
        if parts.figures.iter().any(acts) {
            let at = geometry.first[parts.figures[0].forces[force].0];
            let along = parts.direction(move |figure| way(figure.forces[force].1));
            parts.add(SketchPart::Arrow { at, along });
        }
    }
}

/// Draws the friction force of a contact, at the point of contact of the body.
fn rubbed(parts: &mut Parts<'_>, touch: usize) {
    let acts = |figure: &scenes::geometry::Figure| is_seen(figure.touches[touch].friction);
    if parts.figures.iter().any(acts) {
        let at = parts.geometry.first[parts.figures[0].touches[touch].point];
        let along = parts.direction(move |figure| way(figure.touches[touch].friction));
        parts.add(SketchPart::Arrow { at, along });
    }
}

/// Draws torsion springs, rotary dashpots and torques.
fn about_axes(parts: &mut Parts<'_>) {
    let geometry = parts.geometry;
    for Rotary { joint, axis, action } in &geometry.rotaries {
        let at = middle(parts, joint);
        let [first, second] = joint.frames;
        let mut direction =
            |frame: usize, k: usize| parts.direction(move |figure| figure.frames[frame][(axis + k) % 3]);
        let axes = [direction(first, 1), direction(first, 2), direction(second, 1)];
        parts.add(match action {
            Action::Elastic | Action::Field => SketchPart::TorsionSpring { at, axes },
            Action::Viscous | Action::Given => SketchPart::RotaryDashpot { at, axes },
        });
    }
    for (number, joint) in geometry.couples.iter().enumerate() {
        let acts = |figure: &scenes::geometry::Figure| is_seen(figure.torques[number]);
        if parts.figures.iter().any(acts) {
            let at = middle(parts, joint);
            let along = parts.direction(move |figure| way(figure.torques[number]));
            parts.add(SketchPart::Torque { at, along });
        }
    }
}

/// The index of the point at which a joint is drawn: a point fixed in both frames, otherwise the midpoint of the bodies, otherwise the origin.
fn middle(parts: &mut Parts<'_>, joint: &Joint) -> usize {
    if let Some(spot) = joint.at {
        let is_place = spot.way == Vector3::zeros();
        return if is_place { spot.place } else { parts.place(move |figure| spot.in_figure(figure)) };
    }
    match joint.bodies.map(|body| parts.middles[body?]) {
        [Some(one), Some(other)] => parts.between(one, other),
        [one, other] => other.or(one).unwrap_or(0),
    }
}

/// The unit vector of a vector; zero where it has no direction.
fn way(vector: Vector3<f64>) -> Vector3<f64> {
    vector.try_normalize(0.0).filter(|_| is_seen(vector)).unwrap_or_default()
}

/// Whether a vector is finite and not zero.
fn is_seen(vector: Vector3<f64>) -> bool {
    vector.iter().any(|part| *part != 0.0) && vector.iter().all(|part| part.is_finite())
}

/// Draws the surfaces on which wheels roll by constraints.
fn rolled_on(parts: &mut Parts<'_>) {
    let geometry = parts.geometry;
    for wheel in &geometry.wheels {
        let (point, centre) = (geometry.first[wheel.point], geometry.centre(wheel.body));
        let has_contact = geometry.model.contacts.iter().any(|contact| geometry.first[contact.point.0] == point);
        let Some(centre) = centre.filter(|_| !has_contact) else { continue };
        let is_flat = geometry.plane.is_some();
        let normal = parts.direction(move |figure| {
            let arm = figure.places[centre] - figure.places[point];
            // in space the wheel may lean, and its surface is taken as horizontal
            if is_flat || figure.gravity == Vector3::zeros() { arm } else { -figure.gravity }
        });
        parts.add(SketchPart::Surface { at: point, normal, kind: SurfaceKind::Ground });
    }
}

/// Draws pins where parts are joined to each other or to the ground.
fn joined(parts: &mut Parts<'_>) {
    let geometry = parts.geometry;
    let links: Vec<&Vec<usize>> = geometry.links.iter().map(|link| &link.places).collect();
    let ends: Vec<usize> = geometry
        .elements
        .iter()
        .filter(|element| element.action != Action::Field)
        .map(|element| element.ends)
        .chain(geometry.rods.iter().copied())
        .flatten()
        .collect();
    for &place in &geometry.ground {
        let on_line = geometry.telescopes.iter().any(|ends| ends[0] == place);
        if links.iter().any(|link| link.contains(&place)) || ends.contains(&place) || on_line {
            parts.add(SketchPart::Support(place));
            parts.add(SketchPart::Pin(place));
        }
    }
    // pairs of points of two links that coincide at all instants, or that are one point
    let all: Vec<(usize, usize)> =
        links.iter().enumerate().flat_map(|(link, places)| places.iter().map(move |place| (link, *place))).collect();
    for (number, &(link, place)) in all.iter().enumerate() {
        let meets = all[..number]
            .iter()
            .any(|&(other, there)| other != link && (there == place || parts.coincide(there, place)));
        let on_block = geometry.slides.iter().any(|(block, _)| parts.coincide(*block, place));
        let is_rod = geometry.rods.iter().flatten().any(|end| *end == place);
        if meets || on_block || is_rod {
            parts.add(SketchPart::Pin(place));
        }
    }
}
